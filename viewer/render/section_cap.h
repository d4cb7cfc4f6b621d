#pragma once

#include <kerf/section.h>

#include <cstdint>

#include "viewer/render/fragment_store.h"

namespace kerf::render {

/// What closes a section that is looked at: its triangles, brought onto the graphics card anew whenever the plane has
/// moved.
class SectionCap
{
public:
    explicit SectionCap(LookTable& looks) : looks_(looks) {}

    /// Takes the triangles of a section that has them (SectionOptions::fill). The cap faces the plane's positive side and
    /// looks as a cap of the object would. O(k).
    /// @throws RenderError  the graphics card has no memory left
    void set(const Object& object, const Section& section);

    /// Nothing, if there are no triangles.
    const DrawnFragment* drawn() const { return drawn_.triangles == 0 ? nullptr : &drawn_; }
    std::uint64_t bytes() const { return bytes_; }  ///< of the last one

private:
    LookTable& looks_;
    DrawnFragment drawn_;
    std::vector<DrawVertex> vertices_;  ///< used again and again
    std::uint64_t bytes_ = 0;
};

}  // namespace kerf::render
