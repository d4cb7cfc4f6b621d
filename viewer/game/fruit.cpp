#include "viewer/game/fruit.h"

namespace kerf::game {
namespace {

using enum FruitKind;

/// Small fruit is harder to hit and worth more. Juice is what one expects of the flesh, darker than the flesh is.
constexpr std::array<Fruit, kFruitKinds> kCatalogue{{
    {watermelon, "watermelon", "watermelon", 1, 1.50, {0.80f, 0.05f, 0.06f}, 10},
    {apple, "apple", "apple", 1, 1.00, {0.85f, 0.78f, 0.42f}, 12},
    {orange, "orange", "orange", 1, 1.00, {0.95f, 0.38f, 0.03f}, 12},
    {lemon, "lemon", "lemon", 2, 0.90, {0.93f, 0.80f, 0.10f}, 8},
    {kiwi, "kiwi", "kiwi", 2, 0.80, {0.36f, 0.62f, 0.06f}, 8},
    {banana, "banana", "banana", 1, 1.25, {0.92f, 0.82f, 0.50f}, 8},
    {coconut, "coconut", "coconut", 1, 1.15, {0.90f, 0.92f, 0.90f}, 8},
    {pineapple, "pineapple", "pineapple", 1, 1.55, {0.95f, 0.68f, 0.08f}, 6},
    {bomb, "bomb", "bomb", 0, 1.10, {1.00f, 0.45f, 0.08f}, 0},
    {freeze, "freeze", "freeze", 1, 1.30, {0.25f, 0.62f, 0.98f}, 0},
    {frenzy, "frenzy", "frenzy", 1, 1.30, {0.98f, 0.22f, 0.10f}, 0},
    {double_points, "double", "double", 1, 1.30, {0.62f, 0.18f, 0.95f}, 0},
    {hammer, "hammer", "hammer", 1, 1.40, {0.20f, 0.82f, 0.30f}, 0},
    {frozen, "frozen", "frozen", 3, 1.15, {0.86f, 0.06f, 0.10f}, 0},
}};

constexpr bool is_in_order()
{
    for (std::size_t i = 0; i < kFruitKinds; ++i)
        if (static_cast<std::size_t>(kCatalogue[i].kind) != i) return false;
    return true;
}
static_assert(is_in_order());

}  // namespace

std::span<const Fruit, kFruitKinds> fruit_catalogue()
{
    return kCatalogue;
}

const Fruit& fruit_of(FruitKind kind)
{
    return kCatalogue[static_cast<std::size_t>(kind)];
}

std::optional<FruitKind> find_fruit(std::string_view name)
{
    for (const Fruit& fruit : kCatalogue)
        if (fruit.name == name) return fruit.kind;
    return std::nullopt;
}

}  // namespace kerf::game
