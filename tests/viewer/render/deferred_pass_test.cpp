#include "viewer/render/deferred_pass.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <glm/ext/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include "common/shapes/shapes.h"
#include "support/public_mesh.h"
#include "viewer/render/frame_target.h"
#include "viewer/render/gl_test.h"
#include "viewer/render/pieces_on_stage.h"
#include "viewer/render/scene_renderer.h"
#include "viewer/sim/back_ends.h"
#include "viewer/sim/kerf_glm.h"
#include "viewer/support/stages.h"

namespace kerf::test {

namespace {

using render::DrawnFragment;
using render::DrawnObject;
using render::DrawOptions;
using render::Lighting;
using render::Picture;

constexpr int kSceneWidth = 200, kSceneHeight = 160;

/// Nothing but asteroid is seen there.
constexpr render::ScreenRectangle kMiddle{64, 48, 64, 64};

/// An asteroid of stone that fills most of the picture's height, in a mesh of any unit.
std::vector<StagedPiece> asteroid(std::uint64_t triangles, const char* material = "rock", float unit = 1.0f)
{
    core::TriangleSoup soup = core::shapes::asteroid(triangles, 5);
    for (core::Vertex& vertex : soup.vertices) vertex.position *= unit;
    core::Material stone;
    stone.name = material;
    soup.materials = {stone};
    std::vector<StagedPiece> pieces;
    pieces.push_back({object_of(mesh_of(soup), sim::backend_names().back()), glm::mat4(1.0f), 0.5f, {}, true});
    const Box box = pieces.front().object.bounds();
    const auto radius = static_cast<float>(sim::radius_of(box));
    pieces.front().model =
        glm::translate(glm::scale(glm::mat4(1.0f), glm::vec3(1.5f / radius)), -glm::vec3(sim::centre_of(box)));
    pieces.front().pattern_scale = 0.5f / radius;
    return pieces;
}

/// Of two pictures of one size.
struct Difference
{
    double mean = 0.0;  ///< of a channel, 0 to 1
    double off = 0.0;   ///< share of pixels with a channel that differs by more than 16 of 255
};

Difference difference(const Picture& a, const Picture& b)
{
    Difference found;
    for (std::size_t i = 0; i < a.rgba.size(); i += 4) {
        int most = 0;
        for (std::size_t c = 0; c < 3; ++c) {
            const int apart = std::abs(int(a.rgba[i + c]) - int(b.rgba[i + c]));
            found.mean += apart / 255.0;
            most = std::max(most, apart);
        }
        found.off += most > 16;
    }
    const double pixels = static_cast<double>(a.rgba.size()) / 4.0;
    return {found.mean / (3.0 * pixels), found.off / pixels};
}

class DeferredPass : public GlTest
{
protected:
    Picture picture_of(const std::vector<DrawnObject>& objects, DrawOptions options, bool deferred)
    {
        options.deferred = deferred;
        target.bind();
        renderer.draw(near_viewpoint(kSceneWidth, kSceneHeight), objects, options, {0, 0, kSceneWidth, kSceneHeight});
        target.resolve();
        return target.read();
    }

    /// How often a shader runs to shade what an asteroid of so many triangles looks like.
    std::uint64_t shader_runs(std::uint64_t triangles);

    render::LookTable looks;
    render::FragmentStore store{looks};
    render::SceneRenderer renderer{looks};
    render::FrameTarget target{kSceneWidth, kSceneHeight};
};

std::uint64_t DeferredPass::shader_runs(std::uint64_t triangles)
{
    std::vector<StagedPiece> pieces = asteroid(triangles);
    const std::vector<DrawnFragment> fragments = uploaded(store, pieces);
    const std::vector<DrawnObject> objects = drawn(pieces, fragments);
    picture_of(objects, {}, true);

    // The renderer has left its uniforms behind; how much light there is does not matter.
    render::DeferredPass pass;
    render::SurfacePrograms programs(looks);
    render::DrawStatistics statistics;
    GLint samples = 0;
    target.bind();
    glGetIntegerv(GL_SAMPLES, &samples);
    GLint framebuffer = 0;
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer);
    const render::PictureTarget onto{static_cast<GLuint>(framebuffer), samples, 0, 0, kSceneWidth, kSceneHeight};
    const render::PlacedDraw draw{{&objects.front(), &fragments.front().batches.front()}, kMiddle};
    glEnable(GL_DEPTH_TEST);
    pass.fill(std::span(&draw, 1), onto, statistics);
    GLuint query = 0;
    glGenQueries(1, &query);
    glBeginQuery(GL_FRAGMENT_SHADER_INVOCATIONS_ARB, query);
    pass.shade(std::span(&draw, 1), Lighting::textured, onto, programs);
    glEndQuery(GL_FRAGMENT_SHADER_INVOCATIONS_ARB);
    std::uint64_t runs = 0;
    glGetQueryObjectui64v(query, GL_QUERY_RESULT, &runs);
    glDeleteQueries(1, &query);
    return runs;
}

}  // namespace

TEST_F(DeferredPass, ShadesEachPixelOnceHoweverManyTrianglesAreInIt)
{
    if (!epoxy_has_gl_extension("GL_ARB_pipeline_statistics_query")) GTEST_SKIP() << "the driver does not count";
    const std::uint64_t coarse = shader_runs(20'000), fine = shader_runs(200'000);
    EXPECT_EQ(coarse, fine);
    // Each pixel is asked twice: for what is seen, and for what is behind an outline, which is hardly ever anything.
    // Drivers count a block more at the edges.
    const std::uint64_t pixels = static_cast<std::uint64_t>(kMiddle.pixels());
    EXPECT_GE(coarse, pixels);
    EXPECT_LT(coarse, 3 * pixels);
}

TEST_F(DeferredPass, LooksLikeShadingWhileDrawing)
{
    for (const char* material : {"rock", "stone", "paint", "unknown"})
        for (const Lighting lighting : {Lighting::lambert, Lighting::textured})
            for (const std::uint64_t triangles : {10'000u, 100'000u}) {
                std::vector<StagedPiece> pieces = asteroid(triangles, material);
                const std::vector<DrawnFragment> fragments = uploaded(store, pieces);
                const std::vector<DrawnObject> objects = drawn(pieces, fragments);
                DrawOptions options;
                options.lighting = lighting;
                const Picture at_once = picture_of(objects, options, false);
                const Picture deferred = picture_of(objects, options, true);
                const Difference apart = difference(at_once, deferred);
                SCOPED_TRACE(std::string(material) + ", " + std::to_string(triangles) + " triangles");
                EXPECT_FALSE(at_once == deferred) << "it was not deferred";
                EXPECT_LT(apart.mean, 0.01);
                EXPECT_LE(apart.off, 0.01);
            }
}

TEST_F(DeferredPass, LooksTheSameInAnyUnit)
{
    for (const float unit : {1e-9f, 1e-6f, 1e6f, 1e9f}) {
        std::vector<StagedPiece> pieces = asteroid(20'000, "rock", unit);
        const std::vector<DrawnFragment> fragments = uploaded(store, pieces);
        const std::vector<DrawnObject> objects = drawn(pieces, fragments);
        const Difference apart = difference(picture_of(objects, {}, false), picture_of(objects, {}, true));
        SCOPED_TRACE("unit " + std::to_string(unit));
        EXPECT_GT(apart.mean, 0.0) << "it was not deferred";
        EXPECT_LT(apart.mean, 0.01);
        EXPECT_LE(apart.off, 0.01);
    }
}

TEST_F(DeferredPass, HidesAndIsHiddenLikeWhatIsShadedWhileDrawing)
{
    // A cube, which is shaded while it is drawn, stands half in an asteroid, which is not.
    std::vector<StagedPiece> pieces = asteroid(50'000);
    for (StagedPiece& piece : pieces_of("cube", sim::backend_names().back(), 0, 0.6f)) {
        piece.model = glm::translate(glm::mat4(1.0f), glm::vec3(0.6f, 0.3f, 0.5f)) * piece.model;
        pieces.push_back(std::move(piece));
    }
    const std::vector<DrawnFragment> fragments = uploaded(store, pieces);
    const std::vector<DrawnObject> objects = drawn(pieces, fragments);
    const Difference apart = difference(picture_of(objects, {}, false), picture_of(objects, {}, true));
    EXPECT_GT(apart.mean, 0.0) << "it was not deferred";
    EXPECT_LT(apart.mean, 0.01);
    EXPECT_LE(apart.off, 0.01);
}

TEST_F(DeferredPass, KeepsEdgesOfTrianglesOnTheirSurface)
{
    std::vector<StagedPiece> pieces = asteroid(2'000);
    const std::vector<DrawnFragment> fragments = uploaded(store, pieces);
    const std::vector<DrawnObject> objects = drawn(pieces, fragments);
    DrawOptions wired;
    wired.wireframe = true;
    const Difference apart = difference(picture_of(objects, wired, false), picture_of(objects, wired, true));
    EXPECT_GT(apart.mean, 0.0) << "it was not deferred";
    EXPECT_LT(apart.mean, 0.01);
    EXPECT_LE(apart.off, 0.01);
    EXPECT_FALSE(picture_of(objects, wired, true) == picture_of(objects, {}, true));
}

TEST_F(DeferredPass, LeavesFewLargeTrianglesToShadingWhileDrawing)
{
    std::vector<StagedPiece> pieces = pieces_of("cube", sim::backend_names().back(), 1, 0.6f);
    const std::vector<DrawnFragment> fragments = uploaded(store, pieces);
    const std::vector<DrawnObject> objects = drawn(pieces, fragments);
    EXPECT_TRUE(picture_of(objects, {}, false) == picture_of(objects, {}, true));
}

}  // namespace kerf::test
