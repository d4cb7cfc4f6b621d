#include "viewer/render/surface_look.h"

#include <algorithm>
#include <array>
#include <glm/gtc/type_ptr.hpp>
#include <utility>

#include "viewer/render/fruit_looks.h"
#include "viewer/render/shader_program.h"

namespace kerf::render {

namespace {

using Named = std::pair<std::string_view, SurfaceLook>;

SurfaceLook look(Pattern pattern, glm::vec3 colour, glm::vec3 second, glm::vec3 third, float cells, float contrast,
                 float roughness, float reflectance, float fuzz, float bumps)
{
    return {pattern, colour, second, third, cells, contrast, roughness, reflectance, fuzz, bumps};
}

/// Outsides by material name.
const std::vector<Named>& surfaces()
{
    using enum Pattern;
    static const std::vector<Named> all{
        {"ivory", look(coat, {0.68f, 0.52f, 0.32f}, {0.55f, 0.37f, 0.20f}, {}, 5, 0.75f, 0.36f, 0.045f, 0.05f, 0)},
        {"paint", look(coat, {0.045f, 0.175f, 0.36f}, {0.032f, 0.13f, 0.30f}, {}, 6, 0.8f, 0.3f, 0.045f, 0, 0.0005f)},
        {"stone", look(stone, {0.52f, 0.50f, 0.46f}, {0.36f, 0.35f, 0.33f}, {0.16f, 0.15f, 0.15f}, 11, 0.75f, 0.8f,
                       0.03f, 0, 0.004f)},
        {"rock", look(rock_skin, {0.235f, 0.195f, 0.160f}, {0.105f, 0.092f, 0.084f}, {0.46f, 0.41f, 0.34f}, 8, 0.8f,
                      0.85f, 0.03f, 0, 0.012f)},
        {"wood", look(wood, {0.40f, 0.20f, 0.075f}, {0.20f, 0.082f, 0.026f}, {0.12f, 0.045f, 0.014f}, 6, 0.8f, 0.5f,
                      0.04f, 0, 0.0015f)},
        {"iron", look(brushed, {0.20f, 0.21f, 0.23f}, {0.36f, 0.37f, 0.39f}, {}, 6, 0.6f, 0.42f, 0.6f, 0, 0.0006f)},
        {"body", look(coat, {0.56f, 0.018f, 0.014f}, {0.50f, 0.014f, 0.012f}, {}, 4, 0.5f, 0.2f, 0.06f, 0, 0)},
        {"glass", look(plain, {0.022f, 0.035f, 0.045f}, {}, {}, 1, 0, 0.08f, 0.08f, 0, 0)},
        {"rubber", look(coat, {0.018f, 0.018f, 0.02f}, {0.03f, 0.03f, 0.032f}, {}, 20, 1, 0.8f, 0.03f, 0.2f, 0)},
        {"chrome", look(plain, {0.66f, 0.68f, 0.70f}, {}, {}, 1, 0, 0.16f, 0.9f, 0, 0)},
        {"fur", look(fur, {0.15f, 0.065f, 0.028f}, {0.34f, 0.16f, 0.07f}, {}, 9, 0.9f, 0.85f, 0.03f, 0.7f, 0.004f)},
        {"skin", look(coat, {0.66f, 0.37f, 0.21f}, {0.56f, 0.27f, 0.14f}, {}, 7, 0.8f, 0.55f, 0.035f, 0.25f, 0.001f)},
    };
    return all;
}

/// Insides by the name of a surface material, the first that an object has.
const std::vector<Named>& insides()
{
    using enum Pattern;
    static const SurfaceLook beech = look(wood, {0.70f, 0.45f, 0.23f}, {0.50f, 0.27f, 0.11f}, {0.40f, 0.20f, 0.08f}, 7,
                                          0.9f, 0.62f, 0.035f, 0, 0.0012f);
    static const SurfaceLook padauk = look(wood, {0.46f, 0.135f, 0.046f}, {0.25f, 0.055f, 0.020f},
                                           {0.20f, 0.03f, 0.012f}, 9, 0.85f, 0.55f, 0.035f, 0, 0.0012f);
    static const SurfaceLook oak = look(wood, {0.55f, 0.33f, 0.15f}, {0.33f, 0.16f, 0.06f}, {0.22f, 0.10f, 0.035f}, 9,
                                        0.9f, 0.62f, 0.035f, 0, 0.0015f);
    static const SurfaceLook granite = look(stone, {0.66f, 0.62f, 0.56f}, {0.48f, 0.42f, 0.37f}, {0.12f, 0.11f, 0.11f},
                                            13, 0.9f, 0.85f, 0.03f, 0, 0.005f);
    static const SurfaceLook core = look(rock_core, {0.150f, 0.118f, 0.098f}, {0.30f, 0.125f, 0.060f},
                                         {0.045f, 0.042f, 0.046f}, 8, 0.8f, 0.7f, 0.03f, 0, 0.004f);
    static const SurfaceLook steel =
        look(brushed, {0.36f, 0.375f, 0.40f}, {0.50f, 0.515f, 0.53f}, {}, 7, 0.8f, 0.34f, 0.7f, 0, 0.0004f);
    static const SurfaceLook stuffing = look(foam, {0.83f, 0.69f, 0.45f}, {0.72f, 0.54f, 0.30f}, {0.52f, 0.36f, 0.18f},
                                             12, 0.8f, 0.9f, 0.03f, 0.3f, 0.006f);
    static const std::vector<Named> all{{"body", steel}, {"fur", stuffing}, {"wood", oak},    {"stone", granite},
                                        {"rock", core},  {"paint", beech},  {"ivory", padauk}};
    return all;
}

template <class NamedLooks>
const SurfaceLook* find(const NamedLooks& looks, std::string_view name)
{
    const auto found = std::find_if(looks.begin(), looks.end(), [&](const auto& n) { return n.first == name; });
    return found == looks.end() ? nullptr : &found->second;
}

bool is_added_cap_material(std::string_view name)
{
    return name == "cap" || name.starts_with("cap.");
}

SurfaceLook plain(const glm::vec3& colour)
{
    SurfaceLook plain_look;
    plain_look.colour = plain_look.second = plain_look.third = colour;
    return plain_look;
}

SurfaceLook look_of_image(const glm::vec4& colour, std::uint32_t image)
{
    // Files that name an image often leave the colour black: nobody means to tint with that.
    const glm::vec3 tint(colour);
    SurfaceLook look = plain(tint == glm::vec3(0.0f) ? glm::vec3(1.0f) : tint);
    look.pattern = Pattern::image;
    look.image = image;
    return look;
}

SurfaceLook inside_of(std::span<const Material> materials)
{
    for (const Material& material : materials)
        if (const SurfaceLook* flesh = find(fruit_flesh(), material.name)) return *flesh;
    for (const auto& [name, inside] : insides())
        if (std::any_of(materials.begin(), materials.end(),
                        [&name = name](const Material& m) { return std::string_view(m.name) == name; }))
            return inside;
    // Nobody knows what is inside: a warm clay that stands out from most colours.
    return look(Pattern::stone, {0.62f, 0.24f, 0.12f}, {0.50f, 0.16f, 0.07f}, {0.36f, 0.10f, 0.05f}, 14, 0.6f, 0.8f,
                0.03f, 0, 0.002f);
}

/// Look in shaders/surface_look.glsl, laid out as std140 wants it.
struct LookBlock
{
    glm::vec4 colour, second, third, finish;
};

LookBlock block_of(const SurfaceLook& l)
{
    return {{l.colour, static_cast<float>(l.pattern)},
            {l.second, l.cells},
            {l.third, l.contrast},
            {l.roughness, l.reflectance, l.fuzz, l.bumps}};
}

constexpr GLsizeiptr kTableSize = LookTable::kMostLooks * sizeof(LookBlock);
static_assert(kTableSize <= 16384);

}  // namespace

SurfaceLook look_of(std::span<const Material> materials, std::uint32_t material, TriangleKind kind)
{
    if (material >= materials.size()) return {};
    const Material& wanted = materials[material];
    if (kind == TriangleKind::cap && is_added_cap_material(wanted.name)) return inside_of(materials);
    if (const SurfaceLook* known = find(surfaces(), wanted.name)) return *known;
    if (const SurfaceLook* known = find(fruit_skins(), wanted.name)) return *known;
    if (const SurfaceLook* known = find(insides(), wanted.name)) return *known;
    return plain(glm::make_vec3(wanted.base_colour));
}

std::span<const std::string_view> shaders_of(Pattern pattern)
{
    static constexpr std::array<std::string_view, 1> kMaterials{"materials.glsl"}, kImage{"image.glsl"},
        kRockSkin{"rock_skin.glsl"}, kRockCore{"rock_core.glsl"};
    if (pattern == Pattern::image) return kImage;
    if (pattern == Pattern::rock_skin) return kRockSkin;
    if (pattern == Pattern::rock_core) return kRockCore;
    const std::span<const std::string_view> own = fruit_shaders_of(pattern);
    return own.empty() ? kMaterials : own;
}

LookTable::LookTable() : looks_{SurfaceLook{}}, buffer_(GlBuffer::create())
{
    glBindBuffer(GL_UNIFORM_BUFFER, buffer_.id());
    glBufferData(GL_UNIFORM_BUFFER, kTableSize, nullptr, GL_STATIC_DRAW);
    const LookBlock first = block_of(looks_.front());
    glBufferSubData(GL_UNIFORM_BUFFER, 0, sizeof(LookBlock), &first);
    glBindBuffer(GL_UNIFORM_BUFFER, 0);
}

std::uint32_t LookTable::index_of(std::span<const Material> materials, std::uint32_t material, TriangleKind kind)
{
    SurfaceLook wanted = look_of(materials, material, kind);
    if (material < materials.size() && kind == TriangleKind::surface && *materials[material].base_colour_image != '\0')
        if (const std::uint32_t image = images_.index_of(materials[material].base_colour_image); image != 0)
            wanted = look_of_image(glm::make_vec4(materials[material].base_colour), image);
    const auto found = std::find(looks_.begin(), looks_.end(), wanted);
    if (found != looks_.end()) return static_cast<std::uint32_t>(found - looks_.begin());
    if (looks_.size() == kMostLooks) return 0;
    looks_.push_back(wanted);
    const LookBlock added = block_of(wanted);
    glBindBuffer(GL_UNIFORM_BUFFER, buffer_.id());
    glBufferSubData(GL_UNIFORM_BUFFER, static_cast<GLintptr>((looks_.size() - 1) * sizeof(LookBlock)),
                    sizeof(LookBlock), &added);
    glBindBuffer(GL_UNIFORM_BUFFER, 0);
    return static_cast<std::uint32_t>(looks_.size() - 1);
}

void LookTable::bind() const
{
    glBindBufferBase(GL_UNIFORM_BUFFER, static_cast<GLuint>(UniformBlock::looks), buffer_.id());
}

}  // namespace kerf::render
