#include "viewer/app/game/duel_view.h"

#include <algorithm>

#include "viewer/app/game/stone_asteroid.h"
#include "viewer/sim/back_ends.h"
#include "viewer/ui/hud.h"
#include "viewer/ui/texts.h"

namespace kerf::app {

namespace {

/// What a picture waits for the halves, so that an ordinary cut is seen in the frame in which it was made.
constexpr std::chrono::milliseconds kPatience{4};

/// Half the diagonal of what is thrown, metres: large enough to be seen in half a picture.
constexpr double kBoulderRadius = 2.3, kFruitRadius = 1.5;

std::array<std::string, 2> opponents(const std::vector<std::string>& wanted)
{
    const std::string& usual = sim::backend_names().front();
    if (wanted.size() >= 2) return {wanted[0], wanted[1]};
    if (wanted.size() == 1 && wanted[0] != usual) return {usual, wanted[0]};
    return {usual, sim::known_back_end("baseline")};
}

std::size_t index_of(const sim::ModelLibrary& models, std::string_view name)
{
    std::size_t index = 0;
    while (index < models.size() && models.model(index).name != name) ++index;
    return index;
}

std::string boulder_name(std::int64_t triangles)
{
    return "boulder " + std::to_string(triangles);
}

std::size_t add_boulder(sim::ModelLibrary& models, std::int64_t triangles)
{
    const std::string name = boulder_name(triangles);
    const std::size_t known = index_of(models, name);
    if (known < models.size()) return known;
    return models.add(name, stone_asteroid(static_cast<std::uint64_t>(triangles), 5), true);
}

/// Boulder and fruit in turn, prepared for both. @param steps  counts DuelView::kSteps
std::vector<duel::TimetableScene::Item> prepare_all(sim::ModelLibrary& models, std::int64_t triangles,
                                                    const std::array<std::string, 2>& opponents, sim::ProxyKind proxy,
                                                    std::atomic<int>& steps)
{
    const std::size_t boulder = add_boulder(models, triangles);
    ++steps;
    std::vector<duel::TimetableScene::Item> thrown;
    for (const std::string_view fruit : {"watermelon", "pineapple", "coconut", "orange"}) {
        thrown.push_back({boulder, kBoulderRadius});
        if (const std::size_t index = index_of(models, fruit); index < models.size())
            thrown.push_back({index, kFruitRadius});
    }
    for (const std::string& backend : opponents) {
        for (const duel::TimetableScene::Item& item : thrown) models.prepare(item.model, backend);
        ++steps;
        models.stock(boulder, backend, proxy);
        ++steps;
    }
    return thrown;
}

}  // namespace

DuelView::DuelView(std::shared_ptr<sim::ModelLibrary> models, const sim::Settings& settings, std::int64_t triangles,
                   const std::vector<std::string>& wanted)
    : models_(std::move(models)),
      settings_(settings),
      triangles_(triangles),
      opponents_(opponents(wanted)),
      prepared_(std::make_shared<std::atomic<int>>(0)),
      preparing_(std::async(std::launch::async,
                            [library = models_, triangles, both = opponents_, proxy = settings.proxy,
                             steps = prepared_] { return prepare_all(*library, triangles, both, proxy, *steps); }))
{
}

DuelView::~DuelView()
{
    ends_ = true;
    if (stocking_.joinable()) stocking_.join();
}

void DuelView::wait_until_ready()
{
    if (preparing_.valid()) preparing_.wait();
    ready();
}

bool DuelView::ready()
{
    if (duel_) return true;
    if (preparing_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return false;
    const std::vector<duel::TimetableScene::Item> thrown = preparing_.get();
    duel_ = std::make_unique<duel::Duel>(models_, settings_, opponents_,
                                         [&] { return std::make_unique<duel::TimetableScene>(thrown); });
    stocking_ = std::thread([this, boulder = thrown.front().model] {
        while (!ends_) {
            for (const std::string& backend : opponents_) models_->stock(boulder, backend, settings_.proxy);
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
        }
    });
    return true;
}

bool DuelView::is_over()
{
    if (!duel_ || duel_->now() < duel::TimetableScene::kLength) return false;
    return duel_->half(0).done() == duel_->now() && duel_->half(1).done() == duel_->now();
}

std::array<duel::Score, 2> DuelView::scores()
{
    if (!duel_) return {};
    return {duel_->score(0), duel_->score(1)};
}

void DuelView::advance(sim::Tick ticks, const std::vector<sim::InputEvent>& events, bool waits)
{
    if (!ready()) return;
    duel_->advance(ticks, events);
    if (waits)
        duel_->finish();
    else
        duel_->wait_for(kPatience);
}

void DuelView::sync(Painter& painter)
{
    if (!duel_) return;
    for (std::size_t i = 0; i < worlds_.size(); ++i) {
        if (!worlds_[i]) worlds_[i] = std::make_unique<GpuWorld>(painter.looks());
        if (!duel_->half(i).idle()) continue;
        const sim::Simulation& simulation = duel_->half(i).simulation();
        effects_[i].follow(simulation);
        worlds_[i]->sync(simulation);
        objects_[i] = worlds_[i]->objects(simulation);
    }
}

std::array<StagePicture, 2> DuelView::stages(int width, int height) const
{
    std::array<StagePicture, 2> stages;
    for (int i = 0; i < 2; ++i) {
        StagePicture& stage = stages[static_cast<std::size_t>(i)];
        const int left = i * width / 2;
        stage.area = {left, 0, std::max((i + 1) * width / 2 - left, 1), std::max(height, 1)};
        if (!duel_) continue;
        stage.objects = objects_[static_cast<std::size_t>(i)];
        stage.effects = &effects_[static_cast<std::size_t>(i)];
        stage.blade = &duel_->blade();
        stage.now = duel_->time();
    }
    return stages;
}

void DuelView::write_score(ui::Canvas& canvas, std::size_t half)
{
    const float u = canvas.unit();
    const ui::Box2 box = layout().box(half, canvas.size());
    const float middle = box.middle().x;
    const duel::Score score = duel_->score(half);
    const duel::Score other = duel_->score(1 - half);
    const bool leads = score.cut_ms <= other.cut_ms;
    // One flat line: what flies is seen up to its apex.
    const std::string sum = ui::milliseconds_text(score.cut_ms);
    const std::string rest = std::to_string(score.cuts)
                                 .append(score.cuts == 1 ? " cut, longest " : " cuts, longest ")
                                 .append(ui::milliseconds_text(score.worst_ms));
    constexpr float kName = 20.0f, kSum = 30.0f, kRest = 16.0f;
    const float gap = 16.0f * u, y = 25.0f * u;
    const float widths[]{canvas.measure(score.backend, kName).x, canvas.measure(sum, kSum).x,
                         canvas.measure(rest, kRest).x};
    float x = middle - 0.5f * (widths[0] + widths[1] + widths[2] + 2.0f * gap);
    canvas.card({{x - gap, y - 19.0f * u}, {x + widths[0] + widths[1] + widths[2] + 3.0f * gap, y + 19.0f * u}}, 0.34f);
    canvas.text({x, y}, {0.0f, 0.5f}, score.backend, kName, ui::kPaper);
    x += widths[0] + gap;
    canvas.text({x, y}, {0.0f, 0.5f}, sum, kSum, score.cuts == 0 ? ui::kDim : leads ? ui::kLead : ui::kDanger);
    x += widths[1] + gap;
    canvas.text({x, y}, {0.0f, 0.5f}, rest, kRest, ui::kPaper);
    // A frame or two is how a frame is made; more is a hitch.
    constexpr double kShownFrom = 60.0;
    if (score.behind_ms > kShownFrom)
        canvas.text({middle, canvas.size().y - 70.0f * u}, {0.5f, 0.5f},
                    ui::milliseconds_text(score.behind_ms).append(" behind"), 34.0f, ui::kDanger);
}

void DuelView::write(ui::Canvas& canvas)
{
    const float u = canvas.unit();
    const glm::vec2 size = canvas.size();
    canvas.fill({{0.5f * size.x - 1.5f * u, 0.0f}, {0.5f * size.x + 1.5f * u, size.y}}, ui::kInk, 0.9f);
    if (!duel_) {
        canvas.text({0.5f * size.x, 0.5f * size.y}, {0.5f, 0.5f},
                    "Preparing a boulder of " + ui::number_text(triangles_) + " triangles for both", 30.0f, ui::kPaper);
        canvas.bar({{0.5f * size.x - 160.0f * u, 0.5f * size.y + 36.0f * u},
                    {0.5f * size.x + 160.0f * u, 0.5f * size.y + 48.0f * u}},
                   static_cast<float>(progress()), ui::kAccent);
        return;
    }
    const sim::Tick left = std::max<sim::Tick>(duel::TimetableScene::kLength - now(), 0);
    canvas.text({0.5f * size.x, 6.0f * u}, {0.5f, 0.0f}, ui::clock_text(double(left) * sim::kTickSeconds), 40.0f,
                left < 10 * sim::kTicksPerSecond ? ui::kDanger : ui::kPaper);
    for (std::size_t half = 0; half < 2; ++half) {
        ui::show_effects(canvas, effects_[half], layout().box(half, size));
        write_score(canvas, half);
    }
    if (now() < 4 * sim::kTicksPerSecond)
        canvas.text({0.5f * size.x, size.y - 24.0f * u}, {0.5f, 1.0f},
                    "One swipe cuts both: same throws, same planes. The numbers are what cutting took.   Esc: pause",
                    24.0f, ui::kPaper);
}

}  // namespace kerf::app
