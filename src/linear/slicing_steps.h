#pragma once

#include <algorithm>
#include <array>
#include <tuple>
#include <vector>

#include "common/cutting/back_end_helpers.h"
#include "common/cutting/cut_geometry.h"
#include "common/mesh/plane_noise.h"
#include "common/mesh/tolerances.h"
#include "common/support/order_by.h"
#include "common/support/stopwatch.h"
#include "linear/closing.h"
#include "linear/parts_and_pieces.h"
#include "linear/section.h"
#include "linear/side_builder.h"
#include "linear/slices.h"
#include "linear/vertex_sides.h"

namespace kerf::core::linear {

/// Room for the section of a small mesh is taken at once, not in steps of one, two, four and eight triangles.
constexpr std::size_t kFewCrossings = 16;

/// One cut by a loop over all triangles, step by step: what does not cross goes to its side, what crosses is divided,
/// and both sides are closed. `Self` derives from this and adds what differs from lookup to lookup:
///   classify_vertices()            fills `classes_`
///   distribute(group)              triangles of a group of which no vertex is on the plane
///   expect_cut_points(count)       before the first vertex at a cut point is asked for
///   lookup(side)                   the side's Lookup (vertex_lookup.h)
/// and may replace pieces_of(parts).
template <class Self>
class Slicer
{
public:
    Slicer(const Fragment& whole, const Plane& plane, const CutOptions& options, Closing& closing)
        : whole_(whole), mesh_(whole.mesh), plane_(plane), options_(options), closing_(closing)
    {
    }

    Slices run()
    {
        Stopwatch watch;
        PhaseTimes& phases = slices_.statistics.phases;
        slices_.statistics.triangles = slices_.statistics.triangles_touched = mesh_.triangles.size();
        self().classify_vertices();
        phases[Phase::find] += watch.lap();
        if (classes_.one_side_is_empty()) return missed(classes_.far_above == 0 ? Side::negative : Side::positive);
        distribute_triangles();
        phases[Phase::copy] += watch.lap();
        split_crossing_triangles(mesh_, plane_, crossings_);
        add_sub_triangles();
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

protected:
    Self& self() { return static_cast<Self&>(*this); }

    Slices missed(Side side)
    {
        slices_.side_of_object = side;
        return std::move(slices_);
    }

    SideBuilder& builder(Side side) { return builders_[side]; }

    std::uint8_t class_of(const Triangle& t) const
    {
        const std::uint8_t* c = classes_.of_vertex.data();
        return static_cast<std::uint8_t>(c[t[0]] | c[t[1]] | c[t[2]]);
    }

    /// The report's loop: what the plane does not cross goes to its side, what it crosses is remembered.
    void distribute_triangles()
    {
        // Groups of one kind, material and solid one after the other, so that they stay together however often they are
        // cut.
        crossings_.triangles.reserve(kFewCrossings);
        order_by(group_order_, mesh_.groups.size(), [&](std::uint32_t g) {
            const TriangleGroup& group = mesh_.groups[g];
            return std::tie(group.kind, group.material, group.solid);
        });
        for (const std::uint32_t g : group_order_) {
            if (classes_.on > 0)
                distribute_with_vertices_on_plane(g);
            else
                self().distribute(g);
            for (SideBuilder& b : builders_) b.close_group(mesh_.groups[g]);
        }
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
        auto& find = self().lookup(side);
        builder(side).add_triangle({find.existing(t[0]), find.existing(t[1]), find.existing(t[2])},
                                   mesh_.sources[triangle]);
    }

    void add_sub_triangles()
    {
        for (SideBuilder& b : builders_) b.set_cut_point_count(crossings_.cut_points.size());
        self().expect_cut_points(crossings_.cut_points.size());
        for (std::size_t i = 0; i < crossings_.triangles.size(); ++i) {
            const CrossingTriangle& crossing = crossings_.triangles[i];
            const Triangle& t = mesh_.triangles[crossing.triangle];
            for (const SubTriangle& sub : crossing.split.sub_triangles()) {
                auto& find = self().lookup(sub.side);
                Triangle result;
                for (std::size_t corner = 0; corner < 3; ++corner) {
                    const std::uint8_t code = sub.corners[corner];
                    result[corner] = code < 3 ? find.existing(t[code]) : find.cut(crossings_, crossing, code);
                }
                builder(sub.side).add_triangle(result, mesh_.sources[crossing.triangle]);
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
        statistics.phases[Phase::cap] += watch.lap();
        BySide<FoundParts> parts;
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
            piece_of_part = self().pieces_of(parts);
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
        const ClosedSides closed =
            closing_.close(builders_, crossings_,
                           {section_, paths, tags, plane_, slices_.section_area, whole_.noise / kNoiseInUnits, material,
                            options_.cap_uv_scale, options_.cap_quality, options_.build_caps});
        slices_.caps_exceed_section = closed.caps_exceed_section;
        statistics.cap_steps = closed.steps;
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
                    for (const std::uint32_t path : closed.path_of_cap[side])
                        piece_of_triangle_[side].push_back(piece_of_path(path));
                }
                for (std::uint32_t path = 0; path < paths.size(); ++path)
                    piece_of_loop_[side].push_back(piece_of_path(path));
            }
        loops_.reserve(paths.size());
        for (const SectionPath& path : paths) loops_.push_back(to_loop(section_, path));
        statistics.phases[Phase::components] += watch.lap();
    }

    /// The piece of each part; who knows better has one of his own.
    BySide<std::vector<std::uint32_t>> pieces_of(const BySide<FoundParts>& parts)
    {
        return find_pieces(builders_, section_, parts, plane_);
    }

    std::uint32_t material_of_caps()
    {
        added_cap_material_ = whole_.cap_material;
        if (!options_.build_caps || options_.cap_material < materials_.size()) return options_.cap_material;
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
            slices_.vertex_comparisons += b.comparisons;
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
                closing_.finish(piece, plane_);
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
    Closing& closing_;

    Slices slices_;
    VertexSides classes_;
    std::vector<std::uint32_t> group_order_;
    Crossings crossings_;
    std::vector<std::uint32_t> point_table_ = std::vector<std::uint32_t>(mesh_.point_count, kNone);
    BySide<SideBuilder> builders_{SideBuilder(mesh_, Side::negative, point_table_),
                                  SideBuilder(mesh_, Side::positive, point_table_)};
    BySide<std::vector<EdgeInPlane>> edges_in_plane_;
    Section section_;
    std::vector<SectionLoop> loops_;
    std::vector<Material> materials_;
    std::uint32_t added_cap_material_ = kDefaultCapMaterial;
    BySide<bool> is_one_piece_{true, true};                 ///< nothing has to be taken apart
    BySide<std::vector<std::uint32_t>> piece_of_triangle_;  ///< caps included; of sides that are several
    BySide<std::vector<std::uint32_t>> piece_of_loop_;
};

}  // namespace kerf::core::linear
