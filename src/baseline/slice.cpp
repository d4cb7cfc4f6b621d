#include "baseline/slice.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>
#include <type_traits>

#include "baseline/fan.h"
#include "baseline/pieces_of_side.h"
#include "baseline/section.h"
#include "baseline/side_builder.h"
#include "baseline/vertex_lookup.h"
#include "common/cutting/cut_geometry.h"
#include "common/support/stopwatch.h"

namespace kerf::baseline {

namespace {

/// Where a vertex lies, as bits, so that the classes of a triangle's corners can be joined by "or".
enum : std::uint8_t
{
    kOn = 0,
    kBelow = 1,
    kAbove = 2,
    kCrossing = kBelow | kAbove
};

/// Where all vertices of a fragment lie.
struct VertexClasses
{
    Buffer<std::uint8_t> of_vertex;
    std::uint32_t on = 0, far_below = 0, far_above = 0;  ///< on the plane; farther from it than the noise

    /// Classifies all vertices; `visit(vertex, class)` sees each of them. O(n).
    template <class Visit>
    void classify(const Fragment& whole, const Plane& plane, Visit&& visit)
    {
        const Buffer<Vertex>& vertices = whole.mesh.vertices;
        of_vertex.resize(vertices.size());
        std::uint8_t* const classes = of_vertex.data();
        const Plane local = plane;  // in registers: the loop writes through pointers that could alias the plane
        const double noise = whole.noise;
        std::uint32_t count_on = 0, count_far_below = 0, count_far_above = 0;
        const auto count = static_cast<std::uint32_t>(vertices.size());
        for (std::uint32_t i = 0; i < count; ++i) {
            const double d = local.signed_distance(vertices[i].position);
            const auto c = static_cast<std::uint8_t>(int(d < 0.0) | (int(d > 0.0) << 1));
            count_on += c == kOn;
            count_far_below += d < -noise;
            count_far_above += d > noise;
            classes[i] = c;
            visit(i, c);
        }
        // Centres of earlier fans do not count (rule 4): they are rounded means of a section and may stick out of the
        // surface by a last place.
        for (const std::uint32_t v : whole.fan_centres) {
            const double d = plane.signed_distance(vertices[v].position);
            count_far_below -= d < -noise;
            count_far_above -= d > noise;
        }
        on = count_on;
        far_below = count_far_below;
        far_above = count_far_above;
    }

    bool one_side_is_empty() const { return far_below == 0 || far_above == 0; }
};

/// One cut with one kind of vertex lookup: the steps of slice(), in order.
template <class Lookup>
class Slicer
{
public:
    Slicer(const Fragment& whole, const Plane& plane, const CutOptions& options)
        : whole_(whole), mesh_(whole.mesh), plane_(plane), options_(options)
    {
    }

    Slices run()
    {
        Stopwatch watch;
        PhaseTimes& phases = slices_.statistics.phases;
        slices_.statistics.triangles = slices_.statistics.triangles_touched = mesh_.triangles.size();
        classify_vertices();
        phases[Phase::find] += watch.lap();
        if (classes_.one_side_is_empty()) return missed(classes_.far_above == 0 ? Side::negative : Side::positive);
        distribute_triangles();
        phases[Phase::copy] += watch.lap();
        split_crossing_triangles(mesh_, plane_, crossings_);
        add_pieces();
        phases[Phase::split] += watch.lap();
        // All of a side can vanish: a spike so thin that its cut points are one.
        for (const SideBuilder& b : builders_)
            if (b.mesh.triangles.empty()) return missed(opposite(b.side()));
        for (SideBuilder& b : builders_) b.join_points(crossings_.cut_points);
        section_ = find_section(mesh_, crossings_, edges_in_plane_[Side::negative], edges_in_plane_[Side::positive]);
        close_sections(watch);
        finish();
        phases[Phase::copy] += watch.lap();
        return std::move(slices_);
    }

private:
    Slices missed(Side side)
    {
        slices_.side_of_object = side;
        return std::move(slices_);
    }

    static constexpr bool kRemaps = std::is_same_v<Lookup, RemapLookup>;

    BySide<Lookup> make_lookups()
    {
        SideBuilder &negative = builders_[Side::negative], &positive = builders_[Side::positive];
        if constexpr (kRemaps)
            return {Lookup(negative, table_), Lookup(positive, table_)};
        else
            return {Lookup(negative), Lookup(positive)};
    }

    SideBuilder& builder(Side side) { return builders_[side]; }
    Lookup& lookup(Side side) { return lookups_[side]; }

    std::uint8_t class_of(const Triangle& t) const
    {
        const std::uint8_t* c = classes_.of_vertex.data();
        return static_cast<std::uint8_t>(c[t[0]] | c[t[1]] | c[t[2]]);
    }

    void classify_vertices()
    {
        if constexpr (kRemaps) {
            RemapLookup::copy_vertices(mesh_, builders_, table_, point_table_, [&](auto&& visit) {
                classes_.classify(whole_, plane_, visit);
                return std::span<const std::uint8_t>(classes_.of_vertex);
            });
        } else {
            classes_.classify(whole_, plane_, [](std::uint32_t, std::uint8_t) {});
        }
    }

    /// The report's loop: what the plane does not cross goes to its side, what it crosses is remembered.
    void distribute_triangles()
    {
        // Groups of one kind, material and solid one after the other, so that they stay together however often they are
        // cut.
        group_order_.resize(mesh_.groups.size());
        std::iota(group_order_.begin(), group_order_.end(), 0u);
        std::stable_sort(group_order_.begin(), group_order_.end(), [&](std::uint32_t a, std::uint32_t b) {
            const TriangleGroup &p = mesh_.groups[a], &q = mesh_.groups[b];
            return std::tie(p.kind, p.material, p.solid) < std::tie(q.kind, q.material, q.solid);
        });
        for (const std::uint32_t g : group_order_) {
            if (classes_.on > 0)
                distribute_with_vertices_on_plane(g);
            else if constexpr (kRemaps)
                renumber_untouched(g);
            else
                distribute(g);
            for (SideBuilder& b : builders_) b.close_group(mesh_.groups[g]);
        }
    }

    void distribute(std::uint32_t g)
    {
        const TriangleGroup& group = mesh_.groups[g];
        for (std::uint32_t i = group.first; i < group.first + group.count; ++i) {
            const std::uint8_t c = class_of(mesh_.triangles[i]);
            if (c == kCrossing)
                crossings_.triangles.push_back({i, g, 0, 0, {}});
            else
                add_untouched(i, c == kBelow ? Side::negative : Side::positive);
        }
    }

    /// distribute() for remap, whose vertices are all there. Both sides are written without a branch that depends on
    /// the side: triangles in a random order cost no mispredictions.
    void renumber_untouched(std::uint32_t g)
    {
        const TriangleGroup& group = mesh_.groups[g];
        IndexedMesh &below = builders_[Side::negative].mesh, &above = builders_[Side::positive].mesh;
        std::size_t at_below = below.triangles.size(), at_above = above.triangles.size();
        // Room for all on either side; what is not needed is given back at once and never written.
        for (IndexedMesh* mesh : {&below, &above}) {
            mesh->triangles.resize(mesh->triangles.size() + group.count);
            mesh->sources.resize(mesh->sources.size() + group.count);
        }
        Triangle *const triangles_below = below.triangles.data(), *const triangles_above = above.triangles.data();
        std::uint32_t *const sources_below = below.sources.data(), *const sources_above = above.sources.data();
        const std::uint32_t* const table = table_.data();
        const std::uint32_t* const sources = mesh_.sources.data();
        const Triangle* const triangles = mesh_.triangles.data();
        for (std::uint32_t i = group.first; i < group.first + group.count; ++i) {
            const Triangle& t = triangles[i];
            const std::uint32_t a = table[t[0]], b = table[t[1]], c = table[t[2]];
            const std::uint32_t sides = ((a ^ b) | (b ^ c)) & 1;
            if (sides != 0) {
                crossings_.triangles.push_back({i, g, 0, 0, {}});
                continue;
            }
            const std::size_t is_above = a & 1;
            const std::size_t at = is_above ? at_above : at_below;
            (is_above ? triangles_above : triangles_below)[at] = {a >> 1, b >> 1, c >> 1};
            (is_above ? sources_above : sources_below)[at] = sources[i];
            at_above += is_above;
            at_below += 1 - is_above;
        }
        below.triangles.resize(at_below);
        below.sources.resize(at_below);
        above.triangles.resize(at_above);
        above.sources.resize(at_above);
    }

    void distribute_with_vertices_on_plane(std::uint32_t g)
    {
        const TriangleGroup& group = mesh_.groups[g];
        const std::uint8_t* classes = classes_.of_vertex.data();
        for (std::uint32_t i = group.first; i < group.first + group.count; ++i) {
            const Triangle& t = mesh_.triangles[i];
            const std::uint8_t c = class_of(t);
            if (c == kCrossing) {
                crossings_.triangles.push_back({i, g, 0, 0, {}});
                continue;
            }
            Side side = c == kBelow ? Side::negative : Side::positive;
            if (c == kOn)
                side = coplanar_side(plane_, mesh_.vertices[t[0]].position, mesh_.vertices[t[1]].position,
                                     mesh_.vertices[t[2]].position);
            for (std::uint8_t corner = 0; corner < 3; ++corner)
                if (classes[t[corner]] == kOn && classes[t[(corner + 1u) % 3]] == kOn)
                    edges_in_plane_[side].push_back({i, g, corner});
            add_untouched(i, side);
        }
    }

    void add_untouched(std::uint32_t triangle, Side side)
    {
        const Triangle& t = mesh_.triangles[triangle];
        Lookup& find = lookup(side);
        builder(side).add_triangle({find.existing(t[0]), find.existing(t[1]), find.existing(t[2])},
                                   mesh_.sources[triangle]);
    }

    void add_pieces()
    {
        for (SideBuilder& b : builders_) b.set_cut_point_count(crossings_.cut_points.size());
        if constexpr (kRemaps)
            for (Lookup& find : lookups_) find.reserve_cuts(crossings_.cut_points.size());
        for (std::size_t i = 0; i < crossings_.triangles.size(); ++i) {
            const CrossingTriangle& crossing = crossings_.triangles[i];
            const Triangle& t = mesh_.triangles[crossing.triangle];
            for (const SubTriangle& piece : crossing.split.sub_triangles()) {
                Lookup& find = lookup(piece.side);
                Triangle result;
                for (std::size_t corner = 0; corner < 3; ++corner) {
                    const std::uint8_t code = piece.corners[corner];
                    result[corner] = code < 3 ? find.existing(t[code]) : find.cut(crossings_, crossing, code);
                }
                builder(piece.side).add_triangle(result, mesh_.sources[crossing.triangle]);
            }
            if (i + 1 == crossings_.triangles.size() || crossings_.triangles[i + 1].group != crossing.group)
                for (SideBuilder& b : builders_) b.close_group(mesh_.groups[crossing.group]);
        }
    }

    void close_sections(Stopwatch& watch)
    {
        CutStatistics& statistics = slices_.statistics;
        materials_ = mesh_.materials;
        const std::uint32_t material = material_of_caps();
        const glm::vec3 centre = section_centre(section_);
        const double step = whole_.noise / kNoiseInUnits;
        statistics.phases[Phase::cap] += watch.lap();
        BySide<PartsOfSide> parts;
        BySide<std::vector<std::uint32_t>> piece_of_part;
        const auto piece_at = [&](Side side, std::uint32_t edge) {
            const std::uint32_t part = parts[side].part_of_edge[edge];
            return part == kNoPart ? kNoPart : piece_of_part[side][part];
        };
        std::vector<std::uint64_t> tags;
        tags.reserve(section_.edges.size());
        if (options_.split_components) {
            for (const Side side : kSides)
                parts[side] = find_parts(builders_[side], crossings_, section_, plane_, whole_.noise);
            piece_of_part = find_pieces(builders_, section_, parts, plane_);
            // Loops keep to one piece on either side: where they touch, the other way round would join pieces.
            for (std::uint32_t e = 0; e < section_.edges.size(); ++e)
                tags.push_back(std::uint64_t{piece_at(Side::negative, e)} << 32 | piece_at(Side::positive, e));
        } else {
            for (const SectionEdge& edge : section_.edges) tags.push_back(edge.solid);
        }
        statistics.phases[Phase::components] += watch.lap();

        std::vector<SectionPath> paths = link_paths(plane_, section_, tags);
        // What bounds nothing on a side is no loop to be closed.
        if (options_.split_components)
            for (SectionPath& path : paths)
                path.closed = path.closed && piece_at(Side::negative, path.edges.front()) != kNoPart &&
                              piece_at(Side::positive, path.edges.front()) != kNoPart;
        for (const SectionPath& path : paths) ++(path.closed ? statistics.section_loops : statistics.open_chains);
        slices_.section_area = area_of(section_, paths, plane_);
        BySide<std::vector<std::uint32_t>> path_of_cap;
        if (options_.build_caps) {
            const FanFacts fan = measure_fan(section_, paths, centre, plane_);
            slices_.caps_exceed_section = caps_exceed_section(fan.excess, slices_.section_area, fan.rim, step);
            for (SideBuilder& b : builders_)
                path_of_cap[b.side()] = close_with_fan(b, crossings_, section_, paths, centre, step, plane_, material);
        }
        statistics.phases[Phase::cap] += watch.lap();
        if (options_.split_components)
            for (const Side side : kSides) {
                const std::vector<std::uint32_t>& piece = piece_of_part[side];
                const auto piece_of_path = [&](std::uint32_t path) {
                    return piece_at(side, paths[path].edges.front());
                };
                is_one_piece_[side] = std::all_of(piece.begin(), piece.end(), [](std::uint32_t p) { return p == 0; });
                if (!is_one_piece_[side]) {
                    piece_of_triangle_[side].reserve(builders_[side].mesh.triangles.size());
                    for (const std::uint32_t part : parts[side].part_of_triangle)
                        piece_of_triangle_[side].push_back(piece[part]);
                    for (const std::uint32_t path : path_of_cap[side])
                        piece_of_triangle_[side].push_back(piece_of_path(path));
                }
                for (std::uint32_t path = 0; path < paths.size(); ++path)
                    piece_of_loop_[side].push_back(piece_of_path(path));
            }
        loops_.reserve(paths.size());
        for (const SectionPath& path : paths) loops_.push_back(to_loop(section_, path));
        statistics.phases[Phase::components] += watch.lap();
    }

    std::uint32_t material_of_caps()
    {
        added_cap_material_ = whole_.cap_material;
        if (options_.cap_material < materials_.size()) return options_.cap_material;
        if (added_cap_material_ == kDefaultCapMaterial) added_cap_material_ = add_cap_material(materials_);
        return added_cap_material_;
    }

    void finish()
    {
        slices_.status = slices_.statistics.open_chains == 0 ? Status::done : Status::open_section;
        slices_.statistics.crossing_triangles = crossings_.triangles.size();
        for (const CrossingTriangle& c : crossings_.triangles)
            if (mesh_.groups[c.group].kind == TriangleKind::surface) ++slices_.statistics.crossing_surface;
        // A vertex may be left without a triangle where cut points fell on corners or on one another: a piece vanished.
        const bool some_snapped =
            std::any_of(crossings_.triangles.begin(), crossings_.triangles.end(), [](const CrossingTriangle& c) {
                return c.split.next_code < 3 || c.split.previous_code != TriangleSplit::kCutPrevious;
            });

        for (SideBuilder& b : builders_) {
            slices_.statistics.vertex_comparisons += b.comparisons;
            Fragment fragment;
            fragment.noise = whole_.noise;
            fragment.cap_material = added_cap_material_;
            fragment.fan_centres = std::move(b.fan_centres);
            fragment.bounds = b.bounds.box();
            fragment.mesh = std::move(b.mesh);
            fragment.mesh.materials = materials_;
            std::vector<Fragment>& out = b.side() == Side::positive ? slices_.positive : slices_.negative;
            const Side side = b.side();
            if (!is_one_piece_[side])
                out = extract_pieces(fragment, piece_of_triangle_[side]);
            else if (some_snapped)
                out = extract_pieces(fragment, std::vector<std::uint32_t>(fragment.mesh.triangles.size(), 0));
            else
                out.push_back(std::move(fragment));
            // Every piece gets the loops that bound it, and no others: copies of all would cost pieces times loops.
            if (!options_.split_components) out.front().section = loops_;
            for (std::size_t i = 0; i < piece_of_loop_[side].size(); ++i)
                if (piece_of_loop_[side][i] != kNoPart) out[piece_of_loop_[side][i]].section.push_back(loops_[i]);
            for (Fragment& piece : out) {
                piece.release_spare_room();
                slices_.statistics.bytes_to_upload +=
                    piece.mesh.vertices.size() * sizeof(Vertex) + piece.mesh.triangles.size() * sizeof(Triangle);
            }
        }
    }

    const Fragment& whole_;
    const IndexedMesh& mesh_;
    const Plane& plane_;
    const CutOptions& options_;

    Slices slices_;
    VertexClasses classes_;
    std::vector<std::uint32_t> group_order_;
    Crossings crossings_;
    std::vector<std::uint32_t> point_table_ = std::vector<std::uint32_t>(mesh_.point_count, SideBuilder::kNone);
    BySide<SideBuilder> builders_{SideBuilder(mesh_, Side::negative, point_table_),
                                  SideBuilder(mesh_, Side::positive, point_table_)};
    Buffer<std::uint32_t> table_;  ///< remap: new index of each vertex on its own side
    BySide<Lookup> lookups_ = make_lookups();
    BySide<std::vector<EdgeInPlane>> edges_in_plane_;
    Section section_;
    std::vector<SectionLoop> loops_;
    std::vector<Material> materials_;
    std::uint32_t added_cap_material_ = kDefaultCapMaterial;
    BySide<bool> is_one_piece_{true, true};                 ///< nothing has to be taken apart
    BySide<std::vector<std::uint32_t>> piece_of_triangle_;  ///< caps included; of sides that are several
    BySide<std::vector<std::uint32_t>> piece_of_loop_;
};

}  // namespace

Slices slice(const Fragment& whole, const Plane& plane, const CutOptions& options, VertexLookup lookup)
{
    // The report's exclusion, here by the bounds: what the plane misses costs nothing.
    const auto [least, most] = plane.distance_range(whole.bounds);
    if (most <= whole.noise || least >= -whole.noise) {
        Slices missed;
        missed.statistics.triangles = whole.mesh.triangles.size();
        missed.side_of_object = most <= whole.noise ? Side::negative : Side::positive;
        return missed;
    }
    switch (lookup) {
        case VertexLookup::scan:
            return Slicer<ScanLookup>(whole, plane, options).run();
        case VertexLookup::two_bucket_hash:
            return Slicer<DictionaryLookup<TwoValuedHash>>(whole, plane, options).run();
        case VertexLookup::hash:
            return Slicer<DictionaryLookup<ProperHash>>(whole, plane, options).run();
        case VertexLookup::remap:
            return Slicer<RemapLookup>(whole, plane, options).run();
    }
    return {};
}

glm::vec3 rewrite_around_pivot(const IndexedMesh& mesh, Buffer<Vertex>& scratch)
{
    glm::dvec3 sum{0.0};
    for (const Vertex& v : mesh.vertices) sum += glm::dvec3(v.position);
    const glm::vec3 pivot(sum / std::max<double>(1.0, double(mesh.vertices.size())));
    scratch.resize(mesh.vertices.size());
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        scratch[i] = mesh.vertices[i];
        scratch[i].position -= pivot;
    }
    return pivot;
}

}  // namespace kerf::baseline
