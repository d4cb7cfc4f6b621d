#include "support/open_soups.h"

#include <algorithm>
#include <cmath>

#include "common/shapes/shapes.h"

namespace kerf::core::test {

namespace {

void add_vertex(TriangleSoup& soup, const glm::vec3& position)
{
    soup.vertices.push_back({position, {0.0f, 0.0f, 1.0f}, {0.0f, 0.0f}});
}

glm::vec3 lattice_point(Random& random, std::uint32_t size)
{
    const auto x = float(random.below(size)), y = float(random.below(size));
    return {x, y, float(random.below(size))};
}

/// Takes triangles out, each with this probability, but leaves one.
void leave_out(TriangleSoup& soup, Random& random, double share)
{
    const Triangle first = soup.triangles.front();
    std::erase_if(soup.triangles, [&](const Triangle&) { return random.uniform() < share; });
    if (soup.triangles.empty()) soup.triangles.push_back(first);
}

/// Moves all vertices to the points of a lattice with so many cells along the longest side.
void snap(TriangleSoup& soup, std::uint32_t cells)
{
    Box box;
    for (const Vertex& v : soup.vertices) box.add(v.position);
    const glm::vec3 size = box.hi - box.lo;
    const float step = std::max({size.x, size.y, size.z}) / float(cells);
    if (!(step > 0.0f)) return;
    for (Vertex& v : soup.vertices)
        for (int axis = 0; axis < 3; ++axis) v.position[axis] = std::round(v.position[axis] / step) + 0.0f;
}

TriangleSoup few_points(Random& random, std::uint32_t triangles)
{
    TriangleSoup soup;
    const std::uint32_t size = 2 + random.below(4), points = 4 + random.below(30);
    for (std::uint32_t i = 0; i < points; ++i) add_vertex(soup, lattice_point(random, size));
    for (std::uint32_t i = 0; i < triangles; ++i) {
        const std::uint32_t a = random.below(points), b = random.below(points);
        soup.triangles.push_back({a, b, random.below(points)});
    }
    return soup;
}

/// Rectangles of cells across the axes that cross one another along the lattice.
TriangleSoup sheets(Random& random, std::uint32_t triangles)
{
    TriangleSoup soup;
    const std::uint32_t size = 3 + random.below(3);
    while (soup.triangles.size() < triangles) {
        const auto across = static_cast<int>(random.below(3));
        const int u = (across + 1) % 3, v = (across + 2) % 3;
        const auto corner = lattice_point(random, size);
        const std::uint32_t width = 1 + random.below(size), height = 1 + random.below(size), turned = random.below(2);
        // Now and then a sheet leans.
        const float slope = random.below(3) == 0 ? float(random.below(3)) - 1.0f : 0.0f;
        const auto first = static_cast<std::uint32_t>(soup.vertices.size());
        for (std::uint32_t i = 0; i <= width; ++i)
            for (std::uint32_t j = 0; j <= height; ++j) {
                glm::vec3 p = corner;
                p[u] += float(i);
                p[v] += float(j);
                p[across] += slope * float(i);
                add_vertex(soup, p);
            }
        for (std::uint32_t i = 0; i < width; ++i)
            for (std::uint32_t j = 0; j < height; ++j) {
                const std::uint32_t a = first + i * (height + 1) + j, b = a + height + 1;
                if (random.below(8) == 0) continue;
                std::array<Triangle, 2> cell{Triangle{a, b, b + 1}, Triangle{a, b + 1, a + 1}};
                if (random.below(2) != 0) cell = {Triangle{a, b, a + 1}, Triangle{b, b + 1, a + 1}};
                for (Triangle& t : cell) {
                    if (turned != 0) std::swap(t[1], t[2]);
                    soup.triangles.push_back(t);
                }
            }
    }
    return soup;
}

/// Boxes with their corners on a lattice, each without some of its faces.
TriangleSoup open_boxes(Random& random, std::uint32_t triangles)
{
    static constexpr std::array<std::array<std::uint32_t, 4>, 6> kFaces{
        {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
    TriangleSoup soup;
    const std::uint32_t size = 2 + random.below(3);
    const bool stacked = random.below(2) != 0;
    for (std::uint32_t i = 0; soup.triangles.size() < triangles; ++i) {
        glm::vec3 low = lattice_point(random, size), extent = lattice_point(random, size) + glm::vec3(1.0f);
        if (stacked) {
            const std::uint32_t x = i % size, y = i / size % size, z = i / (size * size);
            low = {float(x), float(y), float(z)};
            extent = glm::vec3(1.0f);
        }
        const auto first = static_cast<std::uint32_t>(soup.vertices.size());
        for (std::uint32_t k = 0; k < 8; ++k)
            add_vertex(soup, low + extent * glm::vec3(float(k & 1), float(k >> 1 & 1), float(k >> 2 & 1)));
        const std::uint32_t inside_out = random.below(8) == 0 ? 1 : 0;
        for (const auto& f : kFaces) {
            if (random.below(4) == 0) continue;
            const std::uint32_t turn = random.below(2);
            for (std::uint32_t half = 0; half < 2; ++half) {
                Triangle t{first + f[turn], first + f[(turn + 1 + half) % 4], first + f[(turn + 2 + half) % 4]};
                if (inside_out != 0) std::swap(t[1], t[2]);
                soup.triangles.push_back(t);
            }
        }
    }
    return soup;
}

/// Tori with their vertices on a lattice, which fold them onto themselves, and without some of their triangles.
TriangleSoup half_torus(Random& random, std::uint32_t triangles)
{
    const std::uint32_t minor = 3 + random.below(6), major = std::max(3u, triangles / (2 * minor));
    TriangleSoup soup = shapes::torus(1.0f, 0.3f + 0.6f * float(random.uniform()), major, minor);
    snap(soup, 3 + random.below(10));
    if (random.below(2) != 0) {
        // One half, by its triangles' order, and holes.
        soup.triangles.resize(std::max<std::size_t>(1, soup.triangles.size() / 2));
        leave_out(soup, random, 0.1);
    } else {
        leave_out(soup, random, 0.4 * random.uniform());
    }
    return soup;
}

TriangleSoup shape_without_a_third(Random& random, std::uint32_t triangles)
{
    const auto& names = shapes::names();
    const std::string& name = names[random.below(static_cast<std::uint32_t>(names.size()))];
    TriangleSoup soup = *shapes::make(name, triangles, random.next());
    if (random.below(3) != 0) snap(soup, 2 + random.below(14));
    leave_out(soup, random, 1.0 / 3.0);
    return soup;
}

}  // namespace

NamedSoup open_soup(std::uint64_t seed, std::uint32_t triangles)
{
    Random random(seed);
    const std::uint32_t count = 12 + random.below(std::max(13u, triangles) - 12);
    const auto make = [&](std::uint32_t kind, std::uint32_t n) -> NamedSoup {
        switch (kind) {
            case 0:
                return {"few points", few_points(random, n)};
            case 1:
                return {"sheets", sheets(random, n)};
            case 2:
                return {"open boxes", open_boxes(random, n)};
            case 3:
                return {"half torus", half_torus(random, n)};
            case 4:
                return {"sieve", sieve(random.next(), n, 0.05 + 0.5 * random.uniform(), random.below(12))};
            default:
                return {"without a third", shape_without_a_third(random, n)};
        }
    };
    const std::uint32_t kind = random.below(7);
    NamedSoup result = make(kind < 6 ? kind : random.below(6), count);
    if (kind == 6) {
        const NamedSoup other = make(random.below(6), count);
        result = {result.name + " and " + other.name, joined(std::move(result.soup), other.soup)};
    }
    // Their normals are those of the shapes that they were.
    result.soup.has_normals = false;
    // Corners along one line, and places far away, where cut points fall on corners and on one another.
    if (random.below(4) == 0) {
        glm::vec3 scale(1.0f);
        scale[static_cast<int>(random.below(3))] = std::ldexp(1.0f, -static_cast<int>(random.below(26)));
        const glm::vec3 offset(random.below(2) != 0 ? 0.0f : 1000.0f);
        for (Vertex& v : result.soup.vertices) v.position = v.position * scale + offset;
    }
    return result;
}

TriangleSoup sieve(std::uint64_t seed, std::uint32_t triangles, double left_out, std::uint32_t cells)
{
    Random random(seed);
    TriangleSoup soup =
        shapes::icosphere(1.0f, std::max(1u, static_cast<std::uint32_t>(std::sqrt(double(triangles) / 20.0))));
    if (cells > 0) snap(soup, cells);
    leave_out(soup, random, left_out);
    soup.has_normals = false;
    return soup;
}

Plane plane_across(const IndexedMesh& mesh, std::uint64_t seed)
{
    Random random(seed);
    const auto vertex = [&] {
        return glm::dvec3(mesh.vertices[random.below(static_cast<std::uint32_t>(mesh.vertices.size()))].position);
    };
    if (random.below(2) == 0) {
        const auto small = [&] { return double(random.below(5)) - 2.0; };
        const double x = small(), y = small();
        const glm::dvec3 point = random.below(2) == 0 ? vertex() : 0.5 * (vertex() + vertex());
        if (const auto plane = Plane::through(point, {x, y, small()})) return *plane;
    }
    const std::vector<NamedPlane> planes = planes_for(mesh, 1, random.next());
    return planes[random.below(static_cast<std::uint32_t>(planes.size()))].plane;
}

}  // namespace kerf::core::test
