#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string_view>

namespace kerf::game {

/// Everything that is thrown in a game.
enum class FruitKind : std::uint8_t
{
    watermelon,
    apple,
    orange,
    lemon,
    kiwi,
    banana,
    coconut,
    pineapple,
    bomb,
    freeze,         ///< special fruit of arcade, docs/game.md
    frenzy,         ///< special
    double_points,  ///< special
    hammer,         ///< special
    frozen,         ///< in ice: bursts instead of parting, and begins nothing
};

/// What the game knows about a kind.
struct Fruit
{
    FruitKind kind = FruitKind::apple;
    std::string_view name;   ///< for people and files: "watermelon"
    std::string_view model;  ///< stem of its file in data/fruit, and name on the ModelLibrary
    int points = 0;          ///< for cutting it whole
    double radius = 1.0;     ///< half the diagonal of its box as thrown, metres
    glm::vec3 juice{0.0f};   ///< linear rgb; of a bomb: its sparks
    int weight = 0;          ///< share of ordinary throws; 0: waves have rules of their own for it
};

inline constexpr std::size_t kFruitKinds = 14;

/// All kinds, in the order of FruitKind.
std::span<const Fruit, kFruitKinds> fruit_catalogue();
const Fruit& fruit_of(FruitKind kind);
std::optional<FruitKind> find_fruit(std::string_view name);

/// Whether cutting it begins an effect that lasts.
inline bool is_special(FruitKind kind)
{
    return kind >= FruitKind::freeze && kind <= FruitKind::hammer;
}

}  // namespace kerf::game
