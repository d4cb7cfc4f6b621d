// Cuts that leave something behind for the next ones: stamps on faces, boundary, cut points that fall together.

#include <gtest/gtest.h>

#include <cmath>

#include "common/shapes/shapes.h"
#include "halfedge/consistency.h"
#include "halfedge/halfedge.h"
#include "support/fixtures.h"
#include "support/referee.h"

namespace kerf::core::halfedge {
namespace {

using Fragments = std::vector<std::unique_ptr<Cuttable>>;

/// A shape whose y coordinates are so large that cut points have no digits left between whole numbers: many of them
/// fall on vertices and on each other.
IndexedMesh on_a_coarse_lattice(TriangleSoup soup)
{
    constexpr float kCells = 30.0f, kFarAway = 8388608.0f;  // from 2^23 on the floats are whole numbers
    Box box;
    for (const Vertex& v : soup.vertices) box.add(v.position);
    const glm::vec3 size = box.hi - box.lo;
    const float longest = std::max({size.x, size.y, size.z});
    for (Vertex& v : soup.vertices) {
        for (int axis = 0; axis < 3; ++axis) v.position[axis] = std::round(v.position[axis] / longest * kCells) + 0.0f;
        v.position.y += kFarAway + 100.0f;
    }
    return test::repaired(std::move(soup));
}

Fragments all_of(CutResult result)
{
    Fragments fragments;
    if (result.object) fragments.push_back(std::move(result.object));
    for (Fragments* side : {&result.negative, &result.positive})
        for (auto& fragment : *side) fragments.push_back(std::move(fragment));
    return fragments;
}

/// Cuts all fragments of a mesh, or clones of them, again and again by planes of every kind, and checks each result.
void cut_and_check(const IndexedMesh& mesh, const CutOptions& options, int generations, std::uint64_t seed,
                   bool cut_clones)
{
    test::Random random(seed);
    Fragments fragments;
    fragments.push_back(std::move(make_back_end()->prepare(mesh).object));
    for (int generation = 0; generation < generations; ++generation) {
        Fragments next;
        for (auto& fragment : fragments) {
            const auto planes = test::planes_for(fragment->to_indexed_mesh(), 2, random.next());
            if (planes.empty()) continue;
            const auto& plane = planes[random.below(static_cast<std::uint32_t>(planes.size()))];
            if (cut_clones) fragment = fragment->clone();
            for (auto& part : all_of(cut(std::move(fragment), plane.plane, options))) {
                ASSERT_EQ(faults(*part), "") << "generation " << generation << ", plane " << plane.name;
                if (options.build_caps) {
                    ASSERT_EQ(referee::open_edges(part->to_indexed_mesh()), 0u)
                        << "generation " << generation << ", plane " << plane.name;
                }
                next.push_back(std::move(part));
            }
        }
        fragments = std::move(next);
    }
}

const char* const kShapes[] = {"asteroid", "bowl", "torus", "comb"};

TEST(Coincidence, ACloneForgetsWhichTrianglesTheLastCutCrossed)
{
    CutOptions options;
    options.split_components = true;
    for (const char* name : kShapes)
        for (std::uint64_t seed = 1; seed <= 10; ++seed) {
            SCOPED_TRACE(std::string(name) + ", seed " + std::to_string(seed));
            cut_and_check(test::repaired(*shapes::make(name, 300, seed)), options, 3, seed, true);
        }
}

TEST(Coincidence, PiecesThatVanishLeaveTheSurfaceWhole)
{
    for (const char* name : kShapes)
        for (std::uint64_t seed = 1; seed <= 30; ++seed) {
            SCOPED_TRACE(std::string(name) + ", seed " + std::to_string(seed));
            CutOptions options;
            options.split_components = seed % 2 == 0;
            cut_and_check(on_a_coarse_lattice(*shapes::make(name, 300, seed)), options, 3, seed, false);
        }
}

TEST(Coincidence, PiecesThatVanishAtABoundaryKeepItLinked)
{
    for (const char* name : kShapes)
        for (std::uint64_t seed = 1; seed <= 30; ++seed) {
            SCOPED_TRACE(std::string(name) + ", seed " + std::to_string(seed));
            CutOptions options;
            options.split_components = seed % 2 == 0;
            options.build_caps = false;  // every cut leaves boundary to the next one
            cut_and_check(on_a_coarse_lattice(*shapes::make(name, 300, seed)), options, 3, seed, false);
        }
}

}  // namespace
}  // namespace kerf::core::halfedge
