#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "common/cutting/cut.h"
#include "halfedge/shared_universe.h"

namespace kerf::core::halfedge {

class Cutter;

/// An object of the half-edge back end: roots in a universe that it shares with its relatives.
class Fragment final : public Cuttable
{
public:
    Fragment(std::shared_ptr<SharedUniverse> shared, std::span<const ShellRoot> shells, std::size_t material_count);
    /// An empty fragment, to be filled without failing: has room for `shells`.
    Fragment(std::shared_ptr<SharedUniverse> shared, std::size_t shells, std::size_t material_count);
    ~Fragment() override;

    std::unique_ptr<Cuttable> clone() const override;
    std::uint64_t triangle_count() const override { return triangle_count_; }
    Box bounds() const override { return box_; }
    DrawView draw_view() const override;
    void mark_uploaded(const DrawView& view) override;
    MassProperties mass_properties() const override;
    std::array<glm::vec3, kSupportDirections> support_points() const override;
    std::span<const Vertex> used_vertices(std::vector<Vertex>& room) const override;
    std::span<const SectionLoop> section_loops() const override { return loops_; }
    double noise() const override;
    void set_noise(double noise) override;
    std::span<const Material> materials() const override;
    std::uint32_t add_material(const Material& material) override;
    IndexedMesh to_indexed_mesh() const override;
    std::unique_ptr<Breakable> breakable() const override;
    bool wants_compaction() const override;
    void compact() override;

    const Universe& universe() const { return shared_->universe; }
    const std::vector<ShellRoot>& shells() const { return shells_; }

private:
    CutResult cut_by(const Plane& plane, const CutOptions& options) override;
    void find_section(const Plane& plane, PlaneSection& section) const override;
    std::uint64_t buffers() const noexcept override { return shared_->identity.serial(); }
    bool has_relatives() const noexcept override { return shared_.use_count() > 1; }

    using FragmentsBySide = BySide<std::vector<std::unique_ptr<Fragment>>>;

    void add_shell(const ShellRoot& shell);
    std::unique_ptr<Fragment> compacted() const;
    std::unique_ptr<Fragment> copied() const;
    /// The fragments that a cut will fill, with their loops and without shells.
    FragmentsBySide planned_fragments(const Cutter& cutter) const;
    void release();
    MassProperties mass_summed_anew() const;
    std::vector<NodeId> roots() const;
    /// DrawView::ranges. The caller holds the lock.
    std::vector<DrawRange> draw_ranges() const;

    // What follows is the fragment's own: reading it needs no lock, and a fragment can end while a relative is cut.
    std::shared_ptr<SharedUniverse> shared_;
    std::vector<ShellRoot> shells_;
    std::uint64_t triangle_count_ = 0;
    Box box_;
    /// The first of the universe's materials; those behind them were added by cuts of relatives.
    std::size_t material_count_;
    std::vector<SectionLoop> loops_;
};

}  // namespace kerf::core::halfedge
