#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>
#include <string_view>

#include "viewer/game/fruit.h"
#include "viewer/sim/body.h"

namespace kerf::game {

/// What happened in a game.
enum class GameEventKind : std::uint8_t
{
    wave,             ///< `count`: its number
    thrown,           ///< a fruit, special or bomb starts below the stage or beside it
    fruit_cut,        ///< `points`; comes before the critical or the special that it brings
    critical,         ///< `points` on top
    combo,            ///< the swipe's end is known: `count` fruit, `points` on top
    missed,           ///< a whole fruit is gone
    life_lost,        ///< `count`: lives that are left
    extra_life,       ///< `count`: lives now
    bomb,             ///< a bomb was cut; `points` is negative where it costs some
    special_started,  ///< or started again
    special_ended,
    game_over,  ///< `points`: the score
};
std::string_view name_of(GameEventKind kind);

/// Events come in order; they follow from seed and input and are part of a run's report. Effects, pop-ups and sounds
/// are made of them and of the cut log.
struct GameEvent
{
    sim::Tick tick = 0;
    GameEventKind kind = GameEventKind::wave;
    glm::dvec2 place{0.0};  ///< on the stage as the eye sees it, metres; of a combo: the middle of its cuts
    std::int64_t points = 0;
    int count = 0;
    std::optional<FruitKind> fruit;
    sim::ObjectId object = 0;  ///< 0: it is not about an object
    std::uint64_t cut = 0;     ///< number of the CutRecord; 0: none
};

}  // namespace kerf::game
