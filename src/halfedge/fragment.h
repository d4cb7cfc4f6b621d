#pragma once

#include <memory>
#include <vector>

#include "common/cut.h"
#include "halfedge/universe.h"

namespace kerf::halfedge {

/// An object of the half-edge back end: roots in a universe that it shares with its relatives.
class Fragment final : public Cuttable
{
public:
    Fragment(Prepared prepared, std::size_t material_count);
    /// An empty fragment, to be filled without failing: has room for `shells`.
    Fragment(std::shared_ptr<Universe> universe, std::size_t shells, std::size_t material_count);
    ~Fragment() override;

    std::unique_ptr<Cuttable> clone() const override;
    std::uint64_t triangle_count() const override;
    Box bounds() const override;
    DrawView draw_view() const override;
    void mark_uploaded() override;
    MassProperties mass_properties() const override;
    CollisionProxy collision_proxy(ProxyKind kind) const override;
    std::span<const SectionLoop> section_loops() const override { return loops_; }
    IndexedMesh to_indexed_mesh() const override;
    bool wants_compaction() const override;
    void compact() override;

    const Universe& universe() const { return *universe_; }
    const std::vector<Shell>& shells() const { return shells_; }

private:
    CutResult cut_by(const Plane& plane, const CutOptions& options) override;

    void add_shell(const Shell& shell);
    void release();
    std::vector<Index> roots() const;
    /// DrawView::ranges.
    std::vector<DrawRange> draw_ranges() const;
    /// Each vertex that the fragment uses, once. O(n).
    std::vector<Vertex> used_vertices() const;

    std::shared_ptr<Universe> universe_;
    std::vector<Shell> shells_;
    /// The first of the universe's materials; those behind them were added by cuts of relatives.
    std::size_t material_count_;
    std::vector<SectionLoop> loops_;

    friend class Cutter;
};

}  // namespace kerf::halfedge
