#include <gtest/gtest.h>

#include <kerf/kerf.h>
#include <kerf/shapes.h>

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

// The examples in the comments of the public headers, as they stand there, each with the names that it speaks of.

namespace kerf {
namespace {

/// Half of an asteroid on either side of z = 0.
Cut cut_in_two()
{
    return cut(*prepare(*make_shape("asteroid", 1000)), *Plane::z(0.0));
}

TEST(HeaderExamples, EachPieceOfASideIsKept)
{
    kerf::Cut cut = cut_in_two();
    std::vector<kerf::Object> kept;
    const auto keep = [&](kerf::Object&& object) { kept.push_back(std::move(object)); };
#include "examples/kerf_cut_1.inc"
    ASSERT_EQ(kept.size(), 1u);
    EXPECT_GT(kept.front().triangle_count(), 0u);
}

TEST(HeaderExamples, TheOnePieceOfASideIsKept)
{
    kerf::Cut cut = cut_in_two();
    std::vector<kerf::Object> kept;
    const auto keep = [&](kerf::Object&& object) { kept.push_back(std::move(object)); };
#include "examples/kerf_cut_2.inc"
    EXPECT_EQ(kept.size(), 1u);
}

TEST(HeaderExamples, AViewIsUploadedAndDrawn)
{
    kerf::Object object = *prepare(*make_shape("asteroid", 1000));
    kerf::DrawView view;
    std::size_t uploaded = 0, drawn = 0;
    const auto upload = [&](std::uint64_t, std::span<const kerf::DrawVertex> vertices,
                            std::span<const std::uint32_t> indices) { uploaded += vertices.size() + indices.size(); };
    const auto draw = [&](std::uint64_t, const kerf::DrawRange& range) { drawn += range.index_count; };
    const auto frame = [&] {
#include "examples/kerf_draw_1.inc"
    };
    frame();
    EXPECT_EQ(uploaded, view.vertices.size() + view.indices.size());
    EXPECT_EQ(drawn, 3 * object.triangle_count());
    frame();
    EXPECT_EQ(uploaded, view.vertices.size() + view.indices.size()) << "nothing is new in the second frame";
}

TEST(HeaderExamples, AMeshReadsTheVerticesOfAProgram)
{
    struct Vertex
    {
        kerf::Vec3f position;
        float temperature = 0.0f;
    };
    const std::vector<Vertex> vertices = {{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}};
    const std::vector<std::uint32_t> triangles = {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};
#include "examples/kerf_mesh_1.inc"
    const Result<Mesh> mesh = Mesh::make(input);
    ASSERT_TRUE(mesh) << mesh.reason();
    EXPECT_TRUE(mesh->is_closed());
}

TEST(HeaderExamples, APlaneTakesAVectorOfAProgram)
{
    const struct
    {
        float x, y, z;
    } up = {0, 0, 2};
#include "examples/kerf_plane_1.inc"
    ASSERT_TRUE(plane);
    EXPECT_EQ(plane->distance(Vec3d(0, 0, 3)), 1.0);
}

TEST(HeaderExamples, AResultIsUsedOrSaysWhyNot)
{
    std::string complaint;
    std::uint64_t used = 0;
    const auto complain = [&](const char* reason) { complaint = reason; };
    const auto use = [&](const kerf::Mesh& given) { used = given.triangle_count(); };
    const auto attempt = [&](const kerf::MeshInput& input) {
#include "examples/kerf_status_1.inc"
    };
    attempt({});
    EXPECT_NE(complaint, "");
    EXPECT_EQ(used, 0u);

    const std::array<float, 9> positions = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    MeshInput input;
    input.positions = positions.data();
    input.vertex_count = 3;
    input.triangle_count = 1;
    attempt(input);
    EXPECT_EQ(used, 1u);
}

}  // namespace
}  // namespace kerf
