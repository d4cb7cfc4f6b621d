#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <string_view>

#include "maker/poly_mesh.h"

namespace kerf::maker {

PolyMesh make_watermelon();
PolyMesh make_apple();
PolyMesh make_orange();
PolyMesh make_lemon();
PolyMesh make_kiwi();
PolyMesh make_banana();
PolyMesh make_coconut();
PolyMesh make_pineapple();
PolyMesh make_bomb();
PolyMesh make_freeze();
PolyMesh make_frenzy();
PolyMesh make_double();
PolyMesh make_hammer();
PolyMesh make_frozen();

/// Something that the game throws. Units are metres on the game's stage; y is the axis that the fruit hung from.
struct Fruit
{
    std::string_view name;  ///< of the file
    PolyMesh (*make)();
    int shells;  ///< 2: hollow
};

inline constexpr std::array<Fruit, 14> kFruit{{
    {"watermelon", make_watermelon, 1},
    {"apple", make_apple, 1},
    {"orange", make_orange, 1},
    {"lemon", make_lemon, 1},
    {"kiwi", make_kiwi, 1},
    {"banana", make_banana, 1},
    {"coconut", make_coconut, 2},
    {"pineapple", make_pineapple, 1},
    {"bomb", make_bomb, 1},
    {"freeze", make_freeze, 1},
    {"frenzy", make_frenzy, 1},
    {"double", make_double, 1},
    {"hammer", make_hammer, 1},
    {"frozen", make_frozen, 1},
}};

/// A material of the fruit, for programs that do not know what its name stands for.
struct FruitMaterial
{
    std::string_view name;
    glm::vec3 colour;  ///< linear
};

inline constexpr std::array<FruitMaterial, 20> kFruitMaterials{{
    {"watermelon", {0.05f, 0.20f, 0.05f}}, {"apple", {0.55f, 0.03f, 0.03f}},
    {"orange", {0.90f, 0.26f, 0.02f}},     {"lemon", {0.90f, 0.68f, 0.06f}},
    {"kiwi", {0.20f, 0.11f, 0.04f}},       {"banana", {0.85f, 0.60f, 0.07f}},
    {"coconut", {0.13f, 0.06f, 0.03f}},    {"coconut hollow", {0.85f, 0.83f, 0.78f}},
    {"pineapple", {0.52f, 0.28f, 0.04f}},  {"pineapple crown", {0.09f, 0.22f, 0.07f}},
    {"stalk", {0.14f, 0.08f, 0.03f}},      {"leaf", {0.07f, 0.25f, 0.03f}},
    {"bomb", {0.012f, 0.012f, 0.015f}},    {"bomb fuse", {0.36f, 0.26f, 0.14f}},
    {"bomb brass", {0.55f, 0.32f, 0.08f}}, {"freeze", {0.30f, 0.62f, 0.90f}},
    {"frenzy", {0.90f, 0.14f, 0.02f}},     {"double", {0.95f, 0.55f, 0.05f}},
    {"hammer", {0.24f, 0.52f, 0.12f}},     {"frozen", {0.55f, 0.76f, 0.90f}},
}};

}  // namespace kerf::maker
