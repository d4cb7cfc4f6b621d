#pragma once

#include <kerf/object.h>

#include <optional>
#include <string>
#include <vector>

#include "viewer/render/scene_renderer.h"

namespace kerf::test {

/// One of the report's look-ups, and the half-edge back end if it is built: enough where only surfaces matter, which are
/// equal bit for bit.
std::vector<std::string> back_end_of_each_kind();

/// A back end as GoogleTest wants names: letters, digits and underscores.
std::string test_name_of(std::string back_end);

/// A piece of an object, where it stands, and the plane that uncovered its last cap.
struct StagedPiece
{
    Object object;
    glm::mat4 model{1.0f};
    float pattern_scale = 1.0f;
    std::optional<Plane> plane;
    bool is_closed = false;                ///< DrawnObject::is_closed
    std::vector<std::string> images = {};  ///< FragmentStore::add()
};

/// The pieces of a model of data/models after `cuts` cuts, each through the middle of the largest piece, pulled apart,
/// and turned as a whole by `turn` radians about an axis that is none of the object's. Same arguments, same pieces.
/// @param image  what its materials have as image
std::vector<StagedPiece> pieces_of(const std::string& model, const std::string& back_end, int cuts, float turn,
                                   const std::string& image = {});

/// Looks at the origin from z = 10; a piece of pieces_of() fills most of the height.
render::Viewpoint near_viewpoint(int width, int height);

/// Puts pieces onto the graphics card.
std::vector<render::DrawnFragment> uploaded(render::FragmentStore& store, std::vector<StagedPiece>& pieces);

/// Objects 1, 2, ... for the renderer. The fragments must outlive them.
std::vector<render::DrawnObject> drawn(const std::vector<StagedPiece>& pieces,
                                       const std::vector<render::DrawnFragment>& fragments);

}  // namespace kerf::test
