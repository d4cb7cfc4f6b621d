#include <kerf/cut.h>

#include <cmath>
#include <new>
#include <utility>

#include "api/convert.h"
#include "api/cut_helpers.h"
#include "api/pieces.h"

namespace kerf {

/// What a Cut hides: the pieces of a cut, and those of further cuts that belong to it, one behind the other. So nothing
/// has to be allocated to bring together what is there.
struct Cut::Data
{
    Pieces positive, negative;
    CutStatistics statistics;
    Data* next = nullptr;

    Data() = default;
    Data(const Data&) = delete;
    Data& operator=(const Data&) = delete;
    /// One by one: there may be more than a stack has room for.
    ~Data()
    {
        for (Data* behind = std::exchange(next, nullptr); behind != nullptr;) {
            Data* const gone = std::exchange(behind, std::exchange(behind->next, nullptr));
            delete gone;
        }
    }

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

    /// One that was not made: the object comes back. `reason` is a literal.
    static Cut refused(Object&& object, const char* reason)
    {
        Cut result;
        result.status = Status::invalid_argument;
        result.object = std::move(object);
        result.refusal_ = reason;
        return result;
    }

    /// The pieces of `more` belong to `cut`, too.
    static void append(Cut& cut, Cut&& more)
    {
        Cut::Data* const added = std::exchange(more.data_, nullptr);
        added->next = std::exchange(cut.data_->next, added);
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
    inside.cap_quality =
        options.cap_quality == CapQuality::delaunay ? core::CapQuality::delaunay : core::CapQuality::fast;
    if (options.only)
        inside.only = core::OnlyNear{to_core(options.only->point), options.only->extent == OnlyNear::Extent::solid
                                                                       ? core::OnlyNear::Extent::solid
                                                                       : core::OnlyNear::Extent::region};
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

/// The lower half of a blade with a width: `piece` lies below the upper one. What of it is below the lower one stays
/// where it is, or is appended to `result`. Returns false if memory runs out; the piece is whole then.
bool cut_below(Object& piece, const Plane& lower, const CutOptions& options, Cut& result) noexcept
{
    Cut below = cut_once(std::move(piece), lower, options);
    if (below.status == Status::missed) {
        if (below.side_of_object == Side::negative) piece = std::move(below.object);
        return true;
    }
    if (!ok(below.status)) {
        piece = std::move(below.object);
        return false;
    }
    add(result.data()->statistics, below.statistics());
    result.caps_exceed_section |= below.caps_exceed_section;
    if (below.status == Status::open_section) result.status = below.status;
    below.data()->positive.take({});
    CutMaker::append(result, std::move(below));
    return true;
}

/// What lies between the planes is thrown away.
Cut cut_with_gap(Object&& object, const Plane& plane, const CutOptions& options) noexcept
{
    const std::optional<Plane> upper = plane.moved(0.5 * options.gap), lower = plane.moved(-0.5 * options.gap);
    if (!upper || !lower)
        return CutMaker::refused(std::move(object), "a side of the gap is beyond the range of double");
    Cut result = cut_once(std::move(object), *upper, options);
    if (result.status == Status::missed && result.side_of_object == Side::negative) {
        const CutStatistics above = result.statistics();
        result = cut_once(std::move(result.object), *lower, options);
        if (result.data() != nullptr) add(result.data()->statistics, above);
        if (result.status == Status::missed && result.side_of_object == Side::positive) {
            result.object = Object();
            result.status = Status::done;
        }
        if (ok(result.status)) result.data()->positive.take({});
        return result;
    }
    if (!ok(result.status)) return result;
    for (Object& piece : result.data()->negative.all())
        if (!cut_below(piece, *lower, options, result)) {
            result.status = Status::out_of_memory;
            break;
        }
    result.data()->negative.drop_empty();
    return result;
}

}  // namespace

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

const char* fault_of_cut(const Object& object, const CutOptions& options)
{
    if (object.is_empty()) return "the object is empty: it was cut, or moved from";
    if (!std::isfinite(options.gap) || options.gap < 0.0) return "the gap must be a finite width, 0 or more";
    if (!std::isfinite(options.cap_uv_scale)) return "the uv scale of caps must be finite";
    if (!has_cap_quality(options.cap_quality))
        return "this program has no Delaunay triangulation: link Kerf's component caps_cgal, or ask for fast caps";
    if (options.only) {
        const auto& [x, y, z] = options.only->point;
        if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z)) return "the point where to cut must be finite";
        if (options.gap != 0.0) return "a cut at one place has no gap: set `only` or `gap`";
    }
    return nullptr;
}

bool has_cap_quality(CapQuality quality) noexcept
{
    return quality == CapQuality::fast ||
           (quality == CapQuality::delaunay && core::can_close(core::CapQuality::delaunay));
}

Cut cut(Object&& object, const Plane& plane, const CutOptions& options) noexcept
{
    if (const char* fault = fault_of_cut(object, options)) return CutMaker::refused(std::move(object), fault);
    if (options.gap == 0.0) return cut_once(std::move(object), plane, options);
    return cut_with_gap(std::move(object), plane, options);
}

Cut cut_copy(const Object& object, const Plane& plane, const CutOptions& options) noexcept
{
    if (const char* fault = fault_of_cut(object, options)) return CutMaker::refused({}, fault);
    Result<Object> copy = object.clone();
    if (!copy) {
        Cut result;
        result.status = copy.status();
        return result;
    }
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
        case Status::not_separated:
            return "not_separated";
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
      data_(std::exchange(other.data_, nullptr)),
      refusal_(other.refusal_)
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
    refusal_ = taken.refusal_;
    return *this;
}

Cut::~Cut()
{
    delete data_;
}

const char* Cut::reason() const noexcept
{
    switch (status) {
        case Status::invalid_argument:
            return refusal_;
        case Status::out_of_memory:
            return "there is not enough memory to cut it; divide it or free some";
        case Status::not_separated:
            return "a cut there alone would not part the object: what lies on both sides of it is connected elsewhere";
        default:
            return "";
    }
}

std::size_t Cut::count(Side side) const noexcept
{
    std::size_t count = 0;
    for (Data* data = data_; data != nullptr; data = data->next) count += data->of(side).all().size();
    return count;
}

Object* Cut::piece(Side side, std::size_t i) noexcept
{
    for (Data* data = data_; data != nullptr; data = data->next) {
        const std::span<Object> pieces = data->of(side).all();
        if (i < pieces.size()) return &pieces[i];
        i -= pieces.size();
    }
    return nullptr;
}

Object* Cut::one(Side side) noexcept
{
    Object* most = nullptr;
    for (Data* data = data_; data != nullptr; data = data->next)
        for (Object& piece : data->of(side).all())
            if (most == nullptr || piece.triangle_count() > most->triangle_count()) most = &piece;
    return most;
}

const CutStatistics& Cut::statistics() const noexcept
{
    static const CutStatistics none;
    return data_ == nullptr ? none : data_->statistics;
}

}  // namespace kerf
