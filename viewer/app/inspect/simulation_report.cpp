#include "viewer/app/inspect/simulation_report.h"

#include "viewer/app/hexadecimal.h"
#include "viewer/game/game_report.h"
#include "viewer/game/giant_scene.h"
#include "viewer/sim/body_proxies.h"

namespace kerf::app {

namespace {

using Json = nlohmann::ordered_json;

Json json_of(const TimeSummary& s)
{
    return {{"count", s.count}, {"min", s.least}, {"median", s.median},
            {"mean", s.mean},   {"p99", s.p99},   {"max", s.most}};
}

Json json_of(const sim::PieceRecord& piece)
{
    return {{"id", piece.id},
            {"side", piece.positive ? "positive" : "negative"},
            {"mass_kg", piece.mass},
            {"triangles", piece.triangles},
            {"surface_hash", hexadecimal(piece.surface_hash)}};
}

Json json_of(const sim::CutRecord& cut, const CutUpload& upload, const sim::ModelLibrary& models)
{
    Json pieces = Json::array(), phases = Json::object();
    for (const sim::PieceRecord& piece : cut.pieces) pieces.push_back(json_of(piece));
    for (std::size_t i = 0; i < kPhaseCount; ++i)
        if (cut.statistics.phase_ms[i] > 0.0) phases[text(static_cast<Phase>(i))] = cut.statistics.phase_ms[i];
    return {{"number", cut.number},
            {"frame", cut.frame()},
            {"object", cut.object},
            {"model", models.model(cut.model).name},
            {"backend", cut.backend},
            {"status", outcome_name(cut.status)},
            {"triangles", cut.statistics.triangles},
            {"crossing", cut.statistics.crossing_surface},
            {"crossing_with_caps", cut.statistics.crossing_triangles},
            {"loops", cut.statistics.section_loops},
            {"surface_hash", hexadecimal(cut.surface_hash)},
            {"contact_before", cut.contact_before},
            {"section_area", cut.section_area},
            {"closed_rightly", cut.closed_rightly},
            {"origin_closed_rightly", cut.origin_closed_rightly},
            {"pieces", std::move(pieces)},
            {"bytes_to_upload", cut.statistics.bytes_to_upload},
            {"bytes_uploaded", upload.bytes},
            {"cut_ms", cut.cut_ms},
            {"phases_ms", std::move(phases)},
            {"proxy_ms", cut.proxy_ms},
            {"bodies_ms", cut.bodies_ms},
            {"upload_cpu_ms", upload.cpu_ms},
            {"cut_to_upload_cpu_ms", cut_to_upload_ms(cut, upload)}};
}

Json json_of(const sim::BreakRecord& broken, const sim::ModelLibrary& models)
{
    return {{"number", broken.number},
            {"frame", broken.tick / sim::kTicksPerFrame},
            {"struck_frame", broken.struck / sim::kTicksPerFrame},
            {"object", broken.object},
            {"model", models.model(broken.model).name},
            {"backend", broken.backend},
            {"status", text(broken.status)},
            {"triangles", broken.triangles},
            {"pieces", broken.pieces.size()},
            {"dropped", broken.dropped},
            {"bonds", broken.bonds},
            {"fracture_ms", broken.fracture_ms},
            {"proxy_ms", broken.proxy_ms},
            {"break_cpu_ms", broken.cpu_ms}};
}

Json json_of(const sim::CrackRecord& crack, const sim::ModelLibrary& models)
{
    return {{"frame", crack.tick / sim::kTicksPerFrame},
            {"model", models.model(crack.model).name},
            {"impulse_ns", crack.impulse},
            {"bonds_broken", crack.bonds},
            {"parts", crack.parts}};
}

}  // namespace

double cut_to_upload_ms(const sim::CutRecord& cut, const CutUpload& upload)
{
    return cut.cpu_ms + upload.cpu_ms;
}

nlohmann::ordered_json report_of(const sim::Simulation& simulation, const GpuWorld& world, const FrameTimes& times)
{
    Json cuts = Json::array();
    std::vector<double> to_upload;
    for (std::size_t i = 0; i < simulation.cuts().size(); ++i) {
        const sim::CutRecord& cut = simulation.cuts()[i];
        const CutUpload& upload = world.cut_uploads()[i];
        cuts.push_back(json_of(cut, upload, simulation.models()));
        if (!cut.pieces.empty()) to_upload.push_back(cut_to_upload_ms(cut, upload));
    }
    Json report{{"scene", simulation.scene().name()},
                {"backend", simulation.backend()},
                {"proxy", sim::proxy_name(simulation.proxy())},
                {"seed", simulation.settings().seed},
                {"ticks", simulation.now()},
                {"bodies", simulation.bodies().size()},
                {"state_hash", hexadecimal(simulation.state_hash())},
                {"cut_to_upload_cpu_ms", json_of(summary_of(std::move(to_upload)))},
                {"simulate_cpu_ms", json_of(summary_of(times.simulate_cpu_ms))},
                {"submit_cpu_ms", json_of(summary_of(times.submit_cpu_ms))},
                {"frame_ms", json_of(summary_of(times.frame_ms))},
                {"bytes_uploaded", world.store().bytes_uploaded()},
                {"bytes_of_throws", world.bytes_of_throws()},
                {"most_bytes_of_throws_in_a_frame", world.most_bytes_of_throws()},
                {"late_preparations", simulation.models().late_work().preparations},
                {"late_copies", simulation.models().late_work().copies},
                {"bytes_on_card", world.store().bytes_held()},
                {"cuts", std::move(cuts)}};
    if (!simulation.breaks().empty()) {
        Json breaks = Json::array(), cracks = Json::array();
        for (const sim::BreakRecord& broken : simulation.breaks()) {
            breaks.push_back(json_of(broken, simulation.models()));
            // Of the frame that put the pieces into the world and drew them, if each frame was drawn.
            const auto frame = static_cast<std::size_t>((broken.tick - 1) / sim::kTicksPerFrame);
            if (times.submit_cpu_ms.size() == times.simulate_cpu_ms.size() && frame < times.submit_cpu_ms.size())
                breaks.back()["frame_cpu_ms"] = times.simulate_cpu_ms[frame] + times.submit_cpu_ms[frame];
        }
        for (const sim::CrackRecord& crack : simulation.cracks()) cracks.push_back(json_of(crack, simulation.models()));
        report["breaks"] = std::move(breaks);
        report["cracks"] = std::move(cracks);
    }
    if (!times.submit_cpu_ms.empty() && times.submit_cpu_ms.size() == times.simulate_cpu_ms.size()) {
        // Each frame was drawn: what both cost it together.
        std::vector<double> both;
        for (std::size_t i = 0; i < times.submit_cpu_ms.size(); ++i)
            both.push_back(times.simulate_cpu_ms[i] + times.submit_cpu_ms[i]);
        report["frame_cpu_ms"] = json_of(summary_of(std::move(both)));
    }
    if (const game::GameScene* const game = game::game_of(simulation.scene())) report["game"] = game::report_of(*game);
    if (const game::GiantScene* const giant = game::giant_of(simulation.scene()))
        report["giant"] = {{"triangles", giant->state().triangles}, {"giants", giant->state().giants}};
    return report;
}

}  // namespace kerf::app
