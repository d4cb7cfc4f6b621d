// What a cut costs from the hit to the last body, in numbers that don't depend on the machine. Times are measured by
// kerf_bench.

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "support/allocations.h"
#include "viewer/sim/bodies.h"
#include "viewer/sim/cut_body.h"

namespace kerf::sim {
namespace {

struct Cost
{
    CutRecord record;
    double allocated = 0.0, largest = 0.0;  // bytes
    std::uint64_t new_bytes = 0;            // that the pieces want to upload
};

std::uint64_t bytes_to_upload(Cuttable& object)
{
    std::uint64_t bytes = 0;
    const DrawView view = object.draw_view();
    for (const ByteRange& range : view.new_vertex_bytes) bytes += range.size;
    for (const ByteRange& range : view.new_index_bytes) bytes += range.size;
    return bytes;
}

Cost cut_asteroid(std::uint64_t triangles)
{
    World world(0.0);
    Body& body = world.add(test::body_of(test::shape("asteroid", triangles), 1, {0.1, 0.2, 0}, {{1, 2, 0}, {0, 1, 2}},
                                         ProxyKind::bounded_hull, "halfedge"));
    body.object().mark_uploaded();
    Cost cost;
    cost.record.number = 1;
    cost.record.swipe = 1;
    ObjectId last_id = 1;
    const WorldPlane plane{glm::normalize(glm::dvec3(1, 2, 0.3)), {0, 0, 0}};
    test::reset_largest_allocation();
    const std::size_t before = test::allocated_bytes();
    cut_body(world, 1, plane, {ProxyKind::bounded_hull, false, &last_id}, cost.record);
    cost.allocated = double(test::allocated_bytes() - before);
    cost.largest = double(test::largest_allocation());
    // The pieces share their buffers: what one has uploaded the others need not.
    for (const auto& piece : world.bodies()) {
        cost.new_bytes += bytes_to_upload(piece->object());
        piece->object().mark_uploaded();
    }
    return cost;
}

TEST(Cost, BytesToUploadAreThoseThatTheCutNamed)
{
    const Cost cost = cut_asteroid(50'000);
    ASSERT_EQ(cost.record.status, Status::cut);
    EXPECT_GT(cost.new_bytes, 0u);
    EXPECT_EQ(cost.new_bytes, cost.record.statistics.bytes_to_upload);
}

TEST(Cost, FromTheHitToTheLastBodyMemoryAndBytesFollowTheSection)
{
    // Bytes for each crossing triangle: the cut's own limits, and the bodies' share of them.
    constexpr double kAllocated = 4000, kUploaded = 400;
    constexpr double kBodies = 64 * 1024;
    for (const std::uint64_t triangles : {20'000u, 320'000u}) {
        const Cost cost = cut_asteroid(triangles);
        const double k = double(cost.record.statistics.crossing_triangles);
        EXPECT_LE(cost.allocated, kAllocated * k + kBodies) << triangles;
        EXPECT_LE(cost.largest, 1000 * k) << triangles;
        EXPECT_LE(double(cost.new_bytes), kUploaded * k) << triangles;
    }
}

}  // namespace
}  // namespace kerf::sim
