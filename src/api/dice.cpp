#include <kerf/dice.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "api/cut_helpers.h"
#include "api/no_memory.h"

namespace kerf {

namespace {

using Cell = std::vector<std::uint32_t>;

struct DicedPiece
{
    Object object;
    Cell cell;
};

}  // namespace

/// What a Dice hides.
struct Dice::Data
{
    std::vector<DicedPiece> pieces;
    CutStatistics statistics;
};

struct DiceMaker
{
    static Dice refused(Status status, const char* refusal = "")
    {
        Dice dice;
        dice.status_ = status;
        dice.refusal_ = refusal;
        return dice;
    }

    /// One that has no pieces yet. May throw std::bad_alloc.
    static Dice begun()
    {
        Dice dice;
        dice.data_ = new Dice::Data;
        return dice;
    }

    static Dice::Data& data(Dice& dice) { return *dice.data_; }
    static Status& status(Dice& dice) { return dice.status_; }
    static void warn_of_caps(Dice& dice) { dice.caps_exceed_section_ = true; }
    static void count_empty(Dice& dice, std::uint64_t cells) { dice.empty_cells_ = cells; }
};

namespace {

/// Planes of one direction, from the lowest to the highest.
using Layers = std::vector<Plane>;

/// Part of an object that planes may divide still.
struct Task
{
    Object object;
    Cell cell;                        ///< in the directions that are done
    std::size_t first = 0, last = 0;  ///< planes of the next direction that may meet it
    double share = 1.0;               ///< of the work
};

class Dicer
{
public:
    Dicer(std::vector<Layers> directions, const DiceOptions& options, Dice& dice)
        : directions_(std::move(directions)), options_(options), dice_(dice)
    {
    }

    /// May throw std::bad_alloc.
    Status run(Object&& object)
    {
        if (!goes_on()) return Status::cancelled;
        begin({std::move(object), {}, 0, 0, 1.0});
        while (!tasks_.empty()) {
            Task task = std::move(tasks_.back());
            tasks_.pop_back();
            const Status status = divide(std::move(task));
            if (!ok(status)) return status;
            if (!goes_on()) return Status::cancelled;
        }
        finish();
        done_ = 1.0;
        return goes_on() ? DiceMaker::status(dice_) : Status::cancelled;
    }

private:
    bool goes_on() const
    {
        return options_.progress == nullptr || options_.progress(options_.user, std::min(done_, 1.0));
    }

    /// A task in the next direction that has planes, or a piece if there is none.
    void begin(Task&& task)
    {
        while (task.cell.size() < directions_.size() && directions_[task.cell.size()].empty()) task.cell.push_back(0);
        if (task.cell.size() == directions_.size()) {
            done_ += task.share;
            DiceMaker::data(dice_).pieces.push_back({std::move(task.object), std::move(task.cell)});
            return;
        }
        task.first = 0;
        task.last = directions_[task.cell.size()].size();
        tasks_.push_back(std::move(task));
    }

    /// The part of a task that lies in the layers between two planes of its direction.
    void go_on_with(Object&& object, const Task& task, std::size_t first, std::size_t last, double share)
    {
        Task next{std::move(object), task.cell, first, last, share};
        if (first < last) {
            tasks_.push_back(std::move(next));
            return;
        }
        next.cell.push_back(static_cast<std::uint32_t>(first));
        begin(std::move(next));
    }

    Status divide(Task&& task)
    {
        const Layers& planes = directions_[task.cell.size()];
        const std::size_t middle = task.first + (task.last - task.first) / 2;
        Cut cut = kerf::cut(std::move(task.object), planes[middle], options_.cut);
        if (cut.status == Status::missed) {
            if (cut.side_of_object == Side::negative)
                go_on_with(std::move(cut.object), task, task.first, middle, task.share);
            else
                go_on_with(std::move(cut.object), task, middle + 1, task.last, task.share);
            return Status::done;
        }
        if (!ok(cut.status)) return cut.status;
        if (cut.status == Status::open_section) DiceMaker::status(dice_) = cut.status;
        if (cut.caps_exceed_section) DiceMaker::warn_of_caps(dice_);
        add(DiceMaker::data(dice_).statistics, cut.statistics());
        double triangles = 0.0;
        for_each_piece(cut, [&](Side, Object& piece) { triangles += double(piece.triangle_count()); });
        if (triangles == 0.0) done_ += task.share;  // the gap has taken all of it
        for_each_piece(cut, [&](Side side, Object& piece) {
            const double share = task.share * double(piece.triangle_count()) / triangles;
            if (side == Side::negative)
                go_on_with(std::move(piece), task, task.first, middle, share);
            else
                go_on_with(std::move(piece), task, middle + 1, task.last, share);
        });
        return Status::done;
    }

    template <class Visit>
    static void for_each_piece(Cut& cut, Visit visit)
    {
        for (const Side side : {Side::positive, Side::negative})
            for (std::size_t i = 0; Object* const piece = cut.piece(side, i); ++i) visit(side, *piece);
    }

    /// Sorts the pieces by their cells, and counts the cells that have none.
    void finish()
    {
        std::vector<DicedPiece>& pieces = DiceMaker::data(dice_).pieces;
        std::stable_sort(pieces.begin(), pieces.end(),
                         [](const DicedPiece& a, const DicedPiece& b) { return a.cell < b.cell; });
        double cells = 1.0;
        for (const Layers& planes : directions_) cells *= double(planes.size() + 1);
        std::uint64_t used = 0;
        for (std::size_t i = 0; i < pieces.size(); ++i) used += i == 0 || pieces[i].cell != pieces[i - 1].cell ? 1 : 0;
        // Of more cells than a number can count there are as many as it can.
        constexpr double kMost = 0x1p63;
        DiceMaker::count_empty(dice_,
                               (cells < kMost ? static_cast<std::uint64_t>(cells) : std::uint64_t(kMost)) - used);
    }

    const std::vector<Layers> directions_;
    const DiceOptions& options_;
    Dice& dice_;
    std::vector<Task> tasks_;
    double done_ = 0.0;
};

/// What is wrong with the planes, or null.
const char* fault_of(std::span<const DicePlanes> planes)
{
    for (const DicePlanes& family : planes) {
        if (!Plane::at(Point(0, 0, 0), family.normal)) return "a normal of the planes must have a direction";
        if (!std::ranges::all_of(family.heights, [](double height) { return std::isfinite(height); }))
            return "the heights of the planes must be finite";
    }
    return nullptr;
}

std::vector<Layers> directions_of(std::span<const DicePlanes> planes)
{
    std::vector<Layers> directions;
    for (const DicePlanes& family : planes) {
        std::vector<double> heights(family.heights.begin(), family.heights.end());
        std::sort(heights.begin(), heights.end());
        const Plane level = *Plane::at(Point(0, 0, 0), family.normal);
        Layers& layers = directions.emplace_back();
        for (const double height : heights)
            if (const std::optional<Plane> plane = level.moved(height)) layers.push_back(*plane);
    }
    return directions;
}

}  // namespace

Dice dice(Object&& object, std::span<const DicePlanes> planes, const DiceOptions& options) noexcept
{
    if (const char* fault = fault_of(planes)) return DiceMaker::refused(Status::invalid_argument, fault);
    if (const char* fault = fault_of_cut(object, options.cut))
        return DiceMaker::refused(Status::invalid_argument, fault);
    if (options.cut.only)
        return DiceMaker::refused(Status::invalid_argument, "dicing cuts everywhere: do not set `only`");
    Object taken = std::move(object);
    return answer_or(DiceMaker::refused(Status::out_of_memory), [&] {
        Dice dice = DiceMaker::begun();
        DiceMaker::data(dice).statistics.triangles = taken.triangle_count();
        const Status status = Dicer(directions_of(planes), options, dice).run(std::move(taken));
        return ok(status) ? std::move(dice) : DiceMaker::refused(status);
    });
}

std::uint32_t cuts_expected(std::span<const DicePlanes> planes) noexcept
{
    std::uint32_t looks = 0;
    for (const DicePlanes& family : planes) looks += static_cast<std::uint32_t>(std::bit_width(family.heights.size()));
    return looks;
}

Dice::Dice() noexcept = default;

Dice::Dice(Dice&& other) noexcept
{
    *this = std::move(other);
}

Dice& Dice::operator=(Dice&& other) noexcept
{
    if (this == &other) return *this;
    delete std::exchange(data_, std::exchange(other.data_, nullptr));
    status_ = std::exchange(other.status_, Status::done);
    caps_exceed_section_ = std::exchange(other.caps_exceed_section_, false);
    empty_cells_ = std::exchange(other.empty_cells_, 0);
    refusal_ = std::exchange(other.refusal_, "");
    return *this;
}

Dice::~Dice()
{
    delete data_;
}

const char* Dice::reason() const noexcept
{
    switch (status_) {
        case Status::invalid_argument:
            return refusal_;
        case Status::cancelled:
            return "the caller asked to stop; there are no pieces";
        case Status::out_of_memory:
            return "there is not enough memory for the pieces; dice by fewer planes at a time";
        default:
            return "";
    }
}

std::size_t Dice::count() const noexcept
{
    return data_ == nullptr ? 0 : data_->pieces.size();
}

Object* Dice::piece(std::size_t i) noexcept
{
    return i < count() ? &data_->pieces[i].object : nullptr;
}

std::span<const std::uint32_t> Dice::cell(std::size_t i) const noexcept
{
    if (i >= count()) return {};
    return data_->pieces[i].cell;
}

const CutStatistics& Dice::statistics() const noexcept
{
    static const CutStatistics none;
    return data_ == nullptr ? none : data_->statistics;
}

}  // namespace kerf
