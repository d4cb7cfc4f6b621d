#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "viewer/render/drawn_object.h"

namespace kerf::render {

/// Specks of each look, with few triangles, with many, and as members of a swarm, so that they are shaded in all ways. Drivers translate a program
/// when it is drawn with first, for the state that it is drawn in, and their memory grows with the first frame of many
/// draws: that must not be the frame in which something breaks. Draw these once where nobody sees it.
class Rehearsal
{
public:
    /// @param surfaces     indices into the LookTable, of materials' surfaces
    /// @param caps         of their caps
    /// @param most_pieces  into how many something breaks; fewer than Swarm::kFewestMembers need no swarm
    /// @throws RenderError
    Rehearsal(const std::vector<std::uint32_t>& surfaces, const std::vector<std::uint32_t>& caps,
              std::size_t most_pieces);
    Rehearsal(const Rehearsal&) = delete;
    Rehearsal& operator=(const Rehearsal&) = delete;

    /// Around the middle of the stage. They live as long as this.
    const std::vector<DrawnObject>& objects() const { return objects_; }

private:
    void add(std::uint32_t look, TriangleKind kind, GLsizei triangles, float reach,
             std::optional<std::uint32_t> member = {});

    std::shared_ptr<const SharedBuffers> buffers_;
    std::vector<std::unique_ptr<DrawnFragment>> fragments_;
    std::vector<DrawnObject> objects_;
};

}  // namespace kerf::render
