#pragma once

#include <kerf/mesh.h>

#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "viewer/render/gl_objects.h"
#include "viewer/render/image_table.h"

namespace kerf::render {

/// How a surface gets its colour from the place in the object: describe() in the files that shaders_of() names.
enum class Pattern : std::uint8_t
{
    plain = 0,
    coat = 1,     ///< paint, lacquer, ivory: hardly alive
    wood = 2,     ///< rings around y, fibres along it
    stone = 3,    ///< grains of three minerals
    brushed = 4,  ///< metal brushed around y
    fur = 5,      ///< streaks and tufts
    foam = 6,     ///< crumbs and bubbles
    image = 7,    ///< a picture at the surface's uv
    rock_skin,    ///< of an asteroid: craters, dust, veins
    rock_core,    ///< its inside: crust, strata, crystals, a hot heart
    // Fruit: each has shaders of its own, which know the mesh of data/fruit that they are for.
    watermelon_skin,
    watermelon_flesh,
    apple_skin,
    apple_flesh,
    citrus_skin,
    citrus_flesh,
    kiwi_skin,
    kiwi_flesh,
    banana_skin,
    banana_flesh,
    coconut_skin,
    coconut_flesh,
    pineapple_skin,
    pineapple_flesh,
    leaf,
    bomb_skin,
    bomb_powder,
    freeze_skin,
    frenzy_skin,
    double_skin,
    magic_flesh,
    hammer_skin,
    hammer_flesh,
    frozen_skin,
    frozen_flesh,
};
inline constexpr std::size_t kPatterns = static_cast<std::size_t>(Pattern::frozen_flesh) + 1;

/// The shader files that draw a pattern. Patterns with the same files share a program.
std::span<const std::string_view> shaders_of(Pattern pattern);

/// What the textured shader draws a material with. Colours are linear.
struct SurfaceLook
{
    Pattern pattern = Pattern::plain;
    glm::vec3 colour{0.6f};  ///< the only one that the Lambert shader uses
    glm::vec3 second{0.6f};
    glm::vec3 third{0.6f};
    float cells = 8.0f;         ///< of the pattern, over the object's size
    float contrast = 0.5f;      ///< between the colours
    float roughness = 0.5f;     ///< 0: mirror, 1: chalk
    float reflectance = 0.04f;  ///< seen straight on; above 0.5 it is a metal
    float fuzz = 0.0f;          ///< shine of hair and cloth
    float bumps = 0.0f;         ///< depth of the pattern's relief, in sizes of the object
    std::uint32_t image = 0;    ///< of an ImageTable, for Pattern::image, which `colour` tints

    friend bool operator==(const SurfaceLook&, const SurfaceLook&) = default;
};

/// The look of one of an object's materials. Names that the viewer knows have looks of their own; others are plain in
/// their colour. What a cut uncovers - a cap whose material is one that kerf::cut() added - looks like the
/// inside of the object's surface materials: wood under paint, stuffing under fur.
SurfaceLook look_of(std::span<const Material> materials, std::uint32_t material, TriangleKind kind);

/// The looks in use, in a uniform buffer that all programs read.
class LookTable
{
public:
    /// As many as the shaders have room for: the uniform block stays below the 16 KiB that every driver offers.
    static constexpr std::uint32_t kMostLooks = 128;

    LookTable();

    /// The index of look_of(...) in the table, which gets it if it is new. A full table gives 0, a neutral grey. A
    /// surface whose material names an image looks like the image, if that can be read: its name is a path here.
    std::uint32_t index_of(std::span<const Material> materials, std::uint32_t material, TriangleKind kind);

    const SurfaceLook& look(std::uint32_t index) const { return looks_[index]; }

    const ImageTable& images() const { return images_; }
    /// Of images that can't be used, one sentence each. Cleared by reading.
    std::vector<std::string> take_messages() { return images_.take_messages(); }

    /// Makes the table what the programs' uniform block "Looks" reads.
    void bind() const;

private:
    std::vector<SurfaceLook> looks_;
    ImageTable images_;
    GlBuffer buffer_;
};

}  // namespace kerf::render
