#pragma once

#include <kerf/section.h>

#include <optional>
#include <string>
#include <vector>

#include "viewer/inside/moving_plane.h"

namespace kerf::inside {

/// What it costs to ask for a section.
struct SectionCost
{
    double cpu_ms = 0.0;  ///< of this thread: the section with its nesting and its triangles
    double contours_cpu_ms = 0.0;
};

/// A model that is looked into: the section at its plane, and contours of what is left behind it, if they are wanted.
/// Nothing is ever cut.
class Study
{
public:
    /// @param name    of the model
    /// @param object  prepared, by any back end
    Study(std::string name, Object object);

    MovingPlane& plane() { return plane_; }
    const MovingPlane& plane() const { return plane_; }
    void show_contours(bool on);
    bool shows_contours() const { return shows_contours_; }

    /// Asks for the section at the plane, unless the plane has not moved. Returns whether it has asked.
    bool update();

    const std::string& name() const { return name_; }
    Object& object() { return object_; }
    const Object& object() const { return object_; }
    const Section& section() const { return section_; }
    /// Of planes at even distances behind the plane; none unless they are shown.
    std::span<const Section> contours() const { return contours_.all(); }
    const SectionCost& cost() const { return cost_; }

private:
    void ask_for_contours(const Plane& plane);

    std::string name_;
    Object object_;
    MovingPlane plane_;
    std::optional<Plane> asked_;  ///< the plane of what is there
    bool shows_contours_ = false;
    Section section_;
    SectionStack contours_;
    std::vector<double> heights_;
    SectionCost cost_;
};

}  // namespace kerf::inside
