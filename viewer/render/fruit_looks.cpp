#include "viewer/render/fruit_looks.h"

#include <algorithm>
#include <array>

namespace kerf::render {

namespace {

/// Most of a fruit's colours are in its shader. The first here is what the Lambert shader draws; shaders that several
/// fruit share take theirs from here.
SurfaceLook look(Pattern pattern, glm::vec3 colour, glm::vec3 second, glm::vec3 third, float cells, float roughness,
                 float reflectance = 0.04f, float fuzz = 0.0f)
{
    return {pattern, colour, second, third, cells, 0.5f, roughness, reflectance, fuzz, 0.0f};
}

}  // namespace

std::span<const NamedLook> fruit_skins()
{
    using enum Pattern;
    static const std::array<NamedLook, 20> kSkins{{
        {"watermelon", look(watermelon_skin, {0.045f, 0.17f, 0.04f}, {}, {}, 1, 0.32f)},
        {"apple", look(apple_skin, {0.52f, 0.022f, 0.025f}, {}, {}, 1, 0.24f, 0.05f)},
        {"orange", look(citrus_skin, {0.88f, 0.21f, 0.006f}, {0.74f, 0.12f, 0.003f}, {0.30f, 0.34f, 0.03f}, 44, 0.38f)},
        {"lemon", look(citrus_skin, {0.90f, 0.64f, 0.028f}, {0.80f, 0.47f, 0.016f}, {0.42f, 0.52f, 0.04f}, 46, 0.36f)},
        {"kiwi", look(kiwi_skin, {0.22f, 0.125f, 0.05f}, {}, {}, 1, 0.85f, 0.03f, 0.6f)},
        {"banana", look(banana_skin, {0.86f, 0.58f, 0.05f}, {}, {}, 1, 0.45f)},
        {"coconut", look(coconut_skin, {0.15f, 0.075f, 0.033f}, {}, {}, 1, 0.9f, 0.03f, 0.5f)},
        {"coconut hollow", look(coconut_flesh, {0.88f, 0.86f, 0.80f}, {}, {}, 1, 0.30f)},
        {"pineapple", look(pineapple_skin, {0.62f, 0.32f, 0.04f}, {}, {}, 1, 0.55f)},
        {"pineapple crown", look(leaf, {0.10f, 0.22f, 0.07f}, {0.22f, 0.36f, 0.14f}, {0.36f, 0.30f, 0.13f}, 1, 0.5f)},
        {"leaf", look(leaf, {0.07f, 0.22f, 0.03f}, {0.16f, 0.36f, 0.06f}, {0.10f, 0.24f, 0.04f}, 1, 0.4f)},
        {"stalk", look(wood, {0.16f, 0.10f, 0.04f}, {0.07f, 0.045f, 0.02f}, {0.05f, 0.03f, 0.012f}, 14, 0.8f)},
        {"bomb", look(bomb_skin, {0.03f, 0.032f, 0.037f}, {}, {}, 1, 0.3f, 0.08f)},
        {"bomb brass", look(brushed, {0.60f, 0.36f, 0.10f}, {0.72f, 0.46f, 0.15f}, {}, 9, 0.35f, 0.7f)},
        {"bomb fuse", look(bomb_skin, {0.36f, 0.25f, 0.13f}, {}, {}, 1, 0.9f, 0.03f)},
        {"freeze", look(freeze_skin, {0.42f, 0.70f, 0.92f}, {}, {}, 1, 0.16f, 0.05f)},
        {"frenzy", look(frenzy_skin, {0.80f, 0.16f, 0.02f}, {}, {}, 1, 0.38f)},
        {"double", look(double_skin, {0.98f, 0.62f, 0.12f}, {}, {}, 1, 0.22f, 0.8f)},
        {"hammer", look(hammer_skin, {0.30f, 0.42f, 0.30f}, {}, {}, 1, 0.4f)},
        {"frozen", look(frozen_skin, {0.55f, 0.76f, 0.90f}, {}, {}, 1, 0.1f)},
    }};
    return kSkins;
}

std::span<const NamedLook> fruit_flesh()
{
    using enum Pattern;
    static const std::array<NamedLook, 14> kFlesh{{
        {"watermelon", look(watermelon_flesh, {0.78f, 0.05f, 0.045f}, {}, {}, 1, 0.45f)},
        {"apple", look(apple_flesh, {0.90f, 0.80f, 0.50f}, {}, {}, 1, 0.5f)},
        {"orange",
         look(citrus_flesh, {0.84f, 0.17f, 0.003f}, {0.92f, 0.29f, 0.012f}, {0.78f, 0.55f, 0.26f}, 10, 0.35f)},
        {"lemon", look(citrus_flesh, {0.72f, 0.53f, 0.02f}, {0.80f, 0.66f, 0.09f}, {0.74f, 0.68f, 0.36f}, 8, 0.35f)},
        {"kiwi", look(kiwi_flesh, {0.28f, 0.50f, 0.05f}, {}, {}, 1, 0.4f)},
        {"banana", look(banana_flesh, {0.92f, 0.82f, 0.52f}, {0.86f, 0.66f, 0.08f}, {0.95f, 0.90f, 0.70f}, 1, 0.55f)},
        {"coconut", look(coconut_flesh, {0.88f, 0.86f, 0.80f}, {}, {}, 1, 0.5f)},
        {"pineapple", look(pineapple_flesh, {0.92f, 0.66f, 0.10f}, {}, {}, 1, 0.4f)},
        {"bomb", look(bomb_powder, {0.30f, 0.29f, 0.28f}, {}, {}, 1, 0.7f)},
        {"freeze", look(magic_flesh, {0.52f, 0.80f, 0.95f}, {0.24f, 0.55f, 0.88f}, {0.02f, 0.10f, 0.20f}, 1, 0.3f)},
        {"frenzy", look(magic_flesh, {0.95f, 0.50f, 0.10f}, {0.85f, 0.14f, 0.02f}, {0.55f, 0.10f, 0.01f}, 1, 0.45f)},
        {"double", look(magic_flesh, {0.60f, 0.30f, 0.88f}, {0.95f, 0.58f, 0.08f}, {0.12f, 0.02f, 0.25f}, 1, 0.4f)},
        {"hammer", look(hammer_flesh, {0.62f, 0.86f, 0.36f}, {0.10f, 0.48f, 0.10f}, {0.02f, 0.16f, 0.04f}, 1, 0.45f)},
        {"frozen", look(frozen_flesh, {0.62f, 0.80f, 0.90f}, {}, {}, 1, 0.4f)},
    }};
    return kFlesh;
}

std::span<const std::string_view> fruit_shaders_of(Pattern pattern)
{
    using Files = std::array<std::string_view, 5>;
    static constexpr auto kFirst = static_cast<std::size_t>(Pattern::watermelon_skin);
    static constexpr std::array<Files, kPatterns - kFirst> kFiles{{
        {"fruit.glsl", "fruit_watermelon_skin.glsl", "fruit_describe.glsl"},
        {"fruit.glsl", "fruit_watermelon_flesh.glsl", "fruit_describe.glsl"},
        {"fruit.glsl", "fruit_apple_skin.glsl", "fruit_describe.glsl"},
        {"fruit.glsl", "fruit_apple_flesh.glsl", "fruit_describe.glsl"},
        {"fruit.glsl", "fruit_citrus_skin.glsl", "fruit_describe.glsl"},
        {"fruit.glsl", "fruit_citrus_flesh.glsl", "fruit_describe.glsl"},
        {"fruit.glsl", "fruit_kiwi_skin.glsl", "fruit_describe.glsl"},
        {"fruit.glsl", "fruit_kiwi_flesh.glsl", "fruit_describe.glsl"},
        {"fruit.glsl", "fruit_banana.glsl", "fruit_banana_skin.glsl", "fruit_describe.glsl"},
        {"fruit.glsl", "fruit_banana.glsl", "fruit_banana_flesh.glsl", "fruit_describe.glsl"},
        {"fruit.glsl", "fruit_coconut_skin.glsl", "fruit_describe.glsl"},
        {"fruit.glsl", "fruit_coconut_flesh.glsl", "fruit_describe.glsl"},
        {"fruit.glsl", "fruit_pineapple_skin.glsl", "fruit_describe.glsl"},
        {"fruit.glsl", "fruit_pineapple_flesh.glsl", "fruit_describe.glsl"},
        {"fruit.glsl", "fruit_leaf.glsl", "fruit_describe.glsl"},
        {"fruit.glsl", "fruit_bomb_skin.glsl", "fruit_describe.glsl"},
        {"fruit.glsl", "fruit_bomb_powder.glsl", "fruit_describe.glsl"},
        {"fruit.glsl", "fruit_banana.glsl", "fruit_freeze_skin.glsl", "fruit_describe.glsl"},
        {"fruit.glsl", "fruit_banana.glsl", "fruit_frenzy_skin.glsl", "fruit_describe.glsl"},
        {"fruit.glsl", "fruit_banana.glsl", "fruit_double_skin.glsl", "fruit_describe.glsl"},
        {"fruit.glsl", "fruit_banana.glsl", "fruit_magic_flesh.glsl", "fruit_describe.glsl"},
        {"fruit.glsl", "fruit_banana.glsl", "fruit_hammer.glsl", "fruit_hammer_skin.glsl", "fruit_describe.glsl"},
        {"fruit.glsl", "fruit_banana.glsl", "fruit_hammer.glsl", "fruit_hammer_flesh.glsl", "fruit_describe.glsl"},
        {"fruit.glsl", "fruit_frozen.glsl", "fruit_frozen_skin.glsl", "fruit_describe.glsl"},
        {"fruit.glsl", "fruit_frozen.glsl", "fruit_frozen_flesh.glsl", "fruit_describe.glsl"},
    }};
    const auto index = static_cast<std::size_t>(pattern);
    if (index < kFirst || index >= kPatterns) return {};
    const Files& files = kFiles[index - kFirst];
    const auto end = std::find(files.begin(), files.end(), "");
    return std::span(files).first(static_cast<std::size_t>(end - files.begin()));
}

}  // namespace kerf::render
