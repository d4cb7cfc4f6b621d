#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>

#include "viewer/render/fragment_store.h"

namespace kerf::render {

/// One object of a frame.
struct DrawnObject
{
    std::uint32_t id = 0;  ///< what the inspection pass writes; 0 is the background's
    const DrawnFragment* fragment = nullptr;
    glm::mat4 model{1.0f};  ///< mesh coordinates to world: turned, moved, scaled alike in all directions; no mirror
    float pattern_scale = 1.0f;  ///< 1 / size of the object before any cut, so that patterns stay where they are
    /// Cut from a mesh without boundary. Of such an object only what faces the eye is drawn: its back is never seen,
    /// and where caps lie on one another, facing either way, rounding must not choose between them.
    bool is_closed = false;
    bool is_clipped = false;  ///< what lies beyond DrawOptions::clip is not drawn
    /// Not the cap of a clipped object: its needles would shade themselves, and the object's far side throws the same.
    bool throws_shadow = true;
};

/// What of an object has one look: what is drawn with one call.
struct SurfaceDraw
{
    const DrawnObject* object = nullptr;
    const DrawBatch* batch = nullptr;
};

/// From now on what faces away is left out, if the object is closed, and what is clipped. end_culling() ends it.
/// @{
void cull_for(const DrawnObject& object);
void end_culling();
/// @}

/// What a frame cost in commands.
struct DrawStatistics
{
    std::uint64_t calls = 0;   ///< glMultiDrawElements
    std::uint64_t ranges = 0;  ///< in all of them
};

/// Draws runs of the index buffer whose vertex array is bound, and counts them.
void draw_runs(const IndexRuns& runs, DrawStatistics& statistics);

}  // namespace kerf::render
