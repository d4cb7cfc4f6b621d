#include "viewer/render/image_table.h"

#include <kerf/io.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "support/temporary_folder.h"
#include "viewer/render/frame_target.h"
#include "viewer/render/gl_test.h"
#include "viewer/render/inspection_pass.h"
#include "viewer/render/pieces_on_stage.h"
#include "viewer/sim/back_ends.h"
#include "viewer/support/stages.h"

namespace kerf::test {

namespace {

using render::Picture;

constexpr int kSheetWidth = 240, kSheetHeight = 180;
constexpr int kCells = 8;

/// In a list of all pixels.
std::size_t sheet_place_of(int x, int y)
{
    return static_cast<std::size_t>(y) * kSheetWidth + static_cast<std::size_t>(x);
}

using Rgb = std::array<std::uint8_t, 3>;
constexpr Rgb kRed{200, 20, 20}, kGreen{20, 160, 30};

bool is_red_cell(int column, int row_from_top)
{
    return (column + row_from_top) % 2 == 0;
}

class ImageTest : public GlTest
{
protected:
    /// Writes `cells` x `cells` squares of so many pixels.
    template <class ColourOf>
    std::string image(const std::string& name, int cells, ColourOf colour_of, int side = 16) const
    {
        Picture picture{side * cells, side * cells, {}};
        for (int y = 0; y < picture.height; ++y)
            for (int x = 0; x < picture.width; ++x) {
                const Rgb c = colour_of(x / side, y / side);
                picture.rgba.insert(picture.rgba.end(), {c[0], c[1], c[2], 255});
            }
        const std::filesystem::path path = folder.file(name);
        render::write_png(path, picture);
        return path.string();
    }
    std::string checker() const
    {
        return image("checker.png", kCells,
                     [](int column, int row) { return is_red_cell(column, row) ? kRed : kGreen; });
    }

    Picture picture_of(const std::vector<render::DrawnObject>& objects)
    {
        render::DrawOptions options;
        options.wall = false;
        target.bind();
        renderer.draw(near_viewpoint(kSheetWidth, kSheetHeight), objects, options, {0, 0, kSheetWidth, kSheetHeight});
        target.resolve();
        return target.read();
    }

    TemporaryFolder folder;
    render::LookTable looks;
    render::FragmentStore store{looks};
    render::SceneRenderer renderer{looks};
    render::FrameTarget target{kSheetWidth, kSheetHeight};
    render::InspectionPass inspection{kSheetWidth, kSheetHeight};
};

}  // namespace

/// Whole or cut, however it is turned: what is seen at a place of the surface is the image's colour there.
TEST_F(ImageTest, StaysWhereItsUvSay)
{
    for (const std::string& backend : back_end_of_each_kind()) {
        for (const int cuts : {0, 2})
            for (const float turn : {0.4f, 2.1f}) {
                SCOPED_TRACE(backend + ", " + std::to_string(cuts) + " cuts, turned by " + std::to_string(turn));
                std::vector<StagedPiece> pieces = pieces_of("sphere", backend, cuts, turn, checker());
                const std::vector<render::DrawnFragment> fragments = uploaded(store, pieces);
                const auto objects = drawn(pieces, fragments);
                const auto seen = inspection.draw(near_viewpoint(kSheetWidth, kSheetHeight), objects);
                const Picture picture = picture_of(objects);
                int red = 0, green = 0, wrong = 0;
                for (int y = 1; y + 1 < kSheetHeight; ++y)
                    for (int x = 1; x + 1 < kSheetWidth; ++x) {
                        const auto at = [&](int dx, int dy) -> const render::PixelFacts& {
                            return seen[sheet_place_of(x + dx, y + dy)];
                        };
                        const render::PixelFacts& pixel = at(0, 0);
                        if (pixel.object == 0 || pixel.is_cap()) continue;
                        const glm::vec2 place = pixel.uv * float(kCells);
                        const glm::ivec2 cell(glm::floor(place));
                        bool is_inner = true;  // the pixels around are of the same cell, too
                        for (const auto& [dx, dy] : {std::pair(-1, 0), {1, 0}, {0, -1}, {0, 1}})
                            is_inner = is_inner && at(dx, dy).object == pixel.object && !at(dx, dy).is_cap() &&
                                       glm::ivec2(glm::floor(at(dx, dy).uv * float(kCells))) == cell;
                        if (!is_inner) continue;
                        const std::uint8_t* const rgb = picture.pixel(x, y);
                        const bool expected = is_red_cell(cell.x, kCells - 1 - cell.y);
                        ++(expected ? red : green);
                        if ((rgb[0] > rgb[1]) != expected) ++wrong;
                    }
                EXPECT_GT(red, 500);
                EXPECT_GT(green, 500);
                EXPECT_LE(wrong, (red + green) / 200);
            }
    }
    EXPECT_TRUE(looks.take_messages().empty());
}

TEST_F(ImageTest, IsDecodedFromSrgb)
{
    // sRGB 188 is half the light of white: the same as a material of that colour.
    const float linear = std::pow((188.0f / 255.0f + 0.055f) / 1.055f, 2.4f);
    const std::string grey = image("grey.png", 1, [](int, int) { return Rgb{188, 188, 188}; });
    std::vector<Picture> pictures;
    for (const bool by_image : {true, false}) {
        const Mesh sphere = value_of(read_mesh(KERF_DATA_DIR "/models/sphere.obj"));
        const float light = by_image ? 1.0f : linear;
        const Material colour{"a colour", {light, light, light, 1.0f}, by_image ? grey.c_str() : ""};
        const std::vector<Material> materials(sphere.material_count(), colour);
        MeshInput input = input_of(sphere);
        input.triangle_materials = sphere.arrays().triangle_materials.data();
        input.materials = materials;
        Object object = object_of(value_of(Mesh::make(input)), sim::backend_names().back());
        const render::DrawnFragment fragment = store.add(object);
        pictures.push_back(picture_of({{1, &fragment, glm::mat4(1.0f), 1.0f}}));
    }
    int most = 0, lit = 0;
    for (std::size_t i = 0; i < pictures[0].rgba.size(); ++i) {
        most = std::max(most, std::abs(int(pictures[0].rgba[i]) - int(pictures[1].rgba[i])));
        lit += pictures[0].rgba[i] > 40 && i % 4 == 0;
    }
    EXPECT_LE(most, 2);
    EXPECT_GT(lit, 1000);
}

TEST_F(ImageTest, IsAveragedFromFarAway)
{
    // Squares much smaller than a pixel: the sphere is of one colour, the mean of both.
    const std::string fine = image(
        "fine.png", 1024,
        [](int column, int row) {
            return is_red_cell(column, row) ? Rgb{255, 255, 255} : Rgb{0, 0, 0};
        },
        1);
    std::vector<StagedPiece> pieces = pieces_of("sphere", sim::backend_names().back(), 0, 0.4f, fine);
    const std::vector<render::DrawnFragment> fragments = uploaded(store, pieces);
    const Picture picture = picture_of(drawn(pieces, fragments));
    int jumps = 0, compared = 0;
    for (int y = 60; y < 120; ++y)
        for (int x = 90; x < 150; ++x) {
            const int difference = std::abs(int(picture.pixel(x, y)[0]) - int(picture.pixel(x + 1, y)[0]));
            jumps += difference > 40;
            ++compared;
        }
    EXPECT_LE(jumps, compared / 50);
}

TEST_F(ImageTest, ThatCannotBeReadIsSaidOnceAndTheColourIsDrawn)
{
    const std::string missing = folder.file("missing.png").string(), broken = folder.file("broken.png").string(),
                      half = folder.file("half.png").string();
    std::ofstream(broken) << "this is no picture";
    const std::string whole = checker();
    std::filesystem::copy_file(whole, half);
    std::filesystem::resize_file(half, std::filesystem::file_size(half) / 2);
    const std::vector<Material> plain{{"mine", {0.1f, 0.2f, 0.9f, 1.0f}, ""}};
    const std::uint32_t expected = looks.index_of(plain, 0, TriangleKind::surface);
    for (const std::string& path : {missing, broken, half, folder.path().string()}) {
        std::vector<Material> materials = plain;
        materials[0].base_colour_image = path.c_str();
        EXPECT_EQ(looks.index_of(materials, 0, TriangleKind::surface), expected) << path;
        const std::vector<std::string> messages = looks.take_messages();
        ASSERT_EQ(messages.size(), 1u) << path;
        EXPECT_NE(messages[0].find(path), std::string::npos) << messages[0];
        EXPECT_EQ(looks.index_of(materials, 0, TriangleKind::surface), expected) << path;
        EXPECT_TRUE(looks.take_messages().empty()) << "said once";
    }
}

}  // namespace kerf::test
