#include "support/wrong_meshes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

#include "common/shapes/shapes.h"

namespace kerf::core::test {

namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN(), kInfinity = std::numeric_limits<float>::infinity();
constexpr std::uint32_t kMost = std::numeric_limits<std::uint32_t>::max();

template <class List>
auto& any_of(List& list, Random& random)
{
    return list[random.below(static_cast<std::uint32_t>(list.size()))];
}

float no_number(Random& random)
{
    return std::array{kNan, kInfinity, -kInfinity}[random.below(3)];
}

/// A number that is not small: beyond the last, far beyond, or the largest there is.
std::uint32_t beyond(std::size_t last, Random& random)
{
    const auto first = static_cast<std::uint32_t>(last);
    switch (random.below(4)) {
        case 0:
            return first;
        case 1:
            return first + random.below(1000);
        case 2:
            return kMost - random.below(4);
        default:
            return std::max(first, static_cast<std::uint32_t>(random.next()));
    }
}

/// Takes out the vertices that no triangle uses, and the ids of points without a vertex.
void drop_unused(IndexedMesh& mesh)
{
    Buffer<std::uint32_t> new_vertex(mesh.vertices.size(), kMost), new_point(mesh.point_count, kMost), points;
    Buffer<Vertex> vertices;
    std::vector<Buffer<float>> values(mesh.streams.size());
    mesh.point_count = 0;
    for (Triangle& triangle : mesh.triangles)
        for (std::uint32_t& v : triangle) {
            if (new_vertex[v] == kMost) {
                new_vertex[v] = static_cast<std::uint32_t>(vertices.size());
                vertices.push_back(mesh.vertices[v]);
                std::uint32_t& point = new_point[mesh.points[v]];
                if (point == kMost) point = mesh.point_count++;
                points.push_back(point);
                for (std::size_t s = 0; s < values.size(); ++s)
                    for (std::uint32_t i = 0; i < mesh.streams[s].width; ++i)
                        values[s].push_back(mesh.streams[s].values[std::size_t{v} * mesh.streams[s].width + i]);
            }
            v = new_vertex[v];
        }
    mesh.vertices = std::move(vertices);
    mesh.points = std::move(points);
    for (std::size_t s = 0; s < values.size(); ++s) mesh.streams[s].values = std::move(values[s]);
}

/// One more triangle, in the last group.
void add_triangle(IndexedMesh& mesh, const Triangle& triangle)
{
    mesh.triangles.push_back(triangle);
    mesh.sources.push_back(0);
    ++mesh.groups.back().count;
}

/// The triangle leaves its group.
void remove_triangle(IndexedMesh& mesh, std::uint32_t t)
{
    mesh.triangles.erase(mesh.triangles.begin() + t);
    mesh.sources.erase(mesh.sources.begin() + t);
    for (TriangleGroup& group : mesh.groups) {
        if (group.first > t)
            --group.first;
        else if (t - group.first < group.count)
            --group.count;
    }
}

/// One more vertex, for the point `point`.
std::uint32_t add_vertex(IndexedMesh& mesh, const glm::vec3& position, std::uint32_t point)
{
    mesh.vertices.push_back({position, {0.0f, 0.0f, 1.0f}, {0.0f, 0.0f}});
    mesh.points.push_back(point);
    for (VertexStream& stream : mesh.streams) stream.values.resize(stream.values.size() + stream.width, 0.5f);
    return static_cast<std::uint32_t>(mesh.vertices.size() - 1);
}

void set_all_positions(IndexedMesh& mesh, const Buffer<glm::vec3>& position_of_point)
{
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
        mesh.vertices[v].position = position_of_point[mesh.points[v]] + 0.0f;
}

Buffer<glm::vec3> positions_of_points(const IndexedMesh& mesh)
{
    Buffer<glm::vec3> positions(mesh.point_count);
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) positions[mesh.points[v]] = mesh.vertices[v].position;
    return positions;
}

void scale(IndexedMesh& mesh, float factor)
{
    for (Vertex& v : mesh.vertices) v.position = v.position * factor + 0.0f;
}

void index_out_of_range(IndexedMesh& mesh, Random& random)
{
    any_of(mesh.triangles, random)[random.below(3)] = beyond(mesh.vertices.size(), random);
}

void point_out_of_range(IndexedMesh& mesh, Random& random)
{
    any_of(mesh.points, random) = beyond(mesh.point_count, random);
}

void point_count_too_small(IndexedMesh& mesh, Random& random)
{
    mesh.point_count = random.below(mesh.point_count);
}

void point_count_too_large(IndexedMesh& mesh, Random& random)
{
    mesh.point_count = beyond(mesh.point_count + 1, random);
}

void ids_with_a_gap(IndexedMesh& mesh, Random& random)
{
    const std::uint32_t gap = random.below(mesh.point_count);
    for (std::uint32_t& point : mesh.points) point += point >= gap;
    ++mesh.point_count;
}

void unused_vertex(IndexedMesh& mesh, Random& random)
{
    const bool of_its_own = random.below(2) == 0;
    add_vertex(mesh, of_its_own ? glm::vec3(1, 2, 3) : mesh.vertices[0].position,
               of_its_own ? mesh.point_count++ : mesh.points[0]);
}

void wrong_number_of_points(IndexedMesh& mesh, Random& random)
{
    mesh.points.resize(random.below(2) == 0 ? random.below(static_cast<std::uint32_t>(mesh.points.size()))
                                            : mesh.points.size() + 1 + random.below(5),
                       0u);
}

void wrong_number_of_sources(IndexedMesh& mesh, Random& random)
{
    mesh.sources.resize(random.below(2) == 0 ? random.below(static_cast<std::uint32_t>(mesh.sources.size()))
                                             : mesh.sources.size() + 1 + random.below(5),
                        0u);
}

void groups_with_a_gap(IndexedMesh& mesh, Random& random)
{
    any_of(mesh.groups, random).first += 1 + random.below(3);
}

void groups_that_are_too_short(IndexedMesh& mesh, Random&)
{
    --mesh.groups.back().count;
}

void groups_that_overflow(IndexedMesh& mesh, Random& random)
{
    TriangleGroup& group = any_of(mesh.groups, random);
    (random.below(2) == 0 ? group.first : group.count) = kMost - random.below(3);
}

void no_groups(IndexedMesh& mesh, Random&)
{
    mesh.groups.clear();
}

void material_out_of_range(IndexedMesh& mesh, Random& random)
{
    any_of(mesh.groups, random).material = beyond(mesh.materials.size(), random);
}

void wild_kind(IndexedMesh& mesh, Random& random)
{
    any_of(mesh.groups, random).kind = static_cast<TriangleKind>(2 + random.below(254));
}

void coordinate_without_number(IndexedMesh& mesh, Random& random)
{
    any_of(mesh.vertices, random).position[static_cast<int>(random.below(3))] = no_number(random);
}

void negative_zero(IndexedMesh& mesh, Random& random)
{
    const std::uint32_t point = any_of(mesh.points, random);
    const int axis = static_cast<int>(random.below(3));
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
        if (mesh.points[v] == point) mesh.vertices[v].position[axis] = -0.0f;
}

void normal_without_number(IndexedMesh& mesh, Random& random)
{
    any_of(mesh.vertices, random).normal[static_cast<int>(random.below(3))] = no_number(random);
}

void uv_without_number(IndexedMesh& mesh, Random& random)
{
    any_of(mesh.vertices, random).uv[static_cast<int>(random.below(2))] = no_number(random);
}

void position_that_differs_within_a_point(IndexedMesh& mesh, Random& random)
{
    const std::uint32_t v = random.below(static_cast<std::uint32_t>(mesh.vertices.size()));
    const glm::vec3 p = mesh.vertices[v].position;
    const std::uint32_t moved =
        add_vertex(mesh, {std::nextafter(p.x, random.below(2) == 0 ? 1e30f : -1e30f) + 0.0f, p.y, p.z}, mesh.points[v]);
    // Used by one of the triangles there.
    for (Triangle& triangle : mesh.triangles)
        for (std::uint32_t& corner : triangle)
            if (corner == v) {
                corner = moved;
                return;
            }
}

void two_corners_at_one_position(IndexedMesh& mesh, Random& random)
{
    Triangle& triangle = any_of(mesh.triangles, random);
    triangle[random.below(2)] = triangle[2];
}

/// As a file may name a stream: long, of any bytes.
std::string wild_name(Random& random)
{
    std::string name(1 + random.below(2000), 'x');
    for (std::uint32_t i = random.below(20); i > 0; --i) any_of(name, random) = static_cast<char>(random.below(256));
    return name;
}

void stream_too_short(IndexedMesh& mesh, Random& random)
{
    mesh.streams.push_back({wild_name(random), 1 + random.below(4), {}});
    VertexStream& stream = mesh.streams.back();
    stream.values.resize(
        mesh.vertices.size() * stream.width - 1 - random.below(static_cast<std::uint32_t>(mesh.vertices.size())), 0.0f);
}

void stream_too_long(IndexedMesh& mesh, Random& random)
{
    mesh.streams.push_back({"long", 1 + random.below(4), {}});
    mesh.streams.back().values.resize(mesh.vertices.size() * mesh.streams.back().width + 1 + random.below(9), 0.0f);
}

void stream_of_wild_width(IndexedMesh& mesh, Random& random)
{
    mesh.streams.push_back({"wild", random.below(2) == 0 ? 0 : beyond(1000, random), {}});
    mesh.streams.back().values.resize(random.below(2) == 0 ? 0 : mesh.vertices.size(), 0.0f);
}

void triangle_turned_over(IndexedMesh& mesh, Random& random)
{
    // It must meet another one, or nothing is wrong with it.
    Triangle& triangle = any_of(mesh.triangles, random);
    std::swap(triangle[1], triangle[2]);
}

void triangle_twice(IndexedMesh& mesh, Random& random)
{
    const Triangle& t = any_of(mesh.triangles, random);
    const std::uint32_t turn = random.below(3);
    add_triangle(mesh, {t[turn], t[(turn + 1) % 3], t[(turn + 2) % 3]});
}

void cube_with_one_turned_over_and_one_twice(IndexedMesh& mesh, Random& random)
{
    mesh = repaired(shapes::box({1, 1, 1}, {1, 1, 1}));
    triangle_turned_over(mesh, random);
    triangle_twice(mesh, random);
}

void third_triangle_at_an_edge(IndexedMesh& mesh, Random& random)
{
    const Triangle& t = any_of(mesh.triangles, random);
    const std::uint32_t from = random.below(3), a = t[from], b = t[(from + 1) % 3];
    const std::uint32_t tip = add_vertex(mesh, {0.25f, 3.0f, 0.125f}, mesh.point_count++);
    add_triangle(mesh, random.below(2) == 0 ? Triangle{a, b, tip} : Triangle{b, a, tip});
}

void two_triangles_at_a_point(IndexedMesh& mesh, Random& random)
{
    const std::uint32_t middle = any_of(mesh.triangles, random)[random.below(3)];
    const std::uint32_t a = add_vertex(mesh, {5, 1, 1}, mesh.point_count++);
    const std::uint32_t b = add_vertex(mesh, {5, 2, 1}, mesh.point_count++);
    add_triangle(mesh, {middle, a, b});
}

void two_points_made_one(IndexedMesh& mesh, Random& random)
{
    const std::uint32_t kept = random.below(mesh.point_count), last = mesh.point_count - 1;
    glm::vec3 place(0.0f);
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
        if (mesh.points[v] == kept) place = mesh.vertices[v].position;
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
        if (mesh.points[v] == last) {
            mesh.points[v] = kept;
            mesh.vertices[v].position = place;
        }
    if (kept != last) --mesh.point_count;
}

void solids_that_share_an_edge(IndexedMesh& mesh, Random& random)
{
    // A group for each triangle, one of them with a solid of its own.
    std::vector<TriangleGroup> groups;
    for (const TriangleGroup& group : mesh.groups)
        for (std::uint32_t i = 0; i < group.count; ++i)
            groups.push_back({group.first + i, 1, group.material, group.solid, group.kind});
    any_of(groups, random).solid += 1 + random.below(kMost - 1);
    mesh.groups = std::move(groups);
}

void moved_away(IndexedMesh& mesh, Random&)
{
    const IndexedMesh elsewhere = std::move(mesh);
}

void no_triangles(IndexedMesh& mesh, Random& random)
{
    mesh.triangles.clear();
    mesh.sources.clear();
    if (random.below(2) == 0) mesh.groups.clear();
    for (TriangleGroup& group : mesh.groups) group = {0, 0, group.material, group.solid, group.kind};
}

void no_vertices(IndexedMesh& mesh, Random&)
{
    mesh.vertices.clear();
    mesh.points.clear();
    mesh.point_count = 0;
    for (VertexStream& stream : mesh.streams) stream.values.clear();
}

void wild_sources(IndexedMesh& mesh, Random& random)
{
    for (std::uint32_t& source : mesh.sources) source = beyond(0, random);
}

void wild_solids(IndexedMesh& mesh, Random& random)
{
    // The same solids under other numbers.
    const std::uint32_t key = static_cast<std::uint32_t>(random.next());
    for (TriangleGroup& group : mesh.groups) group.solid ^= key;
}

void caps_from_before(IndexedMesh& mesh, Random& random)
{
    for (TriangleGroup& group : mesh.groups) group.kind = static_cast<TriangleKind>(random.below(2));
}

void huge_coordinates(IndexedMesh& mesh, Random& random)
{
    scale(mesh, std::ldexp(1.0f, 100 + static_cast<int>(random.below(26))));
}

/// The largest coordinate becomes the largest float there is.
void coordinates_up_to_the_largest(IndexedMesh& mesh, Random&)
{
    constexpr double kLargest = std::numeric_limits<float>::max();
    const double factor = kLargest / mesh.bounds().largest_coordinate();
    for (Vertex& v : mesh.vertices)
        for (int axis = 0; axis < 3; ++axis)
            v.position[axis] = float(std::clamp(v.position[axis] * factor, -kLargest, kLargest)) + 0.0f;
}

void points_at_the_end_of_the_range(IndexedMesh& mesh, Random& random)
{
    constexpr float kLargest = std::numeric_limits<float>::max();
    Buffer<glm::vec3> positions = positions_of_points(mesh);
    for (glm::vec3& p : positions)
        for (int axis = 0; axis < 3; ++axis)
            p[axis] = std::array{-kLargest, kLargest, -0.5f * kLargest, 0.0f, p[axis]}[random.below(5)];
    set_all_positions(mesh, positions);
}

void tiny_coordinates(IndexedMesh& mesh, Random& random)
{
    scale(mesh, std::ldexp(1.0f, -120 - static_cast<int>(random.below(32))));
}

void far_from_the_origin(IndexedMesh& mesh, Random& random)
{
    const float far = std::ldexp(1.0f, static_cast<int>(random.below(26)));
    for (Vertex& v : mesh.vertices) v.position += glm::vec3(far, -far, 0.0f);
}

void points_at_one_place(IndexedMesh& mesh, Random& random)
{
    Buffer<glm::vec3> positions = positions_of_points(mesh);
    for (std::uint32_t i = 0; i < 3; ++i) any_of(positions, random) = any_of(positions, random);
    set_all_positions(mesh, positions);
}

void positions_on_a_coarse_grid(IndexedMesh& mesh, Random& random)
{
    Buffer<glm::vec3> positions = positions_of_points(mesh);
    for (glm::vec3& p : positions)
        for (int axis = 0; axis < 3; ++axis) p[axis] = 0.5f * static_cast<float>(random.below(5));
    set_all_positions(mesh, positions);
}

void any_positions(IndexedMesh& mesh, Random& random)
{
    Buffer<glm::vec3> positions = positions_of_points(mesh);
    for (glm::vec3& p : positions)
        for (int axis = 0; axis < 3; ++axis) {
            const auto bits = static_cast<std::uint32_t>(random.next());
            std::memcpy(&p[axis], &bits, sizeof bits);
            if (!std::isfinite(p[axis])) p[axis] = 0.0f;
        }
    set_all_positions(mesh, positions);
}

void streams_without_number(IndexedMesh& mesh, Random& random)
{
    mesh.streams.push_back({"holes", 2, {}});
    for (std::size_t i = 0; i < 2 * mesh.vertices.size(); ++i)
        mesh.streams.back().values.push_back(random.below(3) == 0 ? no_number(random) : 1.0f);
}

void streams_of_great_width(IndexedMesh& mesh, Random& random)
{
    mesh.streams.push_back({"", 30 + random.below(100), {}});
    mesh.streams.back().values.resize(mesh.vertices.size() * mesh.streams.back().width, 0.5f);
}

void normals_of_any_length(IndexedMesh& mesh, Random& random)
{
    for (Vertex& v : mesh.vertices)
        v.normal *= std::array{0.0f, 1e-40f, 1e-3f, 7.0f, std::numeric_limits<float>::max()}[random.below(5)];
}

void huge_uv(IndexedMesh& mesh, Random& random)
{
    for (Vertex& v : mesh.vertices)
        v.uv = std::numeric_limits<float>::max() * glm::vec2(random.below(2) == 0 ? 1.0f : -1.0f);
}

void materials_without_name(IndexedMesh& mesh, Random& random)
{
    for (Material& material : mesh.materials) material = {"", glm::vec4(no_number(random)), std::string(3, '\0')};
    for (std::uint32_t i = random.below(5); i > 0; --i) mesh.materials.push_back({"cap", glm::vec4(1.0f), {}});
}

void empty_groups(IndexedMesh& mesh, Random& random)
{
    for (std::uint32_t i = 1 + random.below(4); i > 0; --i) {
        const std::uint32_t at = random.below(static_cast<std::uint32_t>(mesh.groups.size()) + 1);
        TriangleGroup group = at < mesh.groups.size() ? mesh.groups[at] : TriangleGroup{};
        if (at == mesh.groups.size()) group.first = static_cast<std::uint32_t>(mesh.triangles.size());
        group.count = 0;
        group.solid = static_cast<std::uint32_t>(random.next());
        mesh.groups.insert(mesh.groups.begin() + at, group);
    }
}

void hole(IndexedMesh& mesh, Random& random)
{
    remove_triangle(mesh, random.below(static_cast<std::uint32_t>(mesh.triangles.size())));
    drop_unused(mesh);
}

void several_holes(IndexedMesh& mesh, Random& random)
{
    for (std::uint32_t i = 2 + random.below(4); i > 0 && mesh.triangles.size() > 1; --i)
        remove_triangle(mesh, random.below(static_cast<std::uint32_t>(mesh.triangles.size())));
    drop_unused(mesh);
}

void wrong_corners(IndexedMesh& mesh, Random& random)
{
    for (std::uint32_t i = 1 + random.below(20); i > 0; --i)
        any_of(mesh.triangles, random)[random.below(3)] =
            random.below(static_cast<std::uint32_t>(mesh.vertices.size()));
    drop_unused(mesh);
}

void any_triangles(IndexedMesh& mesh, Random& random)
{
    mesh = {};
    const std::uint32_t points = 3 + random.below(12), triangles = 1 + random.below(20);
    for (std::uint32_t i = 0; i < points; ++i)
        add_vertex(mesh, {float(random.below(4)), float(random.below(4)), float(random.below(4))}, mesh.point_count++);
    mesh.materials.emplace_back();
    mesh.groups.push_back({0, 0, 0, 0, TriangleKind::surface});
    for (std::uint32_t i = 0; i < triangles; ++i) {
        const std::uint32_t a = random.below(points), b = (a + 1 + random.below(points - 1)) % points;
        std::uint32_t c = random.below(points);
        while (c == a || c == b) c = (c + 1) % points;
        add_triangle(mesh, {a, b, c});
    }
    drop_unused(mesh);
}

void any_bits(IndexedMesh& mesh, Random& random)
{
    const auto flip = [&](auto& list) {
        if (list.empty()) return;
        std::array<unsigned char, sizeof(list[0])> bytes;
        auto& element = any_of(list, random);
        std::memcpy(bytes.data(), &element, bytes.size());
        bytes[random.below(sizeof(list[0]))] ^= static_cast<unsigned char>(1u << random.below(8));
        std::memcpy(static_cast<void*>(&element), bytes.data(), bytes.size());
    };
    for (std::uint32_t i = 1 + random.below(4); i > 0; --i) switch (random.below(7)) {
            case 0:
                flip(mesh.vertices);
                break;
            case 1:
                flip(mesh.points);
                break;
            case 2:
                flip(mesh.triangles);
                break;
            case 3:
                flip(mesh.sources);
                break;
            case 4:
                flip(mesh.groups);
                break;
            case 5:
                mesh.point_count ^= 1u << random.below(32);
                break;
            default:
                if (!mesh.streams.empty()) flip(mesh.streams.back().values);
        }
}

constexpr auto kChanges = std::to_array<MeshChange>({
    {"nothing", Verdict::cut, [](IndexedMesh&, Random&) {}},
    {"wild sources", Verdict::cut, wild_sources},
    {"wild solids", Verdict::cut, wild_solids},
    {"caps from before", Verdict::cut, caps_from_before},
    {"huge coordinates", Verdict::cut, huge_coordinates},
    {"coordinates up to the largest float", Verdict::cut, coordinates_up_to_the_largest},
    {"points at the end of the range", Verdict::either, points_at_the_end_of_the_range},
    {"tiny coordinates", Verdict::either, tiny_coordinates},
    {"far from the origin", Verdict::either, far_from_the_origin},
    {"points at one place", Verdict::either, points_at_one_place},
    {"positions on a coarse grid", Verdict::either, positions_on_a_coarse_grid},
    {"any finite positions", Verdict::cut, any_positions},
    {"NaN in streams", Verdict::cut, streams_without_number},
    {"streams of great width", Verdict::cut, streams_of_great_width},
    {"normals of any length", Verdict::cut, normals_of_any_length},
    {"huge uv", Verdict::cut, huge_uv},
    {"materials without name", Verdict::cut, materials_without_name},
    {"empty groups", Verdict::cut, empty_groups},
    {"a hole", Verdict::either, hole},
    {"several holes", Verdict::either, several_holes},
    {"two points made one", Verdict::either, two_points_made_one},
    {"wrong corners", Verdict::either, wrong_corners},
    {"any triangles", Verdict::either, any_triangles},
    {"any bits", Verdict::either, any_bits},
    {"index out of range", Verdict::refused, index_out_of_range},
    {"point id out of range", Verdict::refused, point_out_of_range},
    {"too few points counted", Verdict::refused, point_count_too_small},
    {"too many points counted", Verdict::refused, point_count_too_large},
    {"point ids with a gap", Verdict::refused, ids_with_a_gap},
    {"unused vertex", Verdict::refused, unused_vertex},
    {"wrong number of point ids", Verdict::refused, wrong_number_of_points},
    {"wrong number of sources", Verdict::refused, wrong_number_of_sources},
    {"groups with a gap", Verdict::refused, groups_with_a_gap},
    {"groups that are too short", Verdict::refused, groups_that_are_too_short},
    {"groups that overflow", Verdict::refused, groups_that_overflow},
    {"no groups", Verdict::refused, no_groups},
    {"material out of range", Verdict::refused, material_out_of_range},
    {"wild kind", Verdict::refused, wild_kind},
    {"NaN or infinite coordinate", Verdict::refused, coordinate_without_number},
    {"-0 as a coordinate", Verdict::refused, negative_zero},
    {"NaN or infinite normal", Verdict::refused, normal_without_number},
    {"NaN or infinite uv", Verdict::refused, uv_without_number},
    {"positions that differ within a point", Verdict::refused, position_that_differs_within_a_point},
    {"two corners at one position", Verdict::refused, two_corners_at_one_position},
    {"stream too short", Verdict::refused, stream_too_short},
    {"stream too long", Verdict::refused, stream_too_long},
    {"stream of wild width", Verdict::refused, stream_of_wild_width},
    {"triangle turned over", Verdict::either, triangle_turned_over},
    {"triangle twice", Verdict::refused, triangle_twice},
    {"cube, one turned over, one twice", Verdict::refused, cube_with_one_turned_over_and_one_twice},
    {"third triangle at an edge", Verdict::either, third_triangle_at_an_edge},
    {"triangle at a point", Verdict::refused, two_triangles_at_a_point},
    {"solids that share an edge", Verdict::either, solids_that_share_an_edge},
    {"moved away", Verdict::refused, moved_away},
    {"no triangles", Verdict::refused, no_triangles},
    {"no vertices", Verdict::refused, no_vertices},
});

}  // namespace

std::span<const MeshChange> mesh_changes()
{
    return kChanges;
}

IndexedMesh small_mesh(Random& random)
{
    TriangleSoup soup;
    switch (random.below(7)) {
        case 0:
            soup = shapes::box({1, 1, 1}, {1, 1, 1});
            break;
        case 1:
            soup = shapes::cone(1.0f, 2.0f, 3 + random.below(6));
            break;
        case 2:
            soup = shapes::icosphere(1.0f, 1);
            break;
        case 3:
            soup = shapes::torus(1.0f, 0.4f, 3 + random.below(2), 3);
            break;
        case 4:
            soup = shapes::sphere_in_sphere(1.0f, 0.5f, 1);
            break;
        case 5:
            soup = shapes::comb(2);
            break;
        default:
            soup = shapes::uv_sphere(1.0f, 3 + random.below(3), 2 + random.below(3));
    }
    if (random.below(3) == 0) {
        soup.materials = {{"lower", glm::vec4(1.0f), {}}, {"upper", glm::vec4(0.5f), {}}};
        for (std::size_t t = 0; t < soup.triangles.size(); ++t) soup.triangle_materials.push_back(random.below(2));
    }
    if (random.below(3) == 0) {
        soup.streams.push_back({"heat", 1 + random.below(2), {}});
        for (std::size_t i = 0; i < soup.streams.back().width * soup.vertices.size(); ++i)
            soup.streams.back().values.push_back(static_cast<float>(i));
    }
    if (random.below(4) == 0) {
        // Open: some of its triangles only.
        for (std::uint32_t i = 1 + random.below(3); i > 0; --i) {
            soup.triangles.pop_back();
            if (!soup.triangle_materials.empty()) soup.triangle_materials.pop_back();
        }
    }
    return repaired(std::move(soup));
}

}  // namespace kerf::core::test
