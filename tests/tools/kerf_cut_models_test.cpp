#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "common/io/mesh_file.h"
#include "common/mesh/plane.h"
#include "common/mesh/plane_noise.h"
#include "tools/program.h"

// `kerf cut` of the report's models and of real meshes: what is on the disk afterwards is right.

namespace kerf::tools {
namespace {

class KerfCutModels : public ProgramTest
{
protected:
    static std::vector<std::filesystem::path> meshes_in(const std::filesystem::path& folder)
    {
        static const std::array<std::string, 6> kFormats{".obj", ".off", ".ply", ".STL", ".stl", ".glb"};
        // Most of the time would go into the largest file, which has nothing that the others have not.
        constexpr std::uintmax_t kLargest = 5'000'000;
        std::vector<std::filesystem::path> files;
        for (const auto& entry : std::filesystem::directory_iterator(folder))
            if (std::find(kFormats.begin(), kFormats.end(), entry.path().extension()) != kFormats.end() &&
                entry.file_size() < kLargest)
                files.push_back(entry.path());
        std::sort(files.begin(), files.end());
        return files;
    }

    /// Cuts by a plane and reads both files again.
    void check_cut(const std::filesystem::path& file, const core::io::LoadedMesh& whole, const glm::dvec3& point,
                   const glm::dvec3& normal)
    {
        const auto text = [](const glm::dvec3& v) { return Json({v.x, v.y, v.z}).dump(); };
        const auto bare = [](const std::string& list) { return list.substr(1, list.size() - 2); };
        SCOPED_TRACE(file.filename().string() + " through " + text(point) + " across " + text(normal));
        const Json cut = kerf_json("cut '" + file.string() + "' --point " + bare(text(point)) + " --normal " +
                                   bare(text(normal)) + " --format ply --out half");
        if (cut["status"] == "missed") return;
        ++cuts_;
        const core::MeshFacts before = core::measure(whole.mesh);
        const core::Plane plane = *core::Plane::through(point, normal);
        const double noise = core::plane_noise(before.bounds.largest_coordinate());
        double volume = 0.0, surface = 0.0;
        for (const char* side : {"positive", "negative"}) {
            const core::io::LoadedMesh half = core::io::read_mesh(folder_ / ("half." + std::string(side) + ".ply"));
            EXPECT_EQ(half.facts.degenerate_triangles, 0u);
            const double sign = side[0] == 'p' ? 1.0 : -1.0;
            for (const core::Vertex& v : half.mesh->vertices)
                ASSERT_GE(sign * plane.signed_distance(v.position), -noise);
            volume += cut[side]["volume"].get<double>();
            surface += cut[side]["surface_area"].get<double>();
            if (!before.closed()) continue;
            EXPECT_EQ(cut[side]["closed"], true);
            EXPECT_EQ(half.facts.boundary_edges, 0u);
            EXPECT_NEAR(half.facts.volume, cut[side]["volume"].get<double>(), 1e-6 * std::abs(before.volume));
        }
        EXPECT_NEAR(surface, before.area, 1e-6 * before.area);
        EXPECT_EQ(cut["status"], cut["counts"]["open_chains"] > 0 ? "open_section" : "cut");
        if (!before.closed()) return;
        EXPECT_EQ(cut["status"], "cut");
        EXPECT_NEAR(volume, before.volume, 1e-6 * std::abs(before.volume));
    }

    void check_all(const std::vector<std::filesystem::path>& files)
    {
        std::mt19937 random(1);
        std::uniform_real_distribution<double> between(-1.0, 1.0);
        for (const std::filesystem::path& file : files) {
            const core::io::LoadedMesh whole = core::io::read_mesh(file);
            const glm::dvec3 centre = whole.mesh->bounds().centre();
            const auto any_direction = [&] { return glm::dvec3(between(random), between(random), between(random)); };
            check_cut(file, whole, centre, any_direction());
            check_cut(file, whole, centre, {0, 1, 0});
            const auto vertex = [&](std::size_t corner) {
                return glm::dvec3(
                    whole.mesh->vertices[whole.mesh->triangles[random() % whole.mesh->triangles.size()][corner]]
                        .position);
            };
            check_cut(file, whole, vertex(0), any_direction());
            // In a face.
            const core::Triangle& t = whole.mesh->triangles[whole.mesh->triangles.size() / 2];
            const auto p = [&](std::size_t i) { return glm::dvec3(whole.mesh->vertices[t[i]].position); };
            check_cut(file, whole, p(0), glm::cross(p(1) - p(0), p(2) - p(0)));
        }
    }

    int cuts_ = 0;
};

TEST_F(KerfCutModels, AreRightForTheReportsModels)
{
    const auto files = meshes_in(std::filesystem::path(KERF_DATA_DIR) / "models");
    ASSERT_GE(files.size(), 12u);
    check_all(files);
    EXPECT_GT(cuts_, 30);
}

TEST_F(KerfCutModels, AreRightForRealMeshes)
{
    const std::filesystem::path folder = KERF_SHARED_MESHES_DIR;
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << "the shared meshes are not here";
    check_all(meshes_in(folder));
    EXPECT_GT(cuts_, 30);
}

}  // namespace
}  // namespace kerf::tools
