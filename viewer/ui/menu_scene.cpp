#include "viewer/ui/menu_scene.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "viewer/sim/simulation.h"
#include "viewer/ui/screen_view.h"
#include "viewer/ui/screens.h"

namespace kerf::ui {

void MenuScene::tick(sim::Simulation& simulation)
{
    if (placed_) return;
    placed_ = true;
    const sim::ModelLibrary& models = simulation.models();
    for (std::size_t mode = 0; mode < modes().size(); ++mode) {
        objects_.push_back(0);
        std::size_t model = 0;
        while (model < models.size() && models.model(model).name != modes()[mode].model) ++model;
        if (model == models.size()) continue;
        const Box& box = models.model(model).box;
        const double radius = 0.5 * glm::distance(glm::dvec3(box.lo), glm::dvec3(box.hi));
        const double turn = 0.7 + 2.0 * double(mode);  // nothing long points at the eye
        const glm::dmat4 tilted = glm::rotate(glm::dmat4(1.0), 0.45, glm::dvec3(1.0, 0.0, 0.3));
        const glm::dmat3 rotation(glm::rotate(tilted, turn, glm::dvec3(0.0, 1.0, 0.0)));
        sim::Motion motion;
        motion.spin = {0.12, 0.55, 0.05};
        const sim::Body* const body = simulation.place_object(model, kModeRadius / radius,
                                                              glm::dvec3(place_of_mode(mode), 0.0), rotation, motion);
        if (body != nullptr) objects_.back() = body->id();
    }
}

void MenuScene::on_cut(sim::Simulation&, const sim::CutRecord& cut)
{
    const auto found = std::find(objects_.begin(), objects_.end(), cut.object);
    if (chosen_ || cut.pieces.empty() || found == objects_.end()) return;
    chosen_ = static_cast<std::size_t>(found - objects_.begin());
}

void MenuScene::hash(sim::StateHash& hash) const
{
    hash.add(placed_);
    hash.add(chosen_ ? std::uint64_t(*chosen_) : ~std::uint64_t(0));
}

}  // namespace kerf::ui
