#include "halfedge/fragment.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <shared_mutex>

#include "common/cutting/back_end_helpers.h"
#include "common/mesh/mass_moments.h"
#include "common/mesh/support_points.h"
#include "halfedge/breakable_fragment.h"
#include "halfedge/cut/cutter.h"
#include "halfedge/cut/outline.h"
#include "halfedge/cut/workspace_pool.h"
#include "halfedge/universe/compaction.h"
#include "halfedge/universe/export.h"
#include "halfedge/universe/support_search.h"

namespace kerf::core::halfedge {

Fragment::Fragment(std::shared_ptr<SharedUniverse> shared, std::span<const ShellRoot> shells,
                   std::size_t material_count)
    : Fragment(std::move(shared), shells.size(), material_count)
{
    for (const ShellRoot& shell : shells) add_shell(shell);
}

Fragment::Fragment(std::shared_ptr<SharedUniverse> shared, std::size_t shells, std::size_t material_count)
    : shared_(std::move(shared)), material_count_(material_count)
{
    shells_.reserve(shells);
}

Fragment::~Fragment()
{
    release();
}

/// There is room for it.
void Fragment::add_shell(const ShellRoot& shell)
{
    const Node& root = universe().tree.nodes[shell.root];
    shells_.push_back(shell);
    triangle_count_ += root.count;
    box_.add(root.box);
    shared_->universe.live_slots += root.count;
}

/// Lets go of all triangles.
void Fragment::release()
{
    // Without the lock and the tree: fragments end inside a cut that fails, and beside cuts of relatives.
    shared_->universe.live_slots -= triangle_count_;
    triangle_count_ = 0;
    shells_.clear();
}

std::unique_ptr<Cuttable> Fragment::clone() const
{
    const std::shared_lock lock(universe().mutex);
    auto copy = copied();
    copy->loops_ = loops_;
    return copy;
}

/// In a universe of its own, without loops; the caller holds the lock.
std::unique_ptr<Fragment> Fragment::copied() const
{
    // A fragment that is most of its universe is copied block by block, the others triangle by triangle.
    const bool most = 2 * triangle_count_ > universe().slots.size();
    if (most) make_room_for_cut(universe().slots.size());
    return most ? std::make_unique<Fragment>(std::make_shared<SharedUniverse>(*shared_), shells_, material_count_)
                : compacted();
}

std::unique_ptr<Breakable> Fragment::breakable() const
{
    // Below that, borders are most of it.
    constexpr std::uint64_t kWorthATree = 20'000;
    if (triangle_count_ < kWorthATree) return nullptr;
    const std::shared_lock lock(universe().mutex);
    const std::unique_ptr<Fragment> copy = copied();
    return make_breakable(copy->shared_, copy->shells_, material_count_);
}

/// Without loops; the caller holds the lock.
std::unique_ptr<Fragment> Fragment::compacted() const
{
    auto shared = std::make_shared<SharedUniverse>(shared_->identity.listener(), shared_->cap_quality);
    const std::vector<ShellRoot> shells = compact_copy(universe(), shells_, shared->universe);
    make_room_for_cut(shared->universe.slots.size());
    return std::make_unique<Fragment>(std::move(shared), shells, material_count_);
}

bool Fragment::wants_compaction() const
{
    // More ranges than a renderer likes to issue for one object; more dead triangles than live ones.
    constexpr std::size_t kRanges = 500, kFewSlots = 4096;
    const Universe& u = universe();
    const std::shared_lock lock(u.mutex);
    const std::size_t dead = u.slots.size() - u.live_slots;
    return (dead > u.live_slots && dead > kFewSlots) || draw_ranges().size() > kRanges;
}

void Fragment::compact()
{
    // What the copy gets in exchange ends with it, after the lock.
    std::unique_ptr<Fragment> copy;
    {
        const std::shared_lock lock(universe().mutex);
        copy = compacted();
    }
    std::swap(shared_, copy->shared_);
    std::swap(shells_, copy->shells_);
}

std::vector<NodeId> Fragment::roots() const
{
    std::vector<NodeId> roots;
    roots.reserve(shells_.size());
    for (const ShellRoot& shell : shells_) roots.push_back(shell.root);
    return roots;
}

std::vector<DrawRange> Fragment::draw_ranges() const
{
    const Universe& u = universe();
    std::vector<TriangleTree::Run> runs;
    for (const ShellRoot& shell : shells_) u.tree.append_runs(shell.root, runs);
    std::vector<DrawRange> ranges;
    ranges.reserve(runs.size());
    for (const TriangleTree::Run& run : runs) {
        const DrawGroup& g = u.group(run.group);
        ranges.push_back({3 * run.first.number(), 3 * run.count, g.material, g.kind});
    }
    merge_ranges(ranges);
    return ranges;
}

DrawView Fragment::draw_view() const
{
    const Universe& u = universe();
    const std::shared_lock lock(u.mutex);
    DrawView view;
    view.buffers = buffers();
    view.vertices = {u.vertices.data(), u.vertices.size()};
    view.indices = {u.slots.empty() ? nullptr : u.slots[SlotId(0)].data(), 3 * u.slots.size()};
    view.materials = {u.materials.data(), material_count_};
    view.ranges = draw_ranges();
    for (const Stream& stream : u.streams)
        view.streams.push_back({stream.name, stream.width, {stream.values.data(), stream.values.size()}});
    const auto append = [](std::vector<ByteRange>& ranges, std::uint64_t from, std::uint64_t to, std::uint64_t size) {
        if (from < to) ranges.push_back({from * size, (to - from) * size});
    };
    append(view.new_vertex_bytes, u.uploaded_vertices, u.vertices.size(), sizeof(Vertex));
    append(view.new_index_bytes, u.uploaded_slots, u.slots.size(), sizeof(Triangle));
    return view;
}

void Fragment::mark_uploaded(const DrawView& view)
{
    if (view.buffers != buffers()) return;
    Universe& u = shared_->universe;
    const std::unique_lock lock(u.mutex);
    // A relative may have been cut since: what that has added is not on the GPU.
    u.uploaded_vertices = std::max(u.uploaded_vertices, view.vertices.size());
    u.uploaded_slots = std::max(u.uploaded_slots, view.indices.size() / 3);
}

MassProperties Fragment::mass_properties() const
{
    const Universe& u = universe();
    const std::shared_lock lock(u.mutex);
    if (triangle_count_ <= kFewForMass) return mass_summed_anew();
    MassMoments moments;
    for (const ShellRoot& shell : shells_) moments.add(u.tree.moments[shell.root]);
    // Caps may have made many of few.
    return moments.are_known() ? moments.properties(u.reference) : mass_summed_anew();
}

/// The caller holds the lock. The sums depend on the order of the triangles alone and not on where they lie, so they stay
/// the same if the object moves to buffers of its own.
MassProperties Fragment::mass_summed_anew() const
{
    const Universe& u = universe();
    std::vector<TriangleTree::Run> runs;
    for (const ShellRoot& shell : shells_) u.tree.append_runs(shell.root, runs);
    std::vector<std::span<const Triangle>> triangles;
    triangles.reserve(runs.size());
    for (const TriangleTree::Run& run : runs) triangles.emplace_back(&u.slots[run.first], run.count);
    const glm::dvec3 reference = mass_reference(box_);
    return mass_moments({u.vertices.data(), u.vertices.size()}, triangles, reference).properties(reference);
}

std::array<glm::vec3, kSupportDirections> Fragment::support_points() const
{
    const Universe& u = universe();
    const std::shared_lock lock(u.mutex);
    return halfedge::support_points(u.tree, u.geometry(), roots());
}

std::span<const Vertex> Fragment::used_vertices(std::vector<Vertex>& room) const
{
    const Universe& u = universe();
    const std::shared_lock lock(u.mutex);
    std::vector<bool> seen(u.vertices.size());
    room.clear();
    for (const ShellRoot& shell : shells_)
        for_each_slot(u, shell.root, [&](SlotId slot) {
            for (const Index v : u.slots[slot]) {
                if (seen[v]) continue;
                seen[v] = true;
                room.push_back(u.vertices[v]);
            }
        });
    return room;
}

double Fragment::noise() const
{
    const std::shared_lock lock(universe().mutex);
    return universe().noise;
}

void Fragment::set_noise(double noise)
{
    const std::unique_lock lock(universe().mutex);
    shared_->universe.noise = noise;
}

std::span<const Material> Fragment::materials() const
{
    const std::shared_lock lock(universe().mutex);
    return {universe().materials.data(), material_count_};
}

std::uint32_t Fragment::add_material(const Material& material)
{
    Universe& u = shared_->universe;
    const std::unique_lock lock(u.mutex);
    u.make_room_for_material();
    u.materials.push_back(material);
    material_count_ = u.materials.size();
    return static_cast<std::uint32_t>(material_count_ - 1);
}

IndexedMesh Fragment::to_indexed_mesh() const
{
    const std::shared_lock lock(universe().mutex);
    IndexedMesh mesh = export_mesh(universe(), shells_);
    mesh.materials.resize(material_count_);
    return mesh;
}

Fragment::FragmentsBySide Fragment::planned_fragments(const Cutter& cutter) const
{
    FragmentsBySide fragments;
    for (const Side side : kSides)
        for (PlannedFragment& planned : cutter.planned_fragments(side)) {
            auto& fragment = fragments[side].emplace_back(
                std::make_unique<Fragment>(shared_, planned.shells, cutter.material_count()));
            fragment->loops_ = std::move(planned.loops);
        }
    return fragments;
}

CutResult Fragment::cut_by(const Plane& plane, const CutOptions& options)
{
    const std::unique_lock lock(universe().mutex);
    CutResult result;
    CutOptions asked = options;
    asked.cap_quality = std::max(options.cap_quality, shared_->cap_quality);
    const BorrowedWorkspace workspace;
    Cutter cutter(shared_->universe, *workspace, shells_, material_count_);
    if (!cutter.plan(plane, asked, result)) return result;
    FragmentsBySide fragments = planned_fragments(cutter);
    result.negative.reserve(fragments[Side::negative].size());
    result.positive.reserve(fragments[Side::positive].size());

    // From here on nothing can fail.
    cutter.carry_out(result);
    cutter.for_each_shell(
        [&](Side side, Index fragment, const ShellRoot& shell) { fragments[side][fragment]->add_shell(shell); });
    const auto hand_over = [](auto& from, auto& to) {
        for (auto& fragment : from)
            if (!fragment->shells_.empty()) to.push_back(std::move(fragment));
    };
    hand_over(fragments[Side::negative], result.negative);
    hand_over(fragments[Side::positive], result.positive);
    release();
    return result;
}

void Fragment::find_section(const Plane& plane, PlaneSection& section) const
{
    const std::shared_lock lock(universe().mutex);
    const BorrowedWorkspace workspace;
    find_outline(universe(), shells_, plane, *workspace, section);
}

}  // namespace kerf::core::halfedge
