#include "common/sections/section_measures.h"

#include <glm/geometric.hpp>

#include "common/caps/section_area.h"
#include "common/geometry/dominant_axis.h"

namespace kerf::core {

namespace {

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

double diagonal(const Box& box)
{
    return glm::length(glm::dvec3(box.hi) - glm::dvec3(box.lo));
}

glm::dvec3 centroid_of_outline(const PlaneSection& section, const glm::dvec3& origin, double size, double all_length)
{
    OrderlessVectorSum moment(2.0 * size * size);
    for (const PlaneSection::Path& path : section.paths)
        section.for_each_edge(path, [&](std::size_t, const glm::vec3& p, const glm::vec3& q) {
            const glm::dvec3 from = glm::dvec3(p) - origin, to = glm::dvec3(q) - origin;
            moment.add(glm::length(to - from) * (from + to));
        });
    return origin + moment.value() / (2.0 * all_length);
}

}  // namespace

SectionMeasures measure_section(const Plane& plane, PlaneSection& section)
{
    SectionMeasures measures;
    Box enclosed;
    for (const PlaneSection::Path& path : section.paths) {
        Box& box = path.closed ? enclosed : measures.box;
        for (const glm::vec3& p : section.points_of(path)) box.add(p);
    }
    measures.box.add(enclosed);
    if (measures.box.empty()) return measures;

    // About a corner of the box, as section_area() does, so that a section far from the origin loses no digits.
    if (enclosed.empty()) enclosed = measures.box;
    const glm::dvec3 origin(enclosed.lo);
    const double size = diagonal(measures.box);
    const OrderlessSum no_area = sum_of_twice_areas(enclosed), no_length(size);
    OrderlessSum all_twice_area = no_area, all_length = no_length;
    // The sum of an edge's ends is at most two sizes long, and twice its triangle's area two squares of them.
    OrderlessVectorSum area_moment(4.0 * size * size * size);
    for (PlaneSection::Path& path : section.paths) {
        OrderlessSum twice_area = no_area, length = no_length;
        section.for_each_edge(path, [&](std::size_t, const glm::vec3& p, const glm::vec3& q) {
            const glm::dvec3 from = glm::dvec3(p) - origin, to = glm::dvec3(q) - origin;
            length.add(glm::length(to - from));
            if (!path.closed) return;
            const double edge_area = glm::dot(plane.normal, glm::cross(from, to));
            twice_area.add(edge_area);
            area_moment.add(edge_area * (from + to));
        });
        path.length = length.value();
        path.area = 0.5 * twice_area.value();
        all_twice_area.add(twice_area);
        all_length.add(length);
    }
    measures.area = 0.5 * all_twice_area.value();
    measures.length = all_length.value();
    measures.centroid = origin + area_moment.value() / (3.0 * all_twice_area.value());
    if (!lies_in(measures.box, measures.centroid, plane))
        measures.centroid = centroid_of_outline(section, origin, size, measures.length);
    if (!lies_in(measures.box, measures.centroid, plane)) measures.centroid = measures.box.centre();
    return measures;
}

}  // namespace kerf::core
