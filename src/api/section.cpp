#include <kerf/section.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "api/no_memory.h"
#include "api/section_maker.h"
#include "common/cutting/back_end_helpers.h"
#include "common/mesh/plane_frame.h"
#include "common/mesh/plane_noise.h"
#include "common/sections/section_measures.h"

namespace kerf {

static_assert(sizeof(SectionEdge) == sizeof(core::PlaneSection::Edge) &&
              alignof(SectionEdge) == alignof(core::PlaneSection::Edge));

namespace {

/// Cosine of the angle between a plane's normal and z: of planes that are more level than this y points upwards.
constexpr double kNearlyLevel = 0.9;

SectionFrame frame_of(const core::Plane& plane, const std::optional<Vec3d>& up)
{
    const bool is_level = std::abs(plane.normal.z) > kNearlyLevel;
    const core::PlaneFrame frame =
        core::PlaneFrame::upright(plane.normal, up ? to_core(*up) : glm::dvec3(0.0, is_level, !is_level));
    return {to_public(plane.normal * plane.offset), to_public(frame.u), to_public(frame.v), to_public(plane.normal),
            plane.offset};
}

CutStatistics statistics_of(const Object& object, const core::PlaneSection& found)
{
    CutStatistics statistics;
    statistics.triangles = object.triangle_count();
    statistics.crossing_triangles = found.crossing_triangles;
    statistics.nodes_visited = found.nodes_visited;
    statistics.triangles_touched = found.triangles_touched;
    for (const core::PlaneSection::Path& path : found.paths)
        ++(path.closed ? statistics.section_loops : statistics.open_chains);
    return statistics;
}

}  // namespace

const char* SectionMaker::fault_of(const Object& object, const SectionOptions& options)
{
    if (object.is_empty()) return "the object is empty: it was cut, or moved from";
    if (options.up) {
        const auto& [x, y, z] = *options.up;
        if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z) || (x == 0.0 && y == 0.0 && z == 0.0))
            return "the direction that points upwards must be finite and longer than 0";
    }
    if (options.fill && !has_cap_quality(options.fill_quality))
        return "this program has no Delaunay triangulation: link Kerf's component caps_cgal, or ask for fast triangles";
    return nullptr;
}

Status SectionMaker::refuse(Section& section, Status status, const char* refusal)
{
    clear(section);
    section.refusal_ = refusal;
    return section.status = status;
}

Status SectionMaker::fill(const Object& object, const core::Plane& plane, const SectionOptions& options,
                          SectionScratch* scratch, Section& section, const InStack* in_stack) noexcept
{
    clear(section);
    const Status status = answer_or(Status::out_of_memory,
                                    [&] { return fill_clear(object, plane, options, scratch, section, in_stack); });
    return status == Status::out_of_memory ? refuse(section, status, "") : status;
}

void SectionMaker::clear(Section& section)
{
    Section::Data* const data = std::exchange(section.data_, nullptr);
    section = Section();
    section.data_ = data;
    if (data == nullptr) return;
    data->found.clear();
    data->parents.clear();
    data->corners.clear();
    data->statistics = {};
}

/// May throw std::bad_alloc.
Status SectionMaker::fill_clear(const Object& object, const core::Plane& plane, const SectionOptions& options,
                                SectionScratch* scratch, Section& section, const InStack* in_stack)
{
    if (section.data_ == nullptr) section.data_ = new Section::Data;
    Section::Data& data = *section.data_;
    core::PlaneSection& found = data.found;
    // What the back end needs can be as large as the mesh: many sections share it.
    if (scratch != nullptr) found.scratch = std::move(scratch->of_back_end);
    found.wants_ends = options.attributes;
    section.status = to_public(in_stack != nullptr ? core::section(in_stack->search, in_stack->number, found)
                                                   : core::section(*object.inside(), plane, found));
    if (scratch != nullptr) scratch->of_back_end = std::move(found.scratch);
    section.side_of_object = to_public(found.side_of_object);
    section.frame = frame_of(plane, options.up);
    data.statistics = statistics_of(object, found);
    if (!ok(section.status)) return section.status;

    const core::SectionMeasures measures = core::measure_section(plane, found);
    section.area = measures.area;
    section.length = measures.length;
    section.centroid = to_public(measures.centroid);
    section.bounds = to_public(measures.box);
    if (!options.nesting && !options.fill) return section.status;

    if (scratch == nullptr) {
        if (data.scratch == nullptr) data.scratch = std::make_unique<SectionScratch>();
        scratch = data.scratch.get();
    }
    const std::span<const std::uint32_t> parents = scratch->nesting.find(plane, found);
    data.parents.assign(parents.begin(), parents.end());
    if (options.fill) close(object, plane, options, *scratch, section);
    return section.status;
}

void SectionMaker::close(const Object& object, const core::Plane& plane, const SectionOptions& options,
                         SectionScratch& scratch, Section& section)
{
    Section::Data& data = *section.data_;
    const bool delaunay = options.fill_quality == CapQuality::delaunay;
    scratch.fill.close(plane, delaunay ? core::CapQuality::delaunay : core::CapQuality::fast, data.parents, data.found,
                       data.corners);
    const double noise = core::plane_noise(object.inside()->bounds().largest_coordinate());
    section.fill_exceeds_section =
        scratch.fill.excess() > 0.0 &&
        core::caps_exceed_section(scratch.fill.excess(), section.area, section.length, core::rounding_unit(noise));
}

Status section(const Object& object, const Plane& plane, Section& section, const SectionOptions& options) noexcept
{
    if (const char* fault = SectionMaker::fault_of(object, options))
        return SectionMaker::refuse(section, Status::invalid_argument, fault);
    return SectionMaker::fill(object, to_core(plane), options, nullptr, section);
}

Section section(const Object& object, const Plane& plane, const SectionOptions& options) noexcept
{
    Section result;
    static_cast<void>(section(object, plane, result, options));
    return result;
}

Vec2d SectionFrame::to_plane(Vec3d point) const noexcept
{
    return {x.x * point.x + x.y * point.y + x.z * point.z, y.x * point.x + y.y * point.y + y.z * point.z};
}

Vec3d SectionFrame::to_space(Vec2d place) const noexcept
{
    return {origin.x + place.x * x.x + place.y * y.x, origin.y + place.x * x.y + place.y * y.y,
            origin.z + place.x * x.z + place.y * y.z};
}

Section::Section() noexcept = default;

Section::Section(Section&& other) noexcept
{
    *this = std::move(other);
}

Section& Section::operator=(Section&& other) noexcept
{
    if (this == &other) return *this;
    status = std::exchange(other.status, Status::missed);
    side_of_object = std::exchange(other.side_of_object, Side::negative);
    area = std::exchange(other.area, 0.0);
    length = std::exchange(other.length, 0.0);
    centroid = std::exchange(other.centroid, {});
    bounds = std::exchange(other.bounds, {});
    frame = std::exchange(other.frame, {});
    fill_exceeds_section = std::exchange(other.fill_exceeds_section, false);
    delete std::exchange(data_, std::exchange(other.data_, nullptr));
    refusal_ = std::exchange(other.refusal_, "");
    return *this;
}

Section::~Section()
{
    delete data_;
}

const char* Section::reason() const noexcept
{
    switch (status) {
        case Status::invalid_argument:
            return refusal_;
        case Status::out_of_memory:
            return "there is not enough memory for the section; free some";
        default:
            return "";
    }
}

std::size_t Section::path_count() const noexcept
{
    return data_ == nullptr ? 0 : data_->found.paths.size();
}

SectionPath Section::path(std::size_t i) const noexcept
{
    if (i >= path_count()) return {};
    const core::PlaneSection& found = data_->found;
    const core::PlaneSection::Path& from = found.paths[i];
    SectionPath path;
    path.points = points().subspan(from.first_point, from.point_count);
    path.edges = {reinterpret_cast<const SectionEdge*>(found.edges.data()) + from.first_edge, from.edge_count};
    if (!found.ends.empty())
        path.ends = {reinterpret_cast<const DrawVertex*>(found.ends.data()) + 2 * from.first_edge, 2 * from.edge_count};
    path.first_edge = from.first_edge;
    path.area = from.area;
    path.length = from.length;
    path.parent = data_->parents.empty() ? kNone : data_->parents[i];
    path.solid = from.solid;
    path.is_closed = from.closed;
    return path;
}

std::span<const Vec3f> Section::points() const noexcept
{
    if (data_ == nullptr) return {};
    return {reinterpret_cast<const Vec3f*>(data_->found.points.data()), data_->found.points.size()};
}

std::span<const std::uint32_t> Section::triangles() const noexcept
{
    return data_ == nullptr ? std::span<const std::uint32_t>() : data_->corners;
}

std::size_t Section::stream_count() const noexcept
{
    return data_ == nullptr || data_->found.ends.empty() ? 0 : data_->found.end_streams.size();
}

Stream Section::stream(std::size_t i) const noexcept
{
    if (i >= stream_count()) return {};
    const core::PlaneSection::EndStream& stream = data_->found.end_streams[i];
    return {stream.name.c_str(), stream.width, stream.values};
}

const CutStatistics& Section::statistics() const noexcept
{
    static const CutStatistics none;
    return data_ == nullptr ? none : data_->statistics;
}

}  // namespace kerf
