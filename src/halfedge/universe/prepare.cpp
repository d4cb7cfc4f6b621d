#include <algorithm>
#include <cmath>
#include <numeric>

#include "common/mesh/mass_properties.h"
#include "common/mesh/plane.h"
#include "halfedge/universe/universe.h"

namespace kerf::halfedge {

namespace {

/// Shell of each triangle, numbered in the order of their first triangles. Triangles around a point form one fan, so
/// connected by points means connected by edges.
struct Shells
{
    std::vector<Index> of_triangle;
    Index count = 0;
};

Shells find_shells(const IndexedMesh& mesh)
{
    std::vector<Index> parent(mesh.point_count);
    std::iota(parent.begin(), parent.end(), Index(0));
    const auto find = [&](Index p) {
        while (parent[p] != p) p = parent[p] = parent[parent[p]];
        return p;
    };
    for (const Triangle& t : mesh.triangles) {
        const Index a = find(mesh.points[t[0]]);
        parent[find(mesh.points[t[1]])] = a;
        parent[find(mesh.points[t[2]])] = a;
    }
    Shells shells;
    shells.of_triangle.resize(mesh.triangles.size());
    std::vector<Index> number(mesh.point_count, kNone);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        Index& shell = number[find(mesh.points[mesh.triangles[i][0]])];
        if (shell == kNone) shell = shells.count++;
        shells.of_triangle[i] = shell;
    }
    return shells;
}

/// Spreads the low 12 bits to every third bit.
std::uint64_t spread(std::uint64_t v)
{
    v = (v | (v << 16)) & 0xff0000ffu;
    v = (v | (v << 8)) & 0xf00f00fu;
    v = (v | (v << 4)) & 0xc30c30c3u;
    v = (v | (v << 2)) & 0x249249249u;
    return v;
}

constexpr std::uint32_t kMortonBits = 12;  // for each axis
constexpr std::uint32_t kMortonCells = 1u << kMortonBits;

/// One pass of a stable counting sort: `order` by key(item) < keys.
template <class Item, class Key>
void counting_sort(std::vector<Item>& order, std::vector<Item>& scratch, std::size_t keys, Key key)
{
    std::vector<std::uint32_t> start(keys + 1, 0);
    for (const Item& item : order) ++start[key(item) + 1];
    std::partial_sum(start.begin(), start.end(), start.begin());
    scratch.resize(order.size());
    for (const Item& item : order) scratch[start[key(item)]++] = item;
    order.swap(scratch);
}

/// Triangles by (group, shell, Morton code of the centre).
std::vector<Index> spatial_order(const IndexedMesh& mesh, const std::vector<Index>& group_of, std::size_t groups,
                                 const Shells& shells)
{
    const Box box = mesh.bounds();
    const glm::dvec3 size = glm::dvec3(box.hi) - glm::dvec3(box.lo);
    const double longest = std::max({size.x, size.y, size.z});
    const double scale = longest > 0.0 ? (kMortonCells - 1) / (3.0 * longest) : 0.0;

    struct Item
    {
        std::uint64_t code;
        Index triangle;
    };
    std::vector<Item> items(mesh.triangles.size()), scratch;
    for (std::size_t i = 0; i < items.size(); ++i) {
        const Triangle& t = mesh.triangles[i];
        const glm::dvec3 centre = (glm::dvec3(mesh.vertices[t[0]].position) - glm::dvec3(box.lo)) +
                                  (glm::dvec3(mesh.vertices[t[1]].position) - glm::dvec3(box.lo)) +
                                  (glm::dvec3(mesh.vertices[t[2]].position) - glm::dvec3(box.lo));
        const glm::dvec3 cell = centre * scale;
        items[i].code =
            spread(std::uint64_t(cell.x)) | (spread(std::uint64_t(cell.y)) << 1) | (spread(std::uint64_t(cell.z)) << 2);
        items[i].triangle = static_cast<Index>(i);
    }
    for (std::uint32_t shift = 0; shift < 3 * kMortonBits; shift += kMortonBits)
        counting_sort(items, scratch, kMortonCells,
                      [shift](const Item& item) { return (item.code >> shift) & (kMortonCells - 1); });
    if (shells.count > 1)
        counting_sort(items, scratch, shells.count,
                      [&](const Item& item) { return shells.of_triangle[item.triangle]; });
    if (groups > 1) counting_sort(items, scratch, groups, [&](const Item& item) { return group_of[item.triangle]; });

    std::vector<Index> order(items.size());
    for (std::size_t i = 0; i < items.size(); ++i) order[i] = items[i].triangle;
    return order;
}

/// For each half-edge (3 * triangle + corner, leaving that corner's point) its opposite, or kNone. Half-edges are
/// bucketed by their smaller point: no hashing.
std::vector<Index> find_twins(const std::vector<Triangle>& points, std::size_t point_count)
{
    const std::size_t n = points.size() * 3;
    const auto ends = [&](Index h) {
        const Triangle& t = points[h / 3];
        return std::array{t[h % 3], t[(h % 3 + 1) % 3]};
    };
    std::vector<std::uint32_t> start(point_count + 1, 0);
    for (const Triangle& t : points) {
        ++start[std::min(t[0], t[1]) + 1];
        ++start[std::min(t[1], t[2]) + 1];
        ++start[std::min(t[2], t[0]) + 1];
    }
    std::partial_sum(start.begin(), start.end(), start.begin());
    struct Entry
    {
        Index larger, halfedge;
    };
    std::vector<Entry> entries(n);
    for (Index i = 0; i < points.size(); ++i)
        for (Index c = 0; c < 3; ++c) {
            const Index a = points[i][c], b = points[i][c == 2 ? 0 : c + 1];
            entries[start[std::min(a, b)]++] = {std::max(a, b), i * 3 + c};
        }

    std::vector<Index> twin(n, kNone);
    std::uint32_t begin = 0;
    for (std::size_t p = 0; p < point_count; ++p) {
        const std::uint32_t end = start[p];  // the filling has moved each start to its end
        constexpr std::uint32_t kFew = 64;
        const bool sorted = end - begin > kFew;
        if (sorted)
            std::sort(entries.begin() + begin, entries.begin() + end, [](const Entry& s, const Entry& t) {
                return s.larger != t.larger ? s.larger < t.larger : s.halfedge < t.halfedge;
            });
        for (std::uint32_t i = begin; i < end; ++i) {
            if (twin[entries[i].halfedge] != kNone) continue;
            const bool forward = ends(entries[i].halfedge)[0] == p;
            for (std::uint32_t j = i + 1; j < end; ++j) {
                if (entries[j].larger != entries[i].larger) {
                    if (sorted) break;
                    continue;
                }
                if (twin[entries[j].halfedge] != kNone || (ends(entries[j].halfedge)[0] == p) == forward) continue;
                twin[entries[i].halfedge] = entries[j].halfedge;
                twin[entries[j].halfedge] = entries[i].halfedge;
                break;
            }
        }
        begin = end;
    }
    return twin;
}

/// Connectivity without searching: faces, edges in the order of their first half-edge, boundary linked at its vertices.
void build_connectivity(Universe& u, const std::vector<Triangle>& points, const std::vector<Index>& twin)
{
    SurfaceMesh& mesh = u.mesh;
    std::vector<Index> id(twin.size());
    Index edges = 0;
    for (Index h = 0; h < twin.size(); ++h) {
        if (twin[h] != kNone && twin[h] < h) {
            id[h] = id[twin[h]] ^ 1u;
        } else {
            id[h] = 2 * edges++;
        }
    }
    for (Index f = 0; f < points.size(); ++f) {
        const Index* h = &id[std::size_t{3} * f];
        mesh.set_triangle(f, h[0], h[1], h[2]);
        for (Index c = 0; c < 3; ++c) {
            mesh.set_to(h[c], points[f][c == 2 ? 0 : c + 1]);
            mesh.set_halfedge_of_vertex(points[f][c], h[c]);
        }
    }
    std::vector<Index> boundary;
    for (Index h = 0; h < twin.size(); ++h) {
        if (twin[h] != kNone) continue;
        const Index outer = id[h] ^ 1u;
        mesh.set_to(outer, points[h / 3][h % 3]);
        mesh.set_halfedge_of_vertex(mesh.to(id[h]), outer);
        boundary.push_back(outer);
    }
    for (const Index h : boundary) mesh.link(h, mesh.halfedge_of_vertex(mesh.to(h)));
}

}  // namespace

Universe::Universe(const Universe& other)
    : mesh(other.mesh),
      vertices(other.vertices),
      streams(other.streams),
      slots(other.slots),
      face_of_slot(other.face_of_slot),
      source_of_face(other.source_of_face),
      stamp_of_face(other.stamp_of_face),
      stamp_base(other.stamp_base),
      tree(other.tree),
      groups(other.groups),
      materials(other.materials),
      cap_material(other.cap_material),
      reference(other.reference),
      noise(other.noise),
      has_boundary(other.has_boundary),
      live_slots(0)
{
}

std::size_t Universe::bytes_reserved() const
{
    std::size_t bytes = mesh.bytes_reserved() + vertices.bytes_reserved() + slots.bytes_reserved() +
                        face_of_slot.bytes_reserved() + source_of_face.bytes_reserved() +
                        stamp_of_face.bytes_reserved() + tree.bytes_reserved();
    for (const Stream& stream : streams) bytes += stream.values.bytes_reserved();
    return bytes;
}

std::size_t reserved_crossings(std::size_t triangles)
{
    return 256 + static_cast<std::size_t>(24.0 * std::sqrt(static_cast<double>(triangles)));
}

std::size_t crossings_of_one_cut(std::size_t triangles)
{
    return 64 + static_cast<std::size_t>(4.0 * std::sqrt(static_cast<double>(triangles)));
}

void reserve_for_cuts(Universe& u, std::size_t crossings)
{
    // Per crossing triangle: what a regular cut adds to connectivity exactly; what it rewrites about.
    u.mesh.reserve(u.mesh.vertices() + 2 * crossings, u.mesh.edges() + 6 * crossings, u.mesh.faces() + 4 * crossings);
    u.vertices.reserve(u.vertices.size() + 3 * crossings);
    for (Stream& stream : u.streams) stream.values.reserve(stream.values.size() + 3 * crossings * stream.width);
    u.slots.reserve(u.slots.size() + 18 * crossings);
    u.face_of_slot.reserve(u.face_of_slot.size() + 18 * crossings);
    u.source_of_face.reserve(u.source_of_face.size() + 4 * crossings);
    u.stamp_of_face.reserve(u.stamp_of_face.size() + 4 * crossings);
    u.tree.reserve(u.tree.nodes.size() + crossings + crossings / 4 + 64);
}

std::vector<ShellRoot> prepare_universe(const ProvenMesh& proven, Universe& u)
{
    const IndexedMesh& mesh = proven;
    const std::size_t n = mesh.triangles.size();
    const Box bounds = mesh.bounds();
    u.reference = mass_reference(bounds);
    u.noise = plane_noise(bounds.largest_coordinate());
    u.materials = mesh.materials;

    // Groups in the order in which ranges are drawn.
    for (const TriangleGroup& g : mesh.groups) u.groups.push_back({g.material, g.solid, g.kind});
    std::sort(u.groups.begin(), u.groups.end(), draws_before);
    const auto is_alike = [](const DrawGroup& a, const DrawGroup& b) {
        return !draws_before(a, b) && !draws_before(b, a);
    };
    u.groups.erase(std::unique(u.groups.begin(), u.groups.end(), is_alike), u.groups.end());
    std::vector<Index> group_of(n);
    for (const TriangleGroup& g : mesh.groups) {
        const DrawGroup wanted{g.material, g.solid, g.kind};
        const auto found = std::lower_bound(u.groups.begin(), u.groups.end(), wanted, draws_before);
        std::fill_n(group_of.begin() + g.first, g.count, static_cast<Index>(found - u.groups.begin()));
    }

    const Shells shells = find_shells(mesh);
    const std::vector<Index> order = spatial_order(mesh, group_of, u.groups.size(), shells);

    // Vertices and points in the order of their first use.
    std::vector<Index> new_vertex(mesh.vertices.size(), kNone), old_vertex, new_point(mesh.point_count, kNone);
    old_vertex.reserve(mesh.vertices.size());
    std::vector<Triangle> corner_points(n);
    Index point_count = 0;
    u.slots.reserve(n);
    for (std::size_t i = 0; i < n; ++i) {
        const Triangle& t = mesh.triangles[order[i]];
        for (int c = 0; c < 3; ++c) {
            if (new_vertex[t[c]] == kNone) {
                new_vertex[t[c]] = static_cast<Index>(old_vertex.size());
                old_vertex.push_back(t[c]);
            }
            u.slots[i][c] = new_vertex[t[c]];
            Index& point = new_point[mesh.points[t[c]]];
            if (point == kNone) point = point_count++;
            corner_points[i][c] = point;
        }
    }
    u.slots.set_size(n);

    const std::vector<Index> twin = find_twins(corner_points, point_count);
    std::size_t edges = 0;
    for (Index h = 0; h < twin.size(); ++h) {
        edges += twin[h] == kNone || twin[h] > h;
        u.has_boundary |= twin[h] == kNone;
    }

    // Sizes are known: reserve once, room for cuts included, then fill.
    const std::size_t crossings = reserved_crossings(n);
    u.mesh.reserve(point_count + 2 * crossings, edges + 6 * crossings, n + 4 * crossings);
    u.mesh.resize(point_count, edges, n);
    u.vertices.set_size(0);
    u.vertices.reserve(old_vertex.size() + 3 * crossings);
    u.vertices.set_size(old_vertex.size());
    u.face_of_slot.reserve(n + 18 * crossings);
    u.face_of_slot.set_size(n);
    u.source_of_face.reserve(n + 4 * crossings);
    u.source_of_face.set_size(n);
    u.stamp_of_face.reserve(n + 4 * crossings);
    u.stamp_of_face.set_size(n);

    build_connectivity(u, corner_points, twin);
    for (std::size_t i = 0; i < n; ++i) {
        u.face_of_slot[i] = static_cast<Index>(i);
        u.source_of_face[i] = mesh.sources[order[i]];
        for (int c = 0; c < 3; ++c)
            u.mesh.set_point(corner_points[i][c], mesh.vertices[old_vertex[u.slots[i][c]]].position);
    }
    for (std::size_t v = 0; v < old_vertex.size(); ++v) u.vertices[v] = mesh.vertices[old_vertex[v]];
    for (const VertexStream& stream : mesh.streams) {
        Stream& copy = u.streams.emplace_back();
        copy.name = stream.name;
        copy.width = stream.width;
        copy.values.reserve((old_vertex.size() + 3 * crossings) * stream.width);
        copy.values.set_size(old_vertex.size() * stream.width);
        for (std::size_t v = 0; v < old_vertex.size(); ++v) {
            const std::size_t from = std::size_t{old_vertex[v]} * stream.width;
            std::copy_n(&stream.values[from], stream.width, &copy.values[v * stream.width]);
        }
    }

    // One subtree for each run of slots of the same group and shell; the runs of a shell meet at its root.
    std::vector<ShellRoot> roots(shells.count);
    std::size_t nodes = 0;
    const auto for_each_run = [&](auto visit) {
        for (std::size_t first = 0, last; first < n; first = last) {
            const Index g = group_of[order[first]], s = shells.of_triangle[order[first]];
            last = first;
            while (last < n && group_of[order[last]] == g && shells.of_triangle[order[last]] == s) ++last;
            visit(static_cast<Index>(first), static_cast<Index>(last - first), g, s);
        }
    };
    for_each_run([&](Index, std::size_t count, Index, Index) { nodes += 2 * ((count - 1) / kLeafTriangles + 1); });
    u.tree.reserve(nodes + crossings + crossings / 4 + 64);
    for_each_run([&](Index first, Index count, Index g, Index s) {
        ShellRoot& shell = roots[s];
        shell.root = u.tree.join(shell.root, u.tree.make_run(u.geometry(), first, count, g));
        shell.solid = u.groups[g].solid;
    });

    reserve_for_cuts(u, crossings);
    return roots;
}

}  // namespace kerf::halfedge
