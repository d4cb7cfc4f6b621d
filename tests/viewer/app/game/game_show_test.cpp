#include "viewer/app/game/game_show.h"

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <thread>

#include "viewer/app/user_interface.h"
#include "viewer/game/game_scene.h"
#include "viewer/game/giant_scene.h"
#include "viewer/render/gl_test.h"
#include "viewer/ui/menu_scene.h"

namespace kerf::test {

using app::GameShow;
using app::ShowSetup;
using ui::MenuKey;
using ui::Screen;

namespace {

/// The game without a window, with a folder of its own for scores and settings.
class GameShowTest : public GlTest
{
protected:
    GameShowTest()
    {
        std::string pattern = (std::filesystem::temp_directory_path() / "kerf_show_XXXXXX").string();
        folder = ::mkdtemp(pattern.data());
    }
    ~GameShowTest() override { std::filesystem::remove_all(folder); }

    ShowSetup setup(const std::string& scene = "menu") const
    {
        ShowSetup setup;
        setup.data_folder = KERF_DATA_DIR;
        setup.user_folder = folder;
        setup.scene = scene;
        setup.fixed_step = true;
        setup.boulder = 2000;
        return setup;
    }

    /// Draws a picture and gives what its texts cover.
    ui::Box2 picture(GameShow& show, int width, int height, bool with_stage = true)
    {
        if (with_stage) {
            painter.resize(width, height);
            show.paint({});
        }
        interface.use_game_letters(width, height);
        interface.begin(width, height, 1.0 / 60.0);
        ui::Canvas canvas(interface.letters(), {width, height});
        show.write(canvas);
        interface.draw();
        return canvas.reach();
    }

    void frames(GameShow& show, int count, bool with_pictures = false)
    {
        for (int i = 0; i < count; ++i) {
            show.advance(1.0 / 60.0);
            if (with_pictures) picture(show, 192, 108);
        }
    }

    void choose(GameShow& show, const std::string& label)
    {
        const auto& items = show.screens().items();
        const bool is_menu = show.screens().screen() == Screen::menu;
        for (std::size_t i = 0; i < 2 * items.size() && items[show.screens().selected()].label != label; ++i) {
            if (is_menu) show.press(MenuKey::right);
            if (!is_menu || i == items.size()) show.press(MenuKey::down);
        }
        ASSERT_EQ(items[show.screens().selected()].label, label);
        show.press(MenuKey::accept);
    }

    /// In the picture that was drawn last.
    void click(GameShow& show, const ui::Box2& box, const glm::vec2& size)
    {
        using Kind = app::WindowPointer::Kind;
        for (const Kind kind : {Kind::move, Kind::press, Kind::release})
            show.point({kind, glm::dvec2(box.middle())}, size);
        frames(show, 1);
    }

    /// From the first frame of a balance to the last in which nothing on it can be chosen.
    void expect_balance_is_read_first(GameShow& show)
    {
        using Kind = app::WindowPointer::Kind;
        ASSERT_EQ(show.screens().screen(), Screen::over);
        picture(show, 1280, 720, false);
        const glm::dvec2 again(show.hotspots().at(0).box.middle());
        const std::string scene = show.scene();
        for (double shown = 0.0; shown < GameShow::kBalanceShown - 1.0 / 60.0; shown += 1.0 / 60.0) {
            show.point({Kind::press, again}, {1280.0f, 720.0f});
            show.point({Kind::release, again}, {1280.0f, 720.0f});
            show.press(MenuKey::accept);
            show.press(MenuKey::back);
            show.play_again();
            ASSERT_EQ(show.screens().screen(), Screen::over) << "after " << shown << " s";
            frames(show, 1);
        }
        // A swipe that goes on beyond that, and ends on the button.
        show.point({Kind::press, again}, {1280.0f, 720.0f});
        frames(show, 2);
        show.point({Kind::release, again}, {1280.0f, 720.0f});
        EXPECT_EQ(show.screens().screen(), Screen::over);
        EXPECT_EQ(show.scene(), scene);
    }

    void expect_texts_fit(GameShow& show, const std::string& what)
    {
        for (const glm::ivec2 size :
             {glm::ivec2(1280, 720), glm::ivec2(3840, 2160), glm::ivec2(700, 1200), glm::ivec2(2560, 600)}) {
            const ui::Box2 reach = picture(show, size.x, size.y, false);
            EXPECT_LT(reach.low.x, reach.high.x) << what << " says nothing";
            const ui::Box2 whole{{0.0f, 0.0f}, glm::vec2(size)};
            EXPECT_TRUE(whole.holds(reach)) << what << " at " << size.x << "x" << size.y << ": " << reach.low.x << ","
                                            << reach.low.y << " to " << reach.high.x << "," << reach.high.y;
        }
    }

    std::filesystem::path folder;
    app::Painter painter{320, 180};
    app::UserInterface interface {
        1.0f
    };
    sound::Speaker speaker = sound::Speaker::silent();
};

}  // namespace

TEST_F(GameShowTest, DrawsNinetyFramesOfEverySceneAndScreen)
{
    for (const char* scene : {"menu", "classic", "arcade", "zen", "duel"}) {
        GameShow show(setup(scene), painter, speaker);
        frames(show, 90, true);
        EXPECT_EQ(show.scene(), scene);
    }
    GameShow show(setup("zen"), painter, speaker);
    for (const Screen screen : {Screen::paused, Screen::settings, Screen::scores, Screen::over, Screen::menu}) {
        show.show_screen(screen);
        frames(show, 18, true);
    }
}

TEST_F(GameShowTest, AllTextsFitIntoTheSmallAndTheLargePicture)
{
    {
        GameShow show(setup(), painter, speaker);
        frames(show, 30);
        expect_texts_fit(show, "menu");
        show.show_screen(Screen::scores);
        expect_texts_fit(show, "scores");
        show.show_screen(Screen::settings);
        expect_texts_fit(show, "settings");
    }
    {
        GameShow show(setup("arcade"), painter, speaker);
        frames(show, 100);
        expect_texts_fit(show, "arcade");
        show.show_screen(Screen::paused);
        expect_texts_fit(show, "pause");
        show.show_screen(Screen::over);
        expect_texts_fit(show, "game over");
    }
    GameShow show(setup("duel"), painter, speaker);
    frames(show, 60);
    expect_texts_fit(show, "duel");
}

TEST_F(GameShowTest, AScoreOfAnyLengthStaysOnItsCard)
{
    // The largest number that is read from a file.
    std::ofstream(folder / "scores.json")
        << R"({"format": "kerf-scores", "version": 1, "modes": {"classic": [{"score": 9223372036854775807,
               "date": "2026-11-21T15:08:00Z", "backend": "halfedge", "seed": 7, "fruit": 9, "longest_combo": 5}]}})";
    GameShow show(setup(), painter, speaker);
    ASSERT_EQ(show.files().best(game::GameMode::classic), 9223372036854775807);
    show.show_screen(Screen::scores);
    const ui::Box2 reach = picture(show, 1280, 720, false);
    constexpr float kHalfACard = 510.0f;
    EXPECT_GT(reach.low.x, 640.0f - kHalfACard * interface.letters().unit);
}

TEST_F(GameShowTest, EveryGameIsReachedAndLeftByKeyboardAlone)
{
    GameShow show(setup(), painter, speaker);
    for (const char* title : {"Classic", "Arcade", "Zen", "Duel"}) {
        frames(show, 2);
        choose(show, title);
        frames(show, 60);
        EXPECT_EQ(show.screens().screen(), Screen::play) << title;
        EXPECT_EQ(ui::find_mode(show.scene())->title, title);
        show.press(MenuKey::back);
        EXPECT_EQ(show.screens().screen(), Screen::paused);
        choose(show, "Menu");
        EXPECT_EQ(show.scene(), "menu");
    }
    choose(show, "Quit");
    EXPECT_TRUE(show.has_ended());
}

TEST_F(GameShowTest, EveryGameIsPausedAndLeftByMouseAlone)
{
    for (const char* scene : {"classic", "arcade", "zen", "giant", "duel"})
        for (const glm::ivec2 pixels : {glm::ivec2(1280, 720), glm::ivec2(3840, 2160)}) {
            ShowSetup small = setup(scene);
            small.giant = 10'000;
            GameShow show(small, painter, speaker);
            frames(show, 10);
            const glm::vec2 size(pixels);
            picture(show, pixels.x, pixels.y, false);
            ASSERT_EQ(show.hotspots().size(), 1u);
            EXPECT_TRUE((ui::Box2{{0.5f * size.x, 0.0f}, size}).holds(show.hotspots()[0].box));
            click(show, show.hotspots()[0].box, size);
            ASSERT_EQ(show.screens().screen(), Screen::paused) << scene;
            picture(show, pixels.x, pixels.y, false);
            ASSERT_EQ(show.screens().items().back().label, "Menu");
            click(show, show.hotspots().back().box, size);
            EXPECT_EQ(show.scene(), "menu") << scene;
        }
}

TEST_F(GameShowTest, APressOnAButtonIsNoSwipeAndASwipeAcrossAButtonPressesNothing)
{
    using Kind = app::WindowPointer::Kind;
    const glm::vec2 size(1280.0f, 720.0f);
    GameShow show(setup("classic"), painter, speaker);
    frames(show, 2);
    picture(show, 1280, 720, false);
    const glm::dvec2 button(show.hotspots().at(0).box.middle());
    show.point({Kind::press, button - glm::dvec2(200.0, 0.0)}, size);
    show.point({Kind::move, button}, size);
    frames(show, 1);
    EXPECT_EQ(show.screens().screen(), Screen::play);
    EXPECT_EQ(show.simulation()->blade().swipe(), 1u);
    show.point({Kind::release, button}, size);
    frames(show, 1);
    click(show, show.hotspots()[0].box, size);
    EXPECT_EQ(show.screens().screen(), Screen::paused);
    show.press(MenuKey::back);
    frames(show, 2);
    EXPECT_EQ(show.simulation()->blade().swipe(), 1u);
}

TEST_F(GameShowTest, TheGiantHasAButtonForEveryKeyThatItNames)
{
    ShowSetup small = setup("giant");
    small.giant = 10'000;
    GameShow show(small, painter, speaker);
    frames(show, 10);
    picture(show, 1280, 720, false);
    const auto giants = [&] { return game::giant_of(show.simulation()->scene())->state().giants; };
    const std::string before = show.simulation()->backend();
    const auto giants_before = giants();
    click(show, show.giant_buttons()[1], {1280.0f, 720.0f});
    frames(show, 2);
    EXPECT_GT(giants(), giants_before);
    EXPECT_EQ(show.simulation()->backend(), before);
    click(show, show.giant_buttons()[0], {1280.0f, 720.0f});
    frames(show, 2);
    EXPECT_NE(show.simulation()->backend(), before);
    EXPECT_EQ(show.simulation()->blade().swipe(), 0u);
    expect_texts_fit(show, "giant");
}

TEST_F(GameShowTest, FruitIsCutByKeyboardAlone)
{
    GameShow show(setup("zen"), painter, speaker);
    const auto cut = [&] { return game::game_of(show.simulation()->scene())->state().fruit_cut; };
    using Key = ui::BladeKey;
    // As a player who looks for a fruit, goes beside it and swipes through it.
    for (int i = 0; i < 900 && cut() == 0; ++i) {
        show.hold(Key::cut, false);
        const auto& bodies = show.simulation()->bodies();
        if (!bodies.empty()) {
            const glm::dvec2 aim = sim::Camera::seen_on_stage(bodies.front()->centre());
            const glm::dvec2 way = aim - show.keyboard_blade().place();
            show.hold(Key::right, way.x > 0.1);
            show.hold(Key::left, way.x < -0.1);
            show.hold(Key::up, way.y > 0.1);
            show.hold(Key::down, way.y < -0.1);
            show.hold(Key::cut, glm::length(way) < 2.0);
        }
        frames(show, 1);
    }
    EXPECT_GT(cut(), 0);
}

TEST_F(GameShowTest, APauseEndsTheKeyboardsSwipeAndTheMousePutsItsCrossAway)
{
    GameShow show(setup("zen"), painter, speaker);
    frames(show, 2);
    EXPECT_FALSE(show.keyboard_blade().is_shown());
    show.hold(ui::BladeKey::right, true);
    show.hold(ui::BladeKey::cut, true);
    frames(show, 3);
    EXPECT_TRUE(show.simulation()->blade().pressed());
    show.pause();
    frames(show, 2);
    show.hold(ui::BladeKey::cut, true);
    show.press(MenuKey::back);
    frames(show, 2);
    EXPECT_FALSE(show.simulation()->blade().pressed());
    EXPECT_TRUE(show.keyboard_blade().is_shown());
    show.hold(ui::BladeKey::cut, true);
    frames(show, 2);
    EXPECT_EQ(show.simulation()->blade().swipe(), 2u);
    show.point({app::WindowPointer::Kind::press, {400.0, 300.0}}, {1280.0f, 720.0f});
    frames(show, 2);
    EXPECT_FALSE(show.keyboard_blade().is_shown());
    EXPECT_EQ(show.simulation()->blade().swipe(), 3u) << "the mouse has a swipe of its own";
}

TEST_F(GameShowTest, CuttingAFruitOfTheMenuChoosesItsGame)
{
    for (std::size_t mode = 0; mode < 3; ++mode) {
        GameShow show(setup(), painter, speaker);
        frames(show, 2);
        // With the mouse, in pixels: from the lower left to the upper right of the fruit, within a tenth of a second.
        const glm::vec2 size(1280.0f, 720.0f);
        const sim::Camera camera(16.0 / 9.0);
        using Kind = app::WindowPointer::Kind;
        for (int i = 0; i <= 6; ++i) {
            const glm::dvec2 stage = ui::place_of_mode(mode) + (double(i) / 3.0 - 1.0) * glm::dvec2(1.7, 0.8);
            const glm::dvec2 pixel = camera.stage_to_screen(stage, glm::dvec2(size));
            show.point({i == 0 ? Kind::press : i == 6 ? Kind::release : Kind::move, pixel}, size);
            frames(show, 1);
        }
        frames(show, 60);
        EXPECT_EQ(show.scene(), ui::modes()[mode].scene);
    }
}

TEST_F(GameShowTest, ClickingAWordOfTheMenuChoosesItToo)
{
    GameShow show(setup(), painter, speaker);
    frames(show, 2);
    picture(show, 1280, 720);
    const glm::dvec2 below = ui::place_of_mode(2) - glm::dvec2(0.0, ui::kModeRadius + 0.3);
    const glm::dvec2 pixel = sim::Camera(16.0 / 9.0).stage_to_screen(below, {1280.0, 720.0});
    show.point({app::WindowPointer::Kind::press, pixel}, {1280.0f, 720.0f});
    show.point({app::WindowPointer::Kind::release, pixel}, {1280.0f, 720.0f});
    frames(show, 60);
    EXPECT_EQ(show.scene(), "zen");
}

TEST_F(GameShowTest, AGameThatIsPausedStandsStill)
{
    GameShow show(setup("classic"), painter, speaker);
    frames(show, 80);
    const std::uint64_t before = show.simulation()->state_hash();
    show.pause();
    frames(show, 30);
    EXPECT_EQ(show.simulation()->state_hash(), before);
    choose(show, "Settings");
    frames(show, 30);
    EXPECT_EQ(show.simulation()->state_hash(), before);
    show.press(MenuKey::back);
    choose(show, "Go on");
    frames(show, 1);
    EXPECT_NE(show.simulation()->state_hash(), before);
}

TEST_F(GameShowTest, APauseEndsTheSwipeAndNothingOfThePauseIsPlayedBack)
{
    using Kind = app::WindowPointer::Kind;
    const glm::vec2 size(1280.0f, 720.0f);
    GameShow show(setup("classic"), painter, speaker);
    frames(show, 80);
    show.point({Kind::press, {300.0, 360.0}}, size);
    show.point({Kind::move, {310.0, 360.0}}, size);
    frames(show, 1);
    ASSERT_TRUE(show.simulation()->blade().pressed());
    show.pause();
    frames(show, 1);
    for (int i = 0; i < 20; ++i) show.point({Kind::move, {310.0 + 40.0 * i, 300.0 - 10.0 * i}}, size);
    show.press(MenuKey::back);
    frames(show, 1);
    EXPECT_FALSE(show.simulation()->blade().pressed());
    const double farthest = sim::Camera(16.0 / 9.0).screen_to_stage({311.0, 360.0}, glm::dvec2(size)).x;
    for (const sim::TrailPoint& point : show.simulation()->blade().trail(show.simulation()->time()))
        EXPECT_LT(point.position.x, farthest);
}

TEST_F(GameShowTest, NoFuseHissesDuringAPause)
{
    GameShow show(setup("classic"), painter, speaker);
    game::Autopilot autopilot(1);  // keeps the game going until there is a bomb
    for (int i = 0; i < 3600 && !speaker.fuse_burns(); ++i) {
        show.let_play(autopilot);
        frames(show, 1);
    }
    ASSERT_TRUE(speaker.fuse_burns());
    show.pause();
    frames(show, 1);
    EXPECT_FALSE(speaker.fuse_burns());
    show.press(MenuKey::back);
    frames(show, 1);
    EXPECT_TRUE(speaker.fuse_burns());
}

TEST_F(GameShowTest, ASwipeAcrossTheMiddleOfADuelStaysInItsHalf)
{
    using Kind = app::WindowPointer::Kind;
    const glm::vec2 size(1280.0f, 720.0f);
    GameShow show(setup("duel"), painter, speaker);
    frames(show, 10);
    double before = -100.0;
    for (int i = 0; i <= 8; ++i) {
        show.point({i == 0 ? Kind::press : Kind::move, {480.0 + 40.0 * i, 360.0}}, size);
        frames(show, 1);
        const auto trail = show.duel()->duel().blade().trail(show.duel()->duel().time());
        ASSERT_FALSE(trail.empty());
        EXPECT_GT(trail.back().position.x, before) << "the blade turned back at " << 480 + 40 * i;
        before = trail.back().position.x;
    }
}

TEST_F(GameShowTest, SettingsAreThereInTheNextProgram)
{
    {
        GameShow show(setup(), painter, speaker);
        show.show_screen(Screen::settings);
        for (int i = 0; i < 4; ++i) show.press(MenuKey::left);
        show.press(MenuKey::down);
        show.press(MenuKey::right);
    }
    GameShow show(setup(), painter, speaker);
    EXPECT_NEAR(show.settings().volume, 0.5, 1e-9);
    EXPECT_TRUE(show.settings().mute);
    EXPECT_TRUE(speaker.muted());
}

TEST_F(GameShowTest, AGameThatIsLeftKeepsItsScore)
{
    std::int64_t score = 0;
    {
        GameShow show(setup("classic"), painter, speaker);
        game::Autopilot autopilot(1);
        const auto state = [&] { return game::game_of(show.simulation()->scene())->state(); };
        for (int i = 0; i < 1200 && state().score == 0; ++i) {
            show.let_play(autopilot);
            frames(show, 1);
        }
        score = state().score;
        ASSERT_GT(score, 0);
        show.press(MenuKey::back);
        choose(show, "Menu");
        EXPECT_EQ(show.files().best(game::GameMode::classic), score);
        EXPECT_EQ(show.files().scores_of(game::GameMode::classic).size(), 1u);
    }
    EXPECT_EQ(game::HighScores(folder).best(game::GameMode::classic), score);
}

TEST_F(GameShowTest, SaysThatTheSoundIsOffForSomeSeconds)
{
    GameShow show(setup(), painter, speaker);
    show.toggle_mute();
    frames(show, 60);
    EXPECT_EQ(show.message(), "Sound off");
    frames(show, 400);
    EXPECT_EQ(show.message(), "");
}

TEST_F(GameShowTest, SaysOfEveryDamagedFileThatItIs)
{
    for (const char* name : {"scores.json", "settings.json"}) std::ofstream(folder / name) << "{ torn";
    GameShow show(setup(), painter, speaker);
    std::set<std::string> said;
    for (int i = 0; i < 900; ++i) {
        frames(show, 1);
        for (const char* name : {"scores.json", "settings.json"})
            if (show.message().find(name) != std::string::npos) said.insert(name);
    }
    EXPECT_EQ(said, (std::set<std::string>{"scores.json", "settings.json"}));
    EXPECT_EQ(show.message(), "");
}

TEST_F(GameShowTest, AMessageIsShownWholeHoweverLongItIs)
{
    GameShow show(setup(), painter, speaker);
    show.tell("/home/somebody/" + std::string(300, 'x') + "/scores.json cannot be written: no space left on device");
    expect_texts_fit(show, "message");
    interface.begin(1280, 720, 1.0 / 60.0);
    const ui::Canvas canvas(interface.letters(), {1280.0f, 720.0f});
    for (const float width : {20.0f, 300.0f, 1100.0f}) {
        const std::string text = "a few words and \u00e4\u00f6\u00fc" + std::string(200, 'x') + " more of them";
        const std::string lines = canvas.wrapped(text, 24.0f, width);
        EXPECT_LE(canvas.measure(lines, 24.0f).x, width);
        const auto letters = [](std::string s) {
            std::erase_if(s, [](char c) { return c == ' ' || c == '\n'; });
            return s;
        };
        EXPECT_EQ(letters(lines), letters(text));
    }
    EXPECT_EQ(canvas.wrapped("short", 24.0f, 300.0f), "short");
    interface.draw();
}

TEST_F(GameShowTest, AGameThatIsLostLeadsToItsBalanceAndFromThereToTheNext)
{
    GameShow show(setup("classic"), painter, speaker);
    // Nobody cuts: three misses end it.
    for (int i = 0; i < 2400 && show.screens().screen() != Screen::over; ++i) frames(show, 1);
    ASSERT_EQ(show.screens().screen(), Screen::over);
    expect_texts_fit(show, "balance");
    frames(show, 60);
    choose(show, "Play again");
    EXPECT_EQ(show.screens().screen(), Screen::play);
    EXPECT_LT(show.simulation()->now(), 3);
}

TEST_F(GameShowTest, ABalanceIsNotThrownAwayByWhoStillSwipesOrCutsWithSpace)
{
    GameShow show(setup("classic"), painter, speaker);
    for (int i = 0; i < 2400 && show.screens().screen() != Screen::over; ++i) frames(show, 1);
    expect_balance_is_read_first(show);
    show.press(MenuKey::accept);
    EXPECT_EQ(show.screens().screen(), Screen::play);
}

TEST_F(GameShowTest, ALineIsChosenByPressingAndLettingGoOnIt)
{
    using Kind = app::WindowPointer::Kind;
    const glm::vec2 size(1280.0f, 720.0f);
    GameShow show(setup("zen"), painter, speaker);
    frames(show, 2);
    show.pause();
    picture(show, 1280, 720, false);
    const glm::dvec2 go_on(show.hotspots().at(0).box.middle()), menu(show.hotspots().back().box.middle());
    const auto drag = [&](const glm::dvec2& from, const glm::dvec2& to) {
        show.point({Kind::press, from}, size);
        show.point({Kind::move, to}, size);
        show.point({Kind::release, to}, size);
        frames(show, 1);
    };
    drag(menu, {5.0, 5.0});
    drag({5.0, 5.0}, menu);
    drag(menu, go_on);
    EXPECT_EQ(show.screens().screen(), Screen::paused);
    show.point({Kind::press, go_on}, size);
    show.press(MenuKey::back);
    show.pause();
    picture(show, 1280, 720, false);
    show.point({Kind::release, go_on}, size);
    EXPECT_EQ(show.screens().screen(), Screen::paused) << "what was pressed is another screen's";
    drag(go_on, go_on);
    EXPECT_EQ(show.screens().screen(), Screen::play);
}

TEST_F(GameShowTest, APressIsNotForTheScreenThatWasShownBefore)
{
    using Kind = app::WindowPointer::Kind;
    const glm::vec2 size(1280.0f, 720.0f);
    GameShow show(setup("zen"), painter, speaker);
    frames(show, 2);
    show.show_screen(Screen::over);
    picture(show, 1280, 720, false);
    const glm::dvec2 again(show.hotspots().at(0).box.middle());
    // All within a frame: the second press is where "Play again" was, and not on the button that pauses.
    for (const Kind kind : {Kind::press, Kind::release, Kind::press}) show.point({kind, again}, size);
    EXPECT_EQ(show.screens().screen(), Screen::play);
    frames(show, 1);
    EXPECT_TRUE(show.simulation()->blade().pressed()) << "it begins a swipe";
}

// In real time: no frame waits for the thread that makes the giant, and none uploads more of it than is allowed.
TEST_F(GameShowTest, AGiantArrivesWithoutHoldingUpAFrameAndShowsHowFarItIs)
{
    ShowSetup real_time = setup("giant");
    real_time.fixed_step = false;
    real_time.giant = 300'000;
    GameShow show(real_time, painter, speaker);
    const auto state = [&] { return game::giant_of(show.simulation()->scene())->state(); };
    const std::uint64_t budget = app::GpuWorld::kBytesInAFrame;
    std::uint64_t uploaded = 0;
    double progress = 0.0;
    int uploading = 0;
    for (int frame = 0; frame < 100'000 && !state().is_held; ++frame) {
        show.advance(1.0 / 60.0);
        if (state().is_held) break;
        show.sync();
        const std::uint64_t bytes = painter.world().store().bytes_uploaded();
        EXPECT_LE(bytes - uploaded, budget);
        if (bytes > uploaded) ++uploading;
        uploaded = bytes;
        ASSERT_TRUE(show.giant_progress());
        EXPECT_GE(*show.giant_progress(), progress);
        progress = *show.giant_progress();
        std::this_thread::sleep_for(std::chrono::microseconds(500));
    }
    ASSERT_TRUE(state().is_held);
    EXPECT_EQ(progress, 1.0);
    EXPECT_GE(uploading, 3);
    EXPECT_GT(uploaded, 2 * budget);
    // It is seen in the frame in which it appears, and costs nothing more.
    show.sync();
    EXPECT_EQ(painter.world().store().bytes_uploaded(), uploaded);
    EXPECT_FALSE(show.giant_progress());
}

TEST_F(GameShowTest, FruitIsReadyBeforeItsFirstThrow)
{
    GameShow show(setup(), painter, speaker);
    frames(show, 3);
    choose(show, "Classic");
    frames(show, 600);
    ASSERT_EQ(show.scene(), "classic");
    ASSERT_FALSE(game::game_of(show.simulation()->scene())->events().empty());
    EXPECT_EQ(show.models().late_work().preparations, 0u);
}

TEST_F(GameShowTest, ShowsANewPlayerHowToCutUntilHeDoes)
{
    const auto is_shown = [](const GameShow& show) {
        return !show.demo_blade().trail(show.simulation()->time()).empty();
    };
    GameShow show(setup("zen"), painter, speaker);
    int shown = 0;
    for (int i = 0; i < 200; ++i) {
        frames(show, 1);
        shown += is_shown(show) ? 1 : 0;
    }
    EXPECT_GT(shown, 10);
    EXPECT_TRUE(show.simulation()->cuts().empty()) << "it is only shown";
    game::Autopilot autopilot(1);
    for (int i = 0; i < 200; ++i) {
        show.let_play(autopilot);
        frames(show, 1);
    }
    ASSERT_GT(game::game_of(show.simulation()->scene())->state().fruit_cut, 0);
    for (int i = 0; i < 200; ++i) {
        frames(show, 1);
        EXPECT_FALSE(is_shown(show));
    }
}

TEST_F(GameShowTest, ADuelEndsWithAResultAndLeadsToARematch)
{
    ShowSetup small = setup("duel");
    small.boulder = 1000;
    GameShow show(small, painter, speaker);
    game::Autopilot autopilot(1);
    for (int i = 0; i < 4000 && show.screens().screen() == Screen::play; ++i) {
        show.let_play(autopilot);
        frames(show, 1);
    }
    ASSERT_EQ(show.screens().screen(), Screen::over);
    EXPECT_GE(show.duel()->now(), duel::TimetableScene::kLength);
    EXPECT_LE(show.duel()->now(), duel::TimetableScene::kLength + 2);
    for (const duel::Score& score : show.duel()->scores()) EXPECT_GE(score.cuts, 20u) << score.backend;
    expect_texts_fit(show, "duel's end");
    expect_balance_is_read_first(show);
    show.play_again();
    EXPECT_EQ(show.screens().screen(), Screen::play);
    EXPECT_EQ(show.scene(), "duel");
    EXPECT_EQ(show.duel()->now(), 0);
    show.play_again();
    EXPECT_EQ(show.screens().screen(), Screen::play) << "only a game that is over begins anew";
}

TEST_F(GameShowTest, ADuelGivesTheSameStatesEveryTime)
{
    std::array<std::uint64_t, 2> hashes{};
    for (int run = 0; run < 2; ++run) {
        GameShow show(setup("duel"), painter, speaker);
        std::vector<sim::InputEvent> swipe{{2'150'000, sim::InputKind::press, {-6.5, 1.7}, {}}};
        for (int i = 1; i < 20; ++i)
            swipe.push_back({2'150'000 + 5000 * i, sim::InputKind::move, {-6.5 + 0.65 * i, 1.8}, {}});
        swipe.push_back({2'250'000, sim::InputKind::release, {6.5, 1.9}, {}});
        show.push(swipe);
        frames(show, 150);
        for (std::size_t i = 0; i < 2; ++i) {
            const sim::Simulation& half = show.duel()->duel().half(i).simulation();
            EXPECT_EQ(half.now(), 300);
            EXPECT_GE(half.cuts().size(), 1u);
            if (run == 1) {
                EXPECT_EQ(half.state_hash(), hashes[i]);
            }
            hashes[i] = half.state_hash();
        }
    }
    EXPECT_NE(hashes[0], hashes[1]) << "each half names its back end";
}

}  // namespace kerf::test
