#include "viewer/render/pieces_on_stage.h"

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <stdexcept>
#include <utility>

#include "common/io/mesh_file.h"

namespace kerf::test {

std::vector<StagedPiece> pieces_of(const std::string& model, const Backend& backend, int cuts, float turn,
                                   const std::string& image)
{
    io::LoadedMesh loaded = io::read_mesh(std::string(KERF_DATA_DIR "/models/") + model + ".obj");
    const bool is_closed = loaded.is_closed();
    IndexedMesh mesh = *std::move(loaded.mesh);
    for (Material& material : mesh.materials) material.texture = image;
    const Box box = mesh.bounds();
    const glm::vec3 centre = 0.5f * (box.lo + box.hi);
    const float radius = 0.5f * glm::length(box.hi - box.lo);
    glm::mat4 stand = glm::rotate(glm::mat4(1.0f), turn, glm::normalize(glm::vec3(0.3f, 1.0f, 0.2f)));
    stand = glm::translate(glm::scale(stand, glm::vec3(1.0f / radius)), -centre);

    std::vector<StagedPiece> pieces;
    PrepareResult prepared = backend.prepare(std::move(mesh));
    if (!prepared.object) throw std::runtime_error(model + ": " + prepared.reason);
    pieces.push_back({std::move(prepared.object), stand, 1.0f / radius, {}, is_closed});
    for (int i = 0; i < cuts; ++i) {
        const auto largest = std::max_element(pieces.begin(), pieces.end(), [](const auto& a, const auto& b) {
            return a.object->mass_properties().volume < b.object->mass_properties().volume;
        });
        StagedPiece whole = std::move(*largest);
        pieces.erase(largest);
        const glm::dvec3 normal(0.4 + 0.3 * i, 0.8 - 0.5 * i, 0.5);
        const Plane plane = *Plane::through(whole.object->mass_properties().centre, normal);
        CutResult result = cut(std::move(whole.object), plane);
        if (result.status != Status::done) throw std::runtime_error(model + ": the cut missed");
        const auto keep = [&](std::unique_ptr<Cuttable>& piece, float side) {
            const glm::mat4 apart = glm::translate(whole.model, side * 0.12f * radius * glm::vec3(plane.normal));
            pieces.push_back({std::move(piece), apart, 1.0f / radius, plane, is_closed});
        };
        for (auto& piece : result.positive) keep(piece, 1.0f);
        for (auto& piece : result.negative) keep(piece, -1.0f);
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
    for (StagedPiece& piece : pieces) fragments.push_back(store.add(*piece.object));
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
