// The fifteen models and real meshes, broken into 64 cells by three patterns, with each back end.

#include <gtest/gtest.h>
#include <kerf/io.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "api/fracture_referee.h"
#include "api/objects.h"
#include "support/brief.h"
#include "support/real_files.h"

namespace kerf {
namespace {

/// Real meshes that are closed and do not pass through themselves: a folded surface, a skull and a cheese with tunnels among
/// them.
constexpr const char* kReal[]{"mni_t1iso60_804k.ply", "skull.obj", "cheese.off", "spot.obj", "bob.obj", "knot2.off"};

/// Of the models, where builds are slow.
constexpr const char* kFew[]{"cube.obj", "icosphere.obj", "rook.obj"};

class RealFracture : public testing::TestWithParam<std::filesystem::path>
{
};

std::vector<std::filesystem::path> files()
{
    std::vector<std::filesystem::path> found = core::test::real_files();
    std::erase_if(found, [](const std::filesystem::path& file) {
        if (test::kBrief) return std::ranges::find(kFew, file.filename()) == std::end(kFew);
        const bool is_model = file.parent_path().filename() == "models";
        return !is_model && std::ranges::find(kReal, file.filename()) == std::end(kReal);
    });
    return found;
}

INSTANTIATE_TEST_SUITE_P(All, RealFracture, testing::ValuesIn(files()),
                         [](const auto& param) { return core::test::test_name_of(param.param); });

TEST_P(RealFracture, PiecesFillTheObjectAndFitTogether)
{
    const Result<Mesh> mesh = read_mesh(GetParam().string().c_str());
    ASSERT_TRUE(mesh) << mesh.reason();
    if (!mesh->is_closed()) GTEST_SKIP() << "it is open";
    for (const FracturePattern pattern :
         {FracturePattern::uniform, FracturePattern::impact, FracturePattern::splinters}) {
        SCOPED_TRACE("pattern " + std::to_string(int(pattern)));
        std::vector<std::vector<test::Corners>> surfaces;
        for (const std::string& back_end : test::back_end_names()) {
            SCOPED_TRACE(back_end);
            const Object whole = test::object_of(*mesh, back_end);
            FractureOptions options;
            options.pattern = pattern;
            options.cells = 64;
            options.seed = 1;
            Fracture fracture = kerf::fracture(whole, options);
            test::expect_right(whole, fracture);
            if (HasFatalFailure()) return;
            std::set<std::uint32_t> cells;
            for (std::size_t i = 0; i < fracture.count(); ++i)
                cells.insert(fracture.cells(i).begin(), fracture.cells(i).end());
            EXPECT_EQ(cells.size(), 64u) << "cells were lost";
            // All pieces' triangles: which piece has which follows from the sites, which are the same.
            std::vector<test::Corners>& surface = surfaces.emplace_back();
            for (std::size_t i = 0; const Object* const piece = fracture.piece(i); ++i) {
                const std::vector<test::Corners> of_piece = test::Triangles(*piece).surface;
                surface.insert(surface.end(), of_piece.begin(), of_piece.end());
            }
            std::ranges::sort(surface);
            EXPECT_EQ(surface, surfaces.front()) << "back ends differ";
        }
    }
}

}  // namespace
}  // namespace kerf
