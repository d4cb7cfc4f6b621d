#include "common/fracture/take_apart_by_subtrees.h"

#include <algorithm>
#include <utility>

#include "common/fracture/cell_finder.h"

namespace kerf::core {

namespace {

class SubtreeTaker
{
public:
    SubtreeTaker(Breakable& object, const InsideLook& look) : object_(object), look_(look) {}

    bool split(std::span<const glm::dvec3> sites, double least_volume, const ProgressOfStep& progress)
    {
        const Box box = object_.bounds();
        const auto splits = [&](std::span<const glm::dvec3> tried, const ProgressOfStep& part) {
            const auto diagram = make_cell_diagram(tried, box, part.part(0.0, 0.3));
            if (!diagram) return false;
            CellFinder finder(*diagram);
            object_.divide(tried.size(), [&](const Box& subtree) { return finder.cell_of(subtree); });
            solid_.emplace(object_.border(), object_.most_points());
            auto split = split_into_cells(solid_->points, solid_->triangles, *diagram, part.part(0.5, 1.0));
            if (!split) return false;
            split_ = *std::move(split);
            return true;
        };
        taken_.apart.sites = sites_that_split(box, sites, splits, progress);
        least_volume_ = std::max(least_volume, least_volume_of_fragment(box));
        return !taken_.apart.sites.empty();
    }

    TakenApartBySubtrees take()
    {
        taken_.stream_means = object_.stream_means();
        find_borders();
        find_known_fragments();
        hand_over();
        taken_.apart.split = std::move(split_);
        taken_.points = std::move(solid_->points);
        return std::move(taken_);
    }

private:
    /// If what closes the cell hangs together, and the surface with it: each part of a connected shell that is divided has
    /// a border in each cell that it reaches into, so it does if each shell is divided here. All have to be of one solid.
    std::optional<PieceBorder> border_of(std::uint32_t cell, PieceMeshes& meshes) const
    {
        const Breakable::Whole& whole = object_.whole_of(cell);
        if (!whole.is_known) return std::nullopt;
        std::optional<PieceBorder> border = meshes.border_of(cell);
        if (!border) return std::nullopt;
        std::vector<std::uint32_t> divided;
        const auto shell_of = [&](std::uint32_t triangle) { return object_.border_shells()[triangle]; };
        const auto is_divided = [&](std::uint32_t shell) { return std::ranges::find(divided, shell) != divided.end(); };
        for (const std::uint32_t triangle : border->divided)
            if (!is_divided(shell_of(triangle))) divided.push_back(shell_of(triangle));
        if (is_divided(kNone) || !std::ranges::all_of(whole.shells, is_divided) ||
            !std::ranges::all_of(border->kept, [&](std::uint32_t triangle) { return is_divided(shell_of(triangle)); }))
            return std::nullopt;
        for (const std::uint32_t shell : divided) {
            if (object_.solid_of(shell) != object_.solid_of(divided.front())) return std::nullopt;
            border->solid = object_.solid_of(shell);
        }
        return border;
    }

    void find_borders()
    {
        PieceMeshes meshes(object_.border(), solid_->points, split_, look_, taken_.stream_means);
        for (std::uint32_t cell = 0; cell < split_.parts.size(); ++cell) {
            borders_.push_back(border_of(cell, meshes));
            if (!borders_.back()) show(cell);
        }
        show_wanted();
    }

    /// PieceMeshes reads the border, so that it must not grow at once.
    void show(std::uint32_t cell)
    {
        borders_[cell].reset();
        if (object_.whole_of(cell).triangles > 0) to_show_.push_back(cell);
    }

    void show_wanted()
    {
        for (const std::uint32_t cell : to_show_) {
            const std::size_t first = object_.border().triangles.size();
            object_.show(cell);
            solid_->add_rest(object_.border());
            for (std::size_t t = first; t < solid_->triangles.size(); ++t)
                split_.parts[cell].push_back({solid_->triangles[t], static_cast<std::uint32_t>(t)});
        }
        to_show_.clear();
    }

    /// Cells that are joined to others are made as meshes, too.
    void find_known_fragments()
    {
        for (bool is_done = false; !is_done;) {
            std::vector<KnownCell> known;
            for (std::uint32_t cell = 0; cell < borders_.size(); ++cell)
                if (borders_[cell]) known.push_back({cell, object_.whole_of(cell).volume});
            SplitSolid split = split_;
            taken_.apart.fragments = find_fragments(solid_->points, split, least_volume_, object_.reference(), known);
            is_done = true;
            for (const Fragment& fragment : taken_.apart.fragments.fragments) {
                if (fragment.cells.size() < 2) continue;
                for (const std::uint32_t cell : fragment.cells) {
                    if (!borders_[cell]) continue;
                    show(cell);
                    is_done = false;
                }
            }
            show_wanted();
        }
    }

    void hand_over()
    {
        const std::vector<Fragment>& fragments = taken_.apart.fragments.fragments;
        std::vector<PieceBorder> pieces;
        std::vector<std::size_t> fragment_of;
        for (std::size_t f = 0; f < fragments.size(); ++f) {
            std::optional<PieceBorder>& border = borders_[fragments[f].cells.front()];
            if (!border) continue;
            pieces.push_back(*std::move(border));
            fragment_of.push_back(f);
        }
        taken_.objects.resize(fragments.size());
        if (pieces.empty()) return;
        auto objects = object_.hand_over(pieces, look_.material);
        for (std::size_t i = 0; i < objects.size(); ++i) taken_.objects[fragment_of[i]] = std::move(objects[i]);
    }

    Breakable& object_;
    const InsideLook& look_;
    double least_volume_ = 0.0;
    std::optional<SolidOfPoints> solid_;
    SplitSolid split_;
    std::vector<std::optional<PieceBorder>> borders_;  ///< of the cells that are handed over
    std::vector<std::uint32_t> to_show_;
    TakenApartBySubtrees taken_;
};

}  // namespace

std::optional<TakenApartBySubtrees> take_apart_by_subtrees(Breakable& object, std::span<const glm::dvec3> sites,
                                                           double least_volume, const InsideLook& look,
                                                           const ProgressOfStep& progress)
{
    SubtreeTaker taker(object, look);
    if (!taker.split(sites, least_volume, progress)) return std::nullopt;
    return taker.take();
}

}  // namespace kerf::core
