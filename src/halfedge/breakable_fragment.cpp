#include "halfedge/breakable_fragment.h"

#include <algorithm>
#include <utility>

#include "halfedge/handover/handover.h"
#include "halfedge/universe/export.h"

namespace kerf::core::halfedge {

namespace {

class BreakableFragment final : public Breakable
{
public:
    BreakableFragment(std::shared_ptr<SharedUniverse> copy, std::span<const ShellRoot> shells,
                      std::size_t material_count)
        : shared_(std::move(copy)),
          shells_(shells.begin(), shells.end()),
          border_(shared_->universe, shells_, material_count)
    {
        // Materials behind those of the object were added by cuts of relatives, which have no copies here.
        universe().materials.resize(material_count);
        universe().cap_material = kDefaultCapMaterial;
        for (const ShellRoot& shell : shells_) {
            const Node& root = universe().tree.nodes[shell.root];
            triangle_count_ += root.count;
            bounds_.add(root.box);
        }
    }

    Box bounds() const override { return bounds_; }
    std::uint64_t triangle_count() const override { return triangle_count_; }

    void find(const std::function<bool(const Box&)>& is_wanted,
              const std::function<void(std::span<const Corners>)>& visit) const override
    {
        std::vector<NodeId> waiting;
        for (const ShellRoot& shell : shells_) waiting.push_back(shell.root);
        std::vector<Corners> found;
        while (!waiting.empty()) {
            const Node& node = universe().tree.nodes[waiting.back()];
            waiting.pop_back();
            if (!is_wanted(node.box)) continue;
            if (!node.is_leaf()) {
                waiting.push_back(node.right);
                waiting.push_back(node.left);
                continue;
            }
            found.clear();
            for (SlotId slot = node.first; slot < node.first + node.count; ++slot) {
                const Triangle& t = universe().slots[slot];
                const auto at = [&](Index v) { return universe().vertices[v].position; };
                found.push_back({at(t[0]), at(t[1]), at(t[2])});
            }
            visit(found);
        }
    }

    void divide(std::size_t cells, const CellOfBox& cell_of) override { border_.divide(cells, cell_of); }
    const Whole& whole_of(std::uint32_t cell) const override { return border_.whole_of(cell); }
    void show(std::uint32_t cell) override { border_.show(cell); }
    IndexedMesh& border() override { return border_.mesh(); }
    std::span<const std::uint32_t> border_shells() const override { return border_.shells(); }
    std::uint32_t solid_of(std::uint32_t shell) const override { return shells_[shell].solid; }
    std::uint32_t most_points() const override { return static_cast<std::uint32_t>(universe().mesh.points()); }
    glm::dvec3 reference() const override { return universe().reference; }

    std::vector<std::vector<double>> stream_means() const override
    {
        std::vector<std::vector<double>> means;
        for (const Stream& stream : universe().streams) means.emplace_back(stream.width, 0.0);
        if (means.empty()) return means;
        std::vector<bool> seen(universe().vertices.size());
        std::size_t count = 0;
        const auto add = [&](Index v) {
            if (seen[v]) return;
            seen[v] = true;
            ++count;
            for (std::size_t s = 0; s < means.size(); ++s)
                for (std::size_t i = 0; i < means[s].size(); ++i)
                    means[s][i] += double(universe().streams[s].values[std::size_t{v} * means[s].size() + i]);
        };
        for (const ShellRoot& shell : shells_)
            for_each_slot(universe(), shell.root,
                          [&](SlotId slot) { std::ranges::for_each(universe().slots[slot], add); });
        for (std::vector<double>& mean : means)
            for (double& value : mean) value /= double(count);
        return means;
    }

    std::vector<std::unique_ptr<Cuttable>> hand_over(std::span<const PieceBorder> pieces,
                                                     std::uint32_t cap_material) override
    {
        universe().set_materials(border_.mesh().materials);
        const std::vector<ShellRoot> roots = halfedge::hand_over(universe(), shells_, border_, pieces, cap_material);
        std::vector<std::unique_ptr<Cuttable>> objects;
        for (const ShellRoot& root : roots)
            objects.push_back(std::make_unique<Fragment>(shared_, std::span(&root, 1), universe().materials.size()));
        return objects;
    }

private:
    Universe& universe() { return shared_->universe; }
    const Universe& universe() const { return shared_->universe; }

    std::shared_ptr<SharedUniverse> shared_;
    std::vector<ShellRoot> shells_;
    Border border_;
    std::uint64_t triangle_count_ = 0;
    Box bounds_;
};

}  // namespace

std::unique_ptr<Breakable> make_breakable(std::shared_ptr<SharedUniverse> copy, std::span<const ShellRoot> shells,
                                          std::size_t material_count)
{
    return std::make_unique<BreakableFragment>(std::move(copy), shells, material_count);
}

}  // namespace kerf::core::halfedge
