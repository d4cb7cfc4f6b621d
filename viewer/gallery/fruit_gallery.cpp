// fruit_gallery PICTURE [NAME ...]: draws the fruit of data/fruit - whole, cut across, cut along, cut askew - onto one
// sheet, a row for each.

#include <kerf/cut.h>
#include <kerf/io.h>
#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <iostream>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "viewer/render/frame_target.h"
#include "viewer/render/offscreen_context.h"
#include "viewer/render/picture.h"
#include "viewer/render/scene_renderer.h"
#include "viewer/sim/back_ends.h"
#include "viewer/sim/kerf_glm.h"

namespace kerf::app {
namespace {

constexpr std::array<const char*, 14> kNames{"watermelon", "apple", "orange", "lemon",  "kiwi",   "banana", "coconut",
                                             "pineapple",  "bomb",  "freeze", "frenzy", "double", "hammer", "frozen"};

/// A banana's axis is an arc about z: across is the middle of the arc.
bool is_banana(const std::string& name)
{
    return name == "banana" || name == "freeze" || name == "frenzy" || name == "double" || name == "hammer";
}

/// How a tile shows a fruit.
struct Pose
{
    glm::dvec3 normal{0.0};  ///< of the cut; 0: whole
    glm::dvec3 up;           ///< of the object, upright in the picture
};

constexpr std::array<Pose, 4> kPoses{
    {{{0, 0, 0}, {0, 1, 0}}, {{0, 1, 0}, {0, 0, -1}}, {{0, 0, 1}, {0, 1, 0}}, {{0.5, 0.62, 0.61}, {0, 1, 0}}}};

Pose pose_of(const std::string& name, std::size_t column)
{
    return column == 1 && is_banana(name) ? Pose{{1, 0.1, 0}, {0, 1, 0}} : kPoses[column];
}

/// Turns `front` of the object towards `to` and `up` upright.
glm::mat4 turned(const glm::vec3& front, const glm::vec3& up, const glm::vec3& to)
{
    const auto basis = [](const glm::vec3& z, const glm::vec3& y) {
        const glm::vec3 x = glm::normalize(glm::cross(y, z));
        return glm::mat3(x, glm::cross(z, x), z);
    };
    const glm::vec3 level = std::abs(glm::dot(front, up)) > 0.99f ? glm::vec3(1, 0, 0) : up;
    return glm::mat4(basis(glm::normalize(to), {0, 1, 0}) * glm::transpose(basis(front, level)));
}

/// @throws std::runtime_error
template <class T>
T value_of(Result<T> result)
{
    if (!result) throw std::runtime_error(result.reason());
    return *std::move(result);
}

struct Piece
{
    Object object;
    glm::mat4 model{1.0f};

    /// The box around it in the picture's frame.
    Box box() const
    {
        glm::vec3 lo(std::numeric_limits<float>::infinity()), hi(-lo);
        const Mesh mesh = value_of(object.mesh());
        for (const Vec3f& p : mesh.arrays().positions) {
            const glm::vec3 placed(model * glm::vec4(glm::vec3(p), 1.0f));
            lo = glm::min(lo, placed);
            hi = glm::max(hi, placed);
        }
        return {lo, hi};
    }
};

/// The fruit as a pose shows it: halves lie open like a book.
std::vector<Piece> posed(Object whole, const Pose& pose)
{
    std::vector<Piece> pieces;
    const glm::vec3 middle(sim::centre_of(whole.bounds()));
    if (pose.normal == glm::dvec3(0.0)) {
        glm::mat4 model = turned({0, 0, 1}, {0, 1, 0}, {0.45f, -0.42f, 1.0f});
        pieces.push_back({std::move(whole), glm::translate(model, -middle)});
        return pieces;
    }
    const glm::dvec3 normal = glm::normalize(pose.normal);
    // A little beside the middle, where symmetry would hide that nothing swims.
    Cut result = cut(std::move(whole), Plane::at(Point(0.0, 0.02, 0.03), Normal(normal)).value());
    if (result.status != Status::done) throw std::runtime_error("the cut missed");
    const auto show = [&](Object& object, float side) {
        const glm::vec3 front = glm::vec3(normal) * side;
        const glm::mat4 model = turned(front, glm::vec3(pose.up), {-0.25f * side, 0.30f, 1.0f});
        const glm::vec3 centre(sim::centre_of(object.bounds()));
        const glm::vec3 at = glm::vec3(model * glm::vec4(centre, 0.0f));
        pieces.push_back({std::move(object), glm::translate(glm::mat4(1.0f), -at) * model});
    };
    if (Object* const half = result.one(Side::positive)) show(*half, -1.0f);
    if (Object* const half = result.one(Side::negative)) show(*half, 1.0f);
    // Side by side.
    float width = 0.0f;
    for (const Piece& piece : pieces) width += piece.box().hi.x - piece.box().lo.x;
    float left = -0.5f * width;
    for (Piece& piece : pieces) {
        const Box box = piece.box();
        const glm::vec3 to{left, -0.5f * (box.lo.y + box.hi.y), 0.0f};
        piece.model = glm::translate(glm::mat4(1.0f), to - glm::vec3(box.lo.x, 0.0f, 0.0f)) * piece.model;
        left += box.hi.x - box.lo.x;
    }
    return pieces;
}

/// Half the height of the picture that shows them all.
float reach_of(const std::vector<Piece>& pieces, float aspect)
{
    float reach = 0.1f;
    for (const Piece& piece : pieces) {
        const Box box = piece.box();
        reach = std::max({reach, box.hi.y, -box.lo.y, box.hi.x / aspect, -box.lo.x / aspect});
    }
    return reach;
}

class Gallery
{
public:
    Gallery(std::filesystem::path folder, const std::string& backend, int height)
        : folder_(std::move(folder)), backend_(backend), height_(height), target_(width(), height)
    {
    }

    render::Picture draw(const std::vector<std::string>& names)
    {
        render::Picture sheet;
        sheet.width = width() * static_cast<int>(kPoses.size());
        sheet.height = height_ * static_cast<int>(names.size());
        sheet.rgba.resize(4 * static_cast<std::size_t>(sheet.width) * static_cast<std::size_t>(sheet.height));
        for (std::size_t row = 0; row < names.size(); ++row) {
            const Mesh mesh = value_of(read_mesh((folder_ / (names[row] + ".glb")).c_str()));
            const bool is_closed = mesh.is_closed();
            const Object whole = value_of(sim::prepare(mesh, backend_));
            for (std::size_t column = 0; column < kPoses.size(); ++column)
                paste(tile(value_of(whole.clone()), is_closed, pose_of(names[row], column)), sheet,
                      static_cast<int>(column) * width(), static_cast<int>(row) * height_);
        }
        return sheet;
    }

private:
    int width() const { return height_ * 4 / 3; }

    render::Picture tile(Object whole, bool is_closed, const Pose& pose)
    {
        const auto size = static_cast<float>(2.0 * sim::radius_of(whole.bounds()));
        std::vector<Piece> pieces = posed(std::move(whole), pose);
        std::vector<render::DrawnFragment> fragments;
        for (Piece& piece : pieces) fragments.push_back(store_.add(piece.object));
        std::vector<render::DrawnObject> objects;
        for (std::size_t i = 0; i < pieces.size(); ++i)
            objects.push_back(
                {static_cast<std::uint32_t>(i + 1), &fragments[i], pieces[i].model, 1.0f / size, is_closed});

        const float aspect = 4.0f / 3.0f;
        const float reach = 1.12f * reach_of(pieces, aspect);
        render::Viewpoint viewpoint;
        viewpoint.eye = {0.0f, 0.0f, 10.0f};
        viewpoint.view = glm::lookAt(viewpoint.eye, glm::vec3(0.0f), glm::vec3(0.0f, 1.0f, 0.0f));
        viewpoint.projection = glm::perspective(2.0f * std::atan(reach / 10.0f), aspect, 0.5f, 60.0f);
        target_.bind();
        renderer_.draw(viewpoint, objects, {}, {0, 0, target_.width(), target_.height()});
        target_.resolve();
        return target_.read();
    }

    static void paste(const render::Picture& tile, render::Picture& sheet, int x, int y)
    {
        for (int row = 0; row < tile.height; ++row)
            std::memcpy(sheet.rgba.data() + (sheet.pixel(x, y + row) - sheet.rgba.data()), tile.pixel(0, row),
                        4 * static_cast<std::size_t>(tile.width));
    }

    std::filesystem::path folder_;
    std::string backend_;
    int height_;
    render::LookTable looks_;
    render::FragmentStore store_{looks_};
    render::SceneRenderer renderer_{looks_};
    render::FrameTarget target_;
};

int run(int argc, char** argv)
{
    std::string picture, backend = sim::backend_names().front(), data = KERF_DATA_DIR;
    std::vector<std::string> names;
    int height = 240;
    CLI::App program("Draws the game's fruit whole, cut across, along and askew.", "fruit_gallery");
    program.add_option("PICTURE", picture, "the sheet, a PNG or (.jpg) JPEG file")->required();
    program.add_option("NAME", names, "fruit (default: all)");
    program.add_option("--backend", backend, "what cuts")->check(CLI::IsMember(sim::backend_names()));
    program.add_option("--data", data, "folder that holds fruit/")->type_name("DIR");
    program.add_option("--height", height, "of a tile in pixels")->check(CLI::Range(16, 2048));
    CLI11_PARSE(program, argc, argv);
    if (names.empty()) names.assign(kNames.begin(), kNames.end());
    const render::OffscreenContext context;
    Gallery gallery(std::filesystem::path(data) / "fruit", backend, height);
    const render::Picture sheet = gallery.draw(names);
    if (std::filesystem::path(picture).extension() == ".jpg")
        render::write_jpeg(picture, sheet);
    else
        render::write_png(picture, sheet);
    return 0;
}

}  // namespace
}  // namespace kerf::app

int main(int argc, char** argv)
{
    try {
        return kerf::app::run(argc, argv);
    } catch (const std::exception& error) {
        std::cerr << "fruit_gallery: " << error.what() << "\n";
        return 1;
    }
}
