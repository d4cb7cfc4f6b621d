#include <gtest/gtest.h>

#include <kerf/drawing.h>
#include <kerf/io.h>
#include <kerf/kerf.h>
#include <kerf/proxy.h>
#include <kerf/shapes.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <glm/vec3.hpp>
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

TEST(HeaderExamples, BackEndsAreOffered)
{
    std::vector<std::string> offered;
    const auto offer = [&](const char* name) { offered.emplace_back(name); };
#include "examples/kerf_back_ends_1.inc"
    EXPECT_EQ(offered.size(), back_end_count());
    EXPECT_NE(std::find(offered.begin(), offered.end(), "linear"), offered.end());
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

TEST(HeaderExamples, PiecesAreKeptByTheirCells)
{
    kerf::Object object = *prepare(*make_shape("asteroid", 1000));
    std::vector<std::array<std::uint32_t, 2>> cells;
    const auto keep = [&](kerf::Object&&, std::uint32_t x, std::uint32_t y) { cells.push_back({x, y}); };
#include "examples/kerf_dice_1.inc"
    EXPECT_EQ(cells.size(), 9u);
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

TEST(HeaderExamples, ASectionIsDrawn)
{
    const kerf::Object object = *prepare(*make_shape("asteroid", 1000));
    const kerf::Plane plane = *Plane::z(0.0);
#include "examples/kerf_drawing_1.inc"
    ASSERT_TRUE(svg) << svg.reason();
    EXPECT_GT(svg->bytes().size(), 100u);
}

TEST(HeaderExamples, PiecesOfAFractureAreThrownAndGlued)
{
    const kerf::Object object = *prepare(*make_shape("asteroid", 1000));
    std::size_t thrown = 0;
    double glued = 0.0;
    const auto throw_away = [&](kerf::Object&& piece) { thrown += piece.is_empty() ? 0 : 1; };
    const auto glue = [&](std::uint32_t first, std::uint32_t second, double area) {
        EXPECT_LT(first, second);
        glued += area;
    };
#include "examples/kerf_fracture_1.inc"
    EXPECT_EQ(thrown, broken.count());
    EXPECT_GT(glued, 0.0);
}

TEST(HeaderExamples, AFileIsReadAndWhatWasWrongIsPrinted)
{
    std::string complaint;
    const auto complain = [&](const char* reason) { complaint = reason; };
    const auto attempt = [&](const char* path) {
#include "examples/kerf_io_1.inc"
    };
    attempt(KERF_DATA_DIR "/models/rook.obj");
    EXPECT_EQ(complaint, "");
    attempt("no-such-file.obj");
    EXPECT_NE(complaint.find("there is no such file"), std::string::npos) << complaint;
}

TEST(HeaderExamples, ABodyTurnsAboutItsAxes)
{
    const kerf::Object piece = *prepare(*make_shape("box", 12));
    const double steel = 7800.0;
    double mass_of_body = 0.0;
    const auto add_body = [&](double mass, const kerf::Vec3d&, const kerf::Mat3d&, const kerf::Vec3d& moments) {
        mass_of_body = mass;
        EXPECT_LE(moments.x, moments.z);
    };
#include "examples/kerf_mass_1.inc"
    EXPECT_NEAR(mass_of_body, steel * mass.volume, 1e-9 * mass_of_body);
    EXPECT_GT(mass_of_body, 0.0);
}

TEST(HeaderExamples, AVectorOfAProgramConverts)
{
#include "examples/kerf_math_1.inc"
    EXPECT_EQ(centre, Vec3d(1, 2, 3));
    EXPECT_EQ(back, glm::dvec3(1, 2, 3));
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

TEST(HeaderExamples, AMeshIsPreparedForOneCut)
{
    std::string complaint, back_end;
    const auto complain = [&](const char* reason) { complaint = reason; };
    const auto attempt = [&](kerf::Mesh mesh) {
#include "examples/kerf_object_1.inc"
        back_end = object->back_end_name();
    };
    attempt({});
    EXPECT_NE(complaint, "");
    attempt(*make_shape("asteroid", 1000));
    EXPECT_EQ(back_end, "linear");
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

#ifdef KERF_HAS_PROXY
TEST(HeaderExamples, AHullIsABody)
{
    const kerf::Object piece = *prepare(*make_shape("asteroid", 1000));
    std::size_t points = 0;
    const auto add_body = [&](std::span<const kerf::Vec3f> hull) { points = hull.size(); };
#include "examples/kerf_proxy_1.inc"
    EXPECT_GT(points, 8u);
    EXPECT_LE(points, 32u);
}
#endif

TEST(HeaderExamples, ASectionIsUsedForOnePlaneAfterTheOther)
{
    const kerf::Object object = *prepare(*make_shape("asteroid", 1000));
    const std::vector<kerf::Plane> planes{*Plane::z(-0.2), *Plane::z(0.0), *Plane::z(9.0)};
    std::vector<double> areas;
    const auto draw = [&](const kerf::Section& found) { areas.push_back(found.area); };
#include "examples/kerf_section_1.inc"
    ASSERT_EQ(areas.size(), 2u) << "the last plane misses";
    EXPECT_NE(areas[0], areas[1]);
}

TEST(HeaderExamples, AStackOfSectionsIsListed)
{
    const kerf::Object object = *prepare(*make_shape("asteroid", 1000));
    testing::internal::CaptureStdout();
#include "examples/kerf_section_2.inc"
    const std::string areas = testing::internal::GetCapturedStdout();
    EXPECT_EQ(std::count(areas.begin(), areas.end(), '\n'), 3);
}

TEST(HeaderExamples, AFewSectionsNeedNoPreparing)
{
    const kerf::Mesh mesh = *kerf::make_shape("asteroid", 1000);
    const double heights[] = {-0.2, 0.0, 0.2};
#include "examples/kerf_section_3.inc"
    EXPECT_EQ(options.back_end, kerf::BackEnd::linear);
}

TEST(HeaderExamples, AShapeIsMade)
{
    std::string complaint;
    std::uint64_t triangles = 0;
    const auto complain = [&](const char* reason) { complaint = reason; };
    const auto attempt = [&] {
#include "examples/kerf_shapes_1.inc"
        triangles = rock->triangle_count();
    };
    attempt();
    EXPECT_EQ(complaint, "");
    EXPECT_NEAR(double(triangles), 1e5, 1e4);
}

TEST(HeaderExamples, TheCostOfACutIsPrinted)
{
    const kerf::Cut cut = cut_in_two();
    testing::internal::CaptureStdout();
#include "examples/kerf_statistics_1.inc"
    EXPECT_NE(testing::internal::GetCapturedStdout().find(" triangles\n"), std::string::npos);
    EXPECT_GT(cost.crossing_triangles, 0u);
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

TEST(HeaderExamples, WhatIsStoredIsCutAnewIfBitsHaveChanged)
{
    struct Stored
    {
        std::uint32_t bits_version = 0;
    } stored;
    const auto cut_anew = [] { return Stored{bits_version()}; };
#include "examples/kerf_version_1.inc"
    EXPECT_EQ(stored.bits_version, bits_version());
}

}  // namespace
}  // namespace kerf
