#include "viewer/game/game_report.h"

namespace kerf::game {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const GameEvent& event)
{
    Json json{{"tick", event.tick}, {"event", name_of(event.kind)}};
    if (event.fruit) json["fruit"] = fruit_of(*event.fruit).name;
    if (event.object != 0) json["object"] = event.object;
    if (event.cut != 0) json["cut"] = event.cut;
    if (event.points != 0) json["points"] = event.points;
    if (event.count != 0) json["count"] = event.count;
    json["x"] = event.place.x;
    json["y"] = event.place.y;
    return json;
}

}  // namespace

std::string_view name_of(GamePhase phase)
{
    return phase == GamePhase::playing ? "playing" : "over";
}

std::string_view name_of(GameEnd end)
{
    switch (end) {
        case GameEnd::none:
            return "none";
        case GameEnd::missed:
            return "missed";
        case GameEnd::bomb:
            return "bomb";
        case GameEnd::time:
            return "time";
        case GameEnd::given_up:
            return "given_up";
    }
    return "none";
}

nlohmann::ordered_json report_of(const GameScene& game)
{
    const GameState& state = game.state();
    Json events = Json::array();
    for (const GameEvent& event : game.events()) events.push_back(json_of(event));
    Json report{{"mode", name_of(state.mode)},
                {"phase", name_of(state.phase)},
                {"end", name_of(state.end)},
                {"score", state.score},
                {"wave", state.wave}};
    if (state.lives_at_start > 0) report["lives"] = state.lives;
    if (state.seconds_left) report["seconds_left"] = *state.seconds_left;
    report["fruit_cut"] = state.counts.fruit_cut;
    report["fruit_missed"] = state.counts.fruit_missed;
    report["criticals"] = state.counts.criticals;
    report["combos"] = state.counts.combos;
    report["longest_combo"] = state.counts.longest_combo;
    report["bombs_cut"] = state.counts.bombs_cut;
    report["events"] = std::move(events);
    return report;
}

}  // namespace kerf::game
