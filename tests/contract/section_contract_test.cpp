// What section() promises, for every back end: what a cut without pieces of its own says of its section, bit for bit,
// and the object stays as it is.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "common/cutting/cut.h"
#include "common/sections/section_measures.h"
#include "support/backends.h"
#include "support/brief.h"
#include "support/fixtures.h"
#include "support/referee.h"

namespace kerf::core {
namespace {

using test::NamedMesh;
using test::NamedPlane;

/// Closed and open shapes.
std::vector<NamedMesh> all_shapes()
{
    std::vector<NamedMesh> all = test::closed_shapes();
    all.insert(all.end(), test::open_shapes().begin(), test::open_shapes().end());
    return all;
}

/// The loops in the form in which a cut gives them.
std::vector<SectionLoop> loops_of(const PlaneSection& section)
{
    std::vector<SectionLoop> loops;
    for (const PlaneSection::Path& path : section.paths) {
        const auto points = section.points_of(path);
        loops.push_back({{points.begin(), points.end()}, path.closed});
    }
    return loops;
}

void expect_equal_loops(std::span<const SectionLoop> loops, std::span<const SectionLoop> of_cut)
{
    ASSERT_EQ(loops.size(), of_cut.size());
    for (std::size_t i = 0; i < loops.size(); ++i) {
        EXPECT_EQ(loops[i].closed, of_cut[i].closed);
        EXPECT_EQ(loops[i].points, of_cut[i].points);
    }
}

/// All of a section as numbers: equal ones are equal bit for bit.
std::vector<double> bytes_of(const PlaneSection& section)
{
    std::vector<double> all{double(section.status), double(section.side_of_object)};
    for (const glm::vec3& p : section.points) all.insert(all.end(), {p.x, p.y, p.z});
    for (const PlaneSection::Edge& e : section.edges) all.insert(all.end(), {double(e.source), double(e.material)});
    for (const PlaneSection::Path& p : section.paths)
        all.insert(all.end(), {double(p.first_point), double(p.first_edge), double(p.solid), double(p.closed)});
    return all;
}

/// A section, and that it is the one of a cut of a copy.
PlaneSection expect_section_of_cut(const Cuttable& object, const Plane& plane)
{
    PlaneSection found;
    const Status status = section(object, plane, found);
    EXPECT_EQ(status, found.status);
    const CutResult result = cut(object.clone(), plane);
    EXPECT_EQ(name_of(status), name_of(result.status));
    EXPECT_EQ(measure_section(plane, found).area, result.section_area);
    if (result.status == Status::missed) {
        EXPECT_EQ(found.side_of_object, result.side_of_object);
        EXPECT_TRUE(found.paths.empty() && found.points.empty() && found.edges.empty());
        return found;
    }
    EXPECT_EQ(found.crossing_triangles, result.statistics.crossing_triangles);
    if (!result.positive.empty()) expect_equal_loops(loops_of(found), result.positive.front()->section_loops());
    return found;
}

class SectionContract : public testing::TestWithParam<test::NamedBackend>
{
protected:
    std::unique_ptr<Cuttable> prepare(const IndexedMesh& mesh) const { return back_end_->prepare(mesh).object; }

    std::unique_ptr<Backend> back_end_ = GetParam().make();
};

INSTANTIATE_TEST_SUITE_P(All, SectionContract, testing::ValuesIn(test::backends()),
                         [](const auto& back_end) { return back_end.param.name; });

TEST_P(SectionContract, LoopsAreThoseOfACutForEveryShapeAndPlane)
{
    for (const NamedMesh& shape : all_shapes()) {
        const auto object = prepare(shape.mesh);
        for (const NamedPlane& plane : test::planes_for(shape.mesh, 5, 31)) {
            SCOPED_TRACE(shape.name + ", plane " + plane.name);
            expect_section_of_cut(*object, plane.plane);
        }
    }
}

TEST_P(SectionContract, LoopsOfPiecesAreThoseOfACut)
{
    for (const NamedMesh& shape : all_shapes()) {
        const auto whole = prepare(shape.mesh);
        const Plane first = test::planes_for(shape.mesh, 1, 32).front().plane;
        const CutResult result = cut(whole->clone(), first);
        for (const auto* side : {&result.positive, &result.negative})
            for (const auto& piece : *side)
                for (const NamedPlane& plane : test::planes_for(piece->to_indexed_mesh(), 2, 33)) {
                    SCOPED_TRACE(shape.name + ", plane " + plane.name);
                    expect_section_of_cut(*piece, plane.plane);
                }
    }
}

TEST_P(SectionContract, TouchesNoMoreThanACut)
{
    for (const NamedMesh& shape : test::closed_shapes()) {
        const auto object = prepare(shape.mesh);
        for (const NamedPlane& plane : test::planes_for(shape.mesh, 2, 34)) {
            SCOPED_TRACE(shape.name + ", plane " + plane.name);
            PlaneSection found;
            if (section(*object, plane.plane, found) == Status::missed) continue;
            const CutStatistics of_cut = cut(object->clone(), plane.plane).statistics;
            EXPECT_LE(found.triangles_touched, of_cut.triangles_touched);
            EXPECT_LE(found.nodes_visited, of_cut.nodes_visited);
        }
    }
}

TEST_P(SectionContract, ObjectStaysAsItIs)
{
    for (const NamedMesh& shape : all_shapes()) {
        SCOPED_TRACE(shape.name);
        const auto object = prepare(shape.mesh), untouched = prepare(shape.mesh);
        PlaneSection found;
        for (const NamedPlane& plane : test::planes_for(shape.mesh, 3, 35)) section(*object, plane.plane, found);
        EXPECT_EQ(referee::bytes_of(object->to_indexed_mesh()), referee::bytes_of(untouched->to_indexed_mesh()));
        const Plane plane = test::planes_for(shape.mesh, 1, 36).front().plane;
        const CutResult a = cut(object->clone(), plane), b = cut(untouched->clone(), plane);
        ASSERT_EQ(a.positive.size(), b.positive.size());
        for (std::size_t i = 0; i < a.positive.size(); ++i)
            EXPECT_EQ(referee::bytes_of(a.positive[i]->to_indexed_mesh()),
                      referee::bytes_of(b.positive[i]->to_indexed_mesh()));
    }
}

TEST_P(SectionContract, AnswersDoNotDependOnWhatWasAskedBefore)
{
    PlaneSection used;
    for (const NamedMesh& shape : all_shapes()) {
        const auto object = prepare(shape.mesh);
        for (const NamedPlane& plane : test::planes_for(shape.mesh, 2, 37)) {
            SCOPED_TRACE(shape.name + ", plane " + plane.name);
            PlaneSection fresh;
            section(*object, plane.plane, used);
            section(*object, plane.plane, fresh);
            EXPECT_EQ(bytes_of(used), bytes_of(fresh));
        }
    }
}

TEST_P(SectionContract, FlippedPlaneRunsTheSameLoopsTheOtherWay)
{
    for (const NamedMesh& shape : test::closed_shapes()) {
        const auto object = prepare(shape.mesh);
        for (const NamedPlane& plane : test::planes_for(shape.mesh, 2, 38)) {
            // Faces in the plane are kept where the surface outside of it goes on, which a flip changes.
            if (plane.name.find("face") != std::string::npos) continue;
            SCOPED_TRACE(shape.name + ", plane " + plane.name);
            PlaneSection there, back;
            section(*object, plane.plane, there);
            const Plane flipped{-plane.plane.normal, -plane.plane.offset};
            section(*object, flipped, back);
            EXPECT_EQ(there.crossing_triangles, back.crossing_triangles);
            if (there.status == back.status) {
                EXPECT_EQ(measure_section(plane.plane, there).area, measure_section(flipped, back).area);
            }
        }
    }
}

TEST_P(SectionContract, StacksThatAreSearchedAsAWholeHaveTheSectionsOneByOne)
{
    test::Random random(41);
    std::size_t met = 0, stacks = 0;
    for (const NamedMesh& shape : all_shapes()) {
        auto object = prepare(shape.mesh);
        // The second round is of a piece, which has a cap.
        for (int round = 0; round < 2; ++round) {
            const IndexedMesh mesh = object->to_indexed_mesh();
            for (const NamedPlane& plane : test::planes_for(mesh, 1, 42)) {
                SCOPED_TRACE(shape.name + ", plane " + plane.name);
                // Not sorted, twice the same, through vertices, beside the mesh.
                std::vector<double> offsets{plane.plane.offset, plane.plane.offset + 1e6, plane.plane.offset};
                for (int i = 0; i < 8; ++i) {
                    const Vertex& v = mesh.vertices[random.below(std::uint32_t(mesh.vertices.size()))];
                    offsets.push_back(Plane{plane.plane.normal, 0.0}.signed_distance(v.position));
                    offsets.push_back(offsets.back() + 0.1 * (random.uniform() - 0.5));
                }
                const auto search = object->search_stack(plane.plane.normal, offsets, {});
                if (search == nullptr) continue;
                ++stacks;
                PlaneSection one, of_stack;
                for (std::size_t i = 0; i < offsets.size(); ++i) {
                    section(*object, Plane{plane.plane.normal, offsets[i]}, one);
                    EXPECT_EQ(section(*search, i, of_stack), one.status);
                    EXPECT_EQ(bytes_of(of_stack), bytes_of(one));
                    EXPECT_EQ(of_stack.crossing_triangles, one.crossing_triangles);
                    EXPECT_LE(of_stack.triangles_touched, one.triangles_touched);
                    met += one.paths.empty() ? 0 : 1;
                }
            }
            CutResult halves = cut(object->clone(), test::planes_for(mesh, 1, 43).front().plane);
            if (halves.positive.empty()) break;
            object = std::move(halves.positive.front());
        }
    }
    EXPECT_TRUE(stacks == 0 || met > 1000);
    EXPECT_EQ(stacks == 0, GetParam().name == "halfedge");
}

TEST_P(SectionContract, RefusesAPlaneThatIsNone)
{
    const auto object = prepare(test::closed_shapes().front().mesh);
    PlaneSection found;
    EXPECT_EQ(section(*object, Plane{{0, 0, 2}, 0}, found), Status::invalid_argument);
    EXPECT_TRUE(found.paths.empty());
}

/// An edge of a section with its ends, as a key.
using EdgeKey = std::array<double, 8>;

std::map<EdgeKey, int> edges_of(const PlaneSection& section)
{
    std::map<EdgeKey, int> edges;
    for (const PlaneSection::Path& path : section.paths) {
        const auto points = section.points_of(path);
        const auto path_edges = section.edges_of(path);
        for (std::size_t i = 0; i < path_edges.size(); ++i) {
            const glm::vec3 &a = points[i], &b = points[(i + 1) % points.size()];
            ++edges[{a.x, a.y, a.z, b.x, b.y, b.z, double(path_edges[i].source), double(path_edges[i].material)}];
        }
    }
    return edges;
}

/// A vertex of a mesh with all of its attributes, as a key.
using VertexKey = std::vector<float>;

VertexKey key_of(const Vertex& v)
{
    return {v.position.x, v.position.y, v.position.z, v.normal.x, v.normal.y, v.normal.z, v.uv.x, v.uv.y};
}

/// The edges of a piece's triangles, both ways.
void add_edges_of(const IndexedMesh& piece, std::set<std::pair<VertexKey, VertexKey>>& edges)
{
    std::vector<VertexKey> keys;
    for (std::size_t v = 0; v < piece.vertices.size(); ++v) {
        keys.push_back(key_of(piece.vertices[v]));
        for (const VertexStream& stream : piece.streams)
            for (std::size_t i = 0; i < stream.width; ++i) keys.back().push_back(stream.values[v * stream.width + i]);
    }
    for (const Triangle& t : piece.triangles)
        for (std::size_t i = 0; i < 3; ++i) {
            edges.emplace(keys[t[i]], keys[t[(i + 1) % 3]]);
            edges.emplace(keys[t[(i + 1) % 3]], keys[t[i]]);
        }
}

TEST_P(SectionContract, EndsOfEdgesHaveTheAttributesThatACutGivesThem)
{
    std::size_t seams = 0;
    PlaneSection found;
    found.wants_ends = true;
    for (const NamedMesh& shape : all_shapes()) {
        const auto object = prepare(shape.mesh);
        for (const NamedPlane& plane : test::planes_for(shape.mesh, test::kBrief ? 1 : 3, 40)) {
            SCOPED_TRACE(shape.name + ", plane " + plane.name);
            if (section(*object, plane.plane, found) == Status::missed) continue;
            ASSERT_EQ(found.ends.size(), 2 * found.edges.size());
            ASSERT_EQ(found.end_streams.size(), shape.mesh.streams.size());
            CutOptions without_caps;
            without_caps.build_caps = false;
            const CutResult result = cut(object->clone(), plane.plane, without_caps);
            std::set<std::pair<VertexKey, VertexKey>> edges;
            for (const auto* side : {&result.positive, &result.negative})
                for (const auto& piece : *side) add_edges_of(piece->to_indexed_mesh(), edges);
            const auto end = [&](std::size_t i) {
                VertexKey key = key_of(found.ends[i]);
                for (const PlaneSection::EndStream& stream : found.end_streams)
                    key.insert(key.end(), stream.values.begin() + static_cast<std::ptrdiff_t>(i * stream.width),
                               stream.values.begin() + static_cast<std::ptrdiff_t>((i + 1) * stream.width));
                return key;
            };
            for (const PlaneSection::Path& path : found.paths)
                found.for_each_edge(path, [&](std::size_t i, const glm::vec3& p, const glm::vec3& q) {
                    const std::size_t e = 2 * (path.first_edge + i);
                    EXPECT_EQ(found.ends[e].position, p);
                    EXPECT_EQ(found.ends[e + 1].position, q);
                    EXPECT_EQ(edges.count({end(e), end(e + 1)}), 1u);
                    if (i > 0 && end(e) != end(e - 1)) ++seams;
                });
        }
    }
    EXPECT_GT(seams, 100u);
}

TEST_P(SectionContract, EdgesAreThoseOfAllBackEnds)
{
    const auto reference = test::backends().front().make();
    for (const NamedMesh& shape : all_shapes()) {
        const auto object = prepare(shape.mesh), other = reference->prepare(shape.mesh).object;
        for (const NamedPlane& plane : test::planes_for(shape.mesh, 4, 39)) {
            SCOPED_TRACE(shape.name + ", plane " + plane.name);
            PlaneSection found, of_other;
            EXPECT_EQ(name_of(section(*object, plane.plane, found)), name_of(section(*other, plane.plane, of_other)));
            EXPECT_EQ(edges_of(found), edges_of(of_other));
            EXPECT_EQ(measure_section(plane.plane, found).area, measure_section(plane.plane, of_other).area);
        }
    }
}

}  // namespace
}  // namespace kerf::core
