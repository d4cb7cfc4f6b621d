#pragma once

#include <compare>
#include <cstddef>
#include <map>
#include <span>
#include <vector>

#include "viewer/render/drawn_object.h"
#include "viewer/render/shader_program.h"
#include "viewer/render/surface_programs.h"

namespace kerf::render {

/// Draws the members of swarms: those of one swarm that look alike with one call, and their shadows with one.
class SwarmPass
{
public:
    /// @throws RenderError
    SwarmPass();

    /// Whether an object is drawn by this pass.
    static bool suits(const DrawnObject& object);

    /// Uploads where the members are. For once a frame, before the rest. O(members)
    void place(std::span<const DrawnObject> objects);

    /// Draws what throws shadows of the members. For a shadow map that is being filled.
    void draw_shadows(std::span<const DrawnObject> objects, const glm::mat4& projection, DrawStatistics& statistics);

    /// @param draws  of members
    /// @throws RenderError
    void draw_surfaces(std::span<const SurfaceDraw> draws, Lighting lighting, SurfacePrograms& programs,
                       DrawStatistics& statistics);

private:
    /// What members must have in common to be drawn with one call.
    struct Group
    {
        const SharedBuffers* buffers = nullptr;
        bool is_closed = false;
        std::uint32_t look = 0;
        TriangleKind kind = TriangleKind::surface;
        float pattern_scale = 1.0f;

        friend auto operator<=>(const Group&, const Group&) = default;
    };
    struct Members
    {
        SurfaceDraw first;  ///< of what all have in common
        IndexRuns runs;
    };
    using Groups = std::map<Group, Members>;

    static void append(const IndexRuns& runs, IndexRuns& all);
    void draw(const Group& group, const IndexRuns& runs, DrawStatistics& statistics) const;

    ShaderProgram depth_;
    GlBuffer models_;                                     ///< Swarm::kMostMembers matrices for each swarm
    std::map<const SharedBuffers*, std::size_t> swarms_;  ///< in this frame: which of those it has
};

}  // namespace kerf::render
