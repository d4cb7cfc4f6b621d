#include "common/sections/section_measures.h"

#include <glm/geometric.hpp>

#include "common/caps/section_area.h"
#include "common/geometry/dominant_axis.h"

namespace kerf::core {

namespace {

/// Calls visit(p, q) for the ends of each edge of a path.
template <class Visit>
void for_each_edge(const PlaneSection& section, const PlaneSection::Path& path, Visit&& visit)
{
    const auto points = section.points_of(path);
    for (std::size_t i = 0; i < path.edge_count; ++i) visit(points[i], points[i + 1 < points.size() ? i + 1 : 0]);
}

/// A sum of vectors that are no longer than `bound`.
class OrderlessVectorSum
{
public:
    explicit OrderlessVectorSum(double bound) : x_(bound), y_(bound), z_(bound) {}
    void add(const glm::dvec3& v)
    {
        x_.add(v.x);
        y_.add(v.y);
        z_.add(v.z);
    }
    glm::dvec3 value() const { return {x_.value(), y_.value(), z_.value()}; }

private:
    OrderlessSum x_, y_, z_;
};

/// Whether a point of the plane lies in a section's box. Asked in the two coordinates in which the section is widest: in
/// the third one it may have no extent but rounding. False of what is not a number, too: the quotient of nothing by
/// nothing.
bool lies_in(const Box& box, const glm::dvec3& p, const Plane& plane)
{
    const int dropped = dominant_axis(plane.normal);
    for (int axis = 0; axis < 3; ++axis)
        if (axis != dropped && !(double(box.lo[axis]) <= p[axis] && p[axis] <= double(box.hi[axis]))) return false;
    return true;
}

}  // namespace

SectionMeasures measure_section(const Plane& plane, PlaneSection& section)
{
    SectionMeasures measures;
    for (const glm::vec3& p : section.points) measures.box.add(p);
    if (section.points.empty()) return measures;

    // About a corner of the box, so that a section far from the origin loses no digits.
    const glm::dvec3 origin(measures.box.lo);
    const double size = glm::length(glm::dvec3(measures.box.hi) - origin);
    // The sum of a triangle's corners is at most two sizes long, and its normal two squares of them.
    OrderlessVectorSum area_moment(4.0 * size * size * size), length_moment(2.0 * size * size);
    OrderlessSum all_twice_area(2.0 * size * size), all_length(size);
    for (PlaneSection::Path& path : section.paths) {
        OrderlessSum twice_area(2.0 * size * size), length(size);
        for_each_edge(section, path, [&](const glm::vec3& p, const glm::vec3& q) {
            const glm::dvec3 from = glm::dvec3(p) - origin, to = glm::dvec3(q) - origin;
            const double edge_length = glm::length(to - from);
            length.add(edge_length);
            length_moment.add(edge_length * (from + to));
            if (!path.closed) return;
            const double edge_area = glm::dot(plane.normal, glm::cross(from, to));
            twice_area.add(edge_area);
            area_moment.add(edge_area * (from + to));
        });
        path.length = length.value();
        path.area = 0.5 * twice_area.value();
        all_twice_area.add(twice_area.value());
        all_length.add(length.value());
    }
    measures.length = all_length.value();
    measures.centroid = origin + area_moment.value() / (3.0 * all_twice_area.value());
    if (!lies_in(measures.box, measures.centroid, plane))
        measures.centroid = origin + length_moment.value() / (2.0 * measures.length);
    if (!lies_in(measures.box, measures.centroid, plane)) measures.centroid = measures.box.centre();
    return measures;
}

}  // namespace kerf::core
