#include "viewer/render/pieces_on_stage.h"

#include <kerf/cut.h>
#include <kerf/io.h>

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <stdexcept>
#include <utility>

#include "viewer/sim/back_ends.h"
#include "viewer/sim/kerf_glm.h"
#include "viewer/support/stages.h"

namespace kerf::test {

std::vector<std::string> back_end_of_each_kind()
{
    std::vector<std::string> chosen{"baseline/hash"};
    if (!sim::known_back_end("halfedge").empty()) chosen.emplace_back("halfedge");
    return chosen;
}

std::string test_name_of(std::string back_end)
{
    std::replace(back_end.begin(), back_end.end(), '/', '_');
    return back_end;
}

std::vector<StagedPiece> pieces_of(const std::string& model, const std::string& back_end, int cuts, float turn,
                                   const std::string& image)
{
    const Mesh mesh = value_of(read_mesh((std::string(KERF_DATA_DIR "/models/") + model + ".obj").c_str()));
    const bool is_closed = mesh.is_closed();
    const std::vector<std::string> images(mesh.material_count(), image);
    const Box box = mesh.bounds();
    const glm::vec3 centre(sim::centre_of(box));
    const auto radius = static_cast<float>(sim::radius_of(box));
    glm::mat4 stand = glm::rotate(glm::mat4(1.0f), turn, glm::normalize(glm::vec3(0.3f, 1.0f, 0.2f)));
    stand = glm::translate(glm::scale(stand, glm::vec3(1.0f / radius)), -centre);

    std::vector<StagedPiece> pieces;
    pieces.push_back({object_of(mesh, back_end), stand, 1.0f / radius, {}, is_closed, images});
    for (int i = 0; i < cuts; ++i) {
        const auto largest = std::max_element(pieces.begin(), pieces.end(), [](const auto& a, const auto& b) {
            return a.object.mass_properties().volume < b.object.mass_properties().volume;
        });
        StagedPiece whole = std::move(*largest);
        pieces.erase(largest);
        const glm::dvec3 normal(0.4 + 0.3 * i, 0.8 - 0.5 * i, 0.5);
        const Plane plane = plane_through(glm::dvec3(whole.object.mass_properties().centre), normal);
        Cut result = cut(std::move(whole.object), plane);
        if (result.status != Status::done) throw std::runtime_error(model + ": the cut missed");
        const auto keep = [&](Object& piece, float side) {
            const glm::mat4 apart = glm::translate(whole.model, side * 0.12f * radius * glm::vec3(plane.normal()));
            pieces.push_back({std::move(piece), apart, 1.0f / radius, plane, is_closed, images});
        };
        if (Object* const piece = result.one(Side::positive)) keep(*piece, 1.0f);
        if (Object* const piece = result.one(Side::negative)) keep(*piece, -1.0f);
    }
    return pieces;
}

render::Viewpoint near_viewpoint(int width, int height)
{
    render::Viewpoint viewpoint;
    viewpoint.eye = {0.0f, 0.0f, 10.0f};
    viewpoint.view = glm::lookAt(viewpoint.eye, glm::vec3(0.0f), glm::vec3(0.0f, 1.0f, 0.0f));
    viewpoint.projection =
        glm::perspective(2.0f * std::atan(0.14f), static_cast<float>(width) / static_cast<float>(height), 0.5f, 60.0f);
    return viewpoint;
}

std::vector<render::DrawnFragment> uploaded(render::FragmentStore& store, std::vector<StagedPiece>& pieces)
{
    std::vector<render::DrawnFragment> fragments;
    for (StagedPiece& piece : pieces) fragments.push_back(store.add(piece.object, piece.images));
    return fragments;
}

std::vector<render::DrawnObject> drawn(const std::vector<StagedPiece>& pieces,
                                       const std::vector<render::DrawnFragment>& fragments)
{
    std::vector<render::DrawnObject> objects;
    for (std::size_t i = 0; i < pieces.size(); ++i)
        objects.push_back({static_cast<std::uint32_t>(i + 1), &fragments[i], pieces[i].model, pieces[i].pattern_scale,
                           pieces[i].is_closed});
    return objects;
}

}  // namespace kerf::test
