#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "viewer/render/drawn_object.h"

namespace kerf::render {

/// Specks of each look, with few triangles and with many, so that they are shaded in both ways. Drivers translate a program
/// when it is drawn with first, for the state that it is drawn in, and their memory grows with the first frame of many
/// draws: that must not be the frame in which something breaks. Draw these once where nobody sees it.
class Rehearsal
{
public:
    /// @param looks  indices into the LookTable, of materials' surfaces and of their caps
    /// @throws RenderError
    Rehearsal(const std::vector<std::uint32_t>& surfaces, const std::vector<std::uint32_t>& caps);
    Rehearsal(const Rehearsal&) = delete;
    Rehearsal& operator=(const Rehearsal&) = delete;

    /// Around the middle of the stage. They live as long as this.
    const std::vector<DrawnObject>& objects() const { return objects_; }

private:
    void add(std::uint32_t look, TriangleKind kind, GLsizei triangles, float reach);

    std::shared_ptr<const SharedBuffers> buffers_;
    std::vector<std::unique_ptr<DrawnFragment>> fragments_;
    std::vector<DrawnObject> objects_;
};

}  // namespace kerf::render
