#include <kerf/cut.h>

#include <algorithm>
#include <cmath>
#include <new>

#include "api/convert.h"
#include "api/no_memory.h"
#include "api/pieces.h"

namespace kerf {

/// What a Cut hides.
struct Cut::Data
{
    Pieces positive, negative;
    CutStatistics statistics;

    Pieces& of(Side side) { return side == Side::positive ? positive : negative; }
};

struct CutMaker
{
    /// Takes room for what a cut gives before it is made: afterwards nothing may fail.
    static bool make_room(Cut& cut)
    {
        cut.data_ = new (std::nothrow) Cut::Data;
        return cut.data_ != nullptr;
    }
};

namespace {

CutStatistics statistics_of(const core::CutStatistics& from)
{
    CutStatistics to;
    to.triangles = from.triangles;
    to.crossing_triangles = from.crossing_triangles;
    to.crossing_surface = from.crossing_surface;
    to.section_loops = from.section_loops;
    to.open_chains = from.open_chains;
    to.nodes_visited = from.nodes_visited;
    to.triangles_touched = from.triangles_touched;
    to.cap_steps = from.cap_steps;
    to.bytes_to_upload = from.bytes_to_upload;
    to.bytes_grown = from.bytes_grown;
    for (std::size_t i = 0; i < kPhaseCount; ++i) to.phase_ms[i] = from.phases.ms[i];
    return to;
}

void add(CutStatistics& sum, const CutStatistics& more)
{
    sum.crossing_triangles += more.crossing_triangles;
    sum.crossing_surface += more.crossing_surface;
    sum.section_loops += more.section_loops;
    sum.open_chains += more.open_chains;
    sum.nodes_visited += more.nodes_visited;
    sum.triangles_touched += more.triangles_touched;
    sum.cap_steps += more.cap_steps;
    sum.bytes_to_upload += more.bytes_to_upload;
    sum.bytes_grown += more.bytes_grown;
    for (std::size_t i = 0; i < kPhaseCount; ++i) sum.phase_ms[i] += more.phase_ms[i];
}

Cut not_cut(Object&& object, Status status) noexcept
{
    Cut result;
    result.status = status;
    result.object = std::move(object);
    return result;
}

/// Cuts by a blade without width. The object comes back in the result if it was not cut.
Cut cut_once(Object&& object, const Plane& plane, const CutOptions& options) noexcept
{
    Cut result;
    result.object = std::move(object);
    if (!CutMaker::make_room(result)) {
        result.status = Status::out_of_memory;
        return result;
    }
    core::CutOptions inside;
    inside.build_caps = options.cap;
    inside.split_components = options.components;
    inside.cap_material = options.cap_material;
    inside.cap_uv_scale = options.cap_uv_scale;
    core::CutResult found = core::cut(std::unique_ptr<core::Cuttable>(result.object.release()), to_core(plane), inside);
    result.object = Object(found.object.release());
    result.status = to_public(found.status);
    result.side_of_object = to_public(found.side_of_object);
    result.section_area = found.section_area;
    result.caps_exceed_section = found.caps_exceed_section;
    result.data()->statistics = statistics_of(found.statistics);
    result.data()->positive.take(std::move(found.positive));
    result.data()->negative.take(std::move(found.negative));
    return result;
}

/// The lower half of a blade with a width: `piece` lies below the upper one. Its pieces below the lower one join those
/// of `result`. Returns false if memory runs out; the piece is whole then.
bool cut_below(Object& piece, const Plane& lower, const CutOptions& options, Cut& result)
{
    Cut below = cut_once(std::move(piece), lower, options);
    if (below.status == Status::out_of_memory) {
        piece = std::move(below.object);
        return false;
    }
    if (below.status == Status::missed) {
        if (below.side_of_object == Side::negative) result.data()->negative.gather(std::move(below.object));
        return true;
    }
    for (Object& part : below.data()->negative.all()) result.data()->negative.gather(std::move(part));
    add(result.data()->statistics, below.statistics());
    result.caps_exceed_section |= below.caps_exceed_section;
    if (below.status == Status::open_section) result.status = below.status;
    return true;
}

/// What lies between the planes is thrown away.
Cut cut_with_gap(Object&& object, const Plane& plane, const CutOptions& options)
{
    const std::optional<Plane> upper = plane.moved(0.5 * options.gap), lower = plane.moved(-0.5 * options.gap);
    if (!upper || !lower) return not_cut(std::move(object), Status::invalid_argument);
    Cut result = cut_once(std::move(object), *upper, options);
    if (result.status == Status::missed && result.side_of_object == Side::negative) {
        result = cut_once(std::move(result.object), *lower, options);
        if (result.status == Status::missed && result.side_of_object == Side::positive) {
            result.object = Object();
            result.status = Status::done;
        }
        if (ok(result.status)) result.data()->positive.take({});
        return result;
    }
    if (!ok(result.status)) return result;
    std::vector<Object> above_lower;
    for (Object& piece : result.data()->negative.all()) above_lower.push_back(std::move(piece));
    result.data()->negative.take({});
    for (Object& piece : above_lower)
        if (!cut_below(piece, *lower, options, result)) {
            result.status = Status::out_of_memory;
            for (Object& rest : above_lower)
                if (!rest.is_empty()) result.data()->negative.gather(std::move(rest));
            break;
        }
    return result;
}

bool is_valid(const CutOptions& options)
{
    return std::isfinite(options.cap_uv_scale) && std::isfinite(options.gap) && options.gap >= 0.0;
}

}  // namespace

Cut cut(Object&& object, const Plane& plane, const CutOptions& options) noexcept
{
    if (object.is_empty() || !is_valid(options)) return not_cut(std::move(object), Status::invalid_argument);
    if (options.gap == 0.0) return cut_once(std::move(object), plane, options);
    Cut result;
    result.status = Status::out_of_memory;
    return answer_or(std::move(result), [&] { return cut_with_gap(std::move(object), plane, options); });
}

Cut cut_copy(const Object& object, const Plane& plane, const CutOptions& options) noexcept
{
    Result<Object> copy = object.clone();
    if (!copy) return not_cut({}, copy.status());
    Cut result = cut(*std::move(copy), plane, options);
    result.object = Object();
    return result;
}

const char* outcome_name(Status status) noexcept
{
    switch (status) {
        case Status::done:
            return "cut";
        case Status::missed:
            return "missed";
        case Status::open_section:
            return "open_section";
        case Status::invalid_argument:
            return "invalid_argument";
        case Status::invalid_mesh:
            return "invalid_mesh";
        case Status::out_of_memory:
            return "out_of_memory";
        case Status::cancelled:
            return "cancelled";
        case Status::unusable_file:
            return "unusable_file";
    }
    return "unknown";
}

Cut::Cut() noexcept = default;

Cut::Cut(Cut&& other) noexcept
    : status(other.status),
      side_of_object(other.side_of_object),
      object(std::move(other.object)),
      section_area(other.section_area),
      caps_exceed_section(other.caps_exceed_section),
      data_(std::exchange(other.data_, nullptr))
{
}

Cut& Cut::operator=(Cut&& other) noexcept
{
    Cut taken(std::move(other));
    status = taken.status;
    side_of_object = taken.side_of_object;
    object = std::move(taken.object);
    section_area = taken.section_area;
    caps_exceed_section = taken.caps_exceed_section;
    std::swap(data_, taken.data_);
    return *this;
}

Cut::~Cut()
{
    delete data_;
}

std::size_t Cut::count(Side side) const noexcept
{
    return data_ == nullptr ? 0 : data_->of(side).all().size();
}

Object* Cut::piece(Side side, std::size_t i) noexcept
{
    return i < count(side) ? &data_->of(side).all()[i] : nullptr;
}

Object* Cut::one(Side side) noexcept
{
    if (count(side) == 0) return nullptr;
    const std::span<Object> all = data_->of(side).all();
    return &*std::max_element(all.begin(), all.end(),
                              [](const Object& a, const Object& b) { return a.triangle_count() < b.triangle_count(); });
}

const CutStatistics& Cut::statistics() const noexcept
{
    static const CutStatistics none;
    return data_ == nullptr ? none : data_->statistics;
}

}  // namespace kerf
