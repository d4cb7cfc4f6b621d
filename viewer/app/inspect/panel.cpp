#include "viewer/app/inspect/panel.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cstdio>

#include "viewer/app/inspect/keys.h"
#include "viewer/app/inspect/simulation_report.h"
#include "viewer/app/panel_parts.h"
#include "viewer/game/shatter_scene.h"
#include "viewer/render/offscreen_context.h"
#include "viewer/sim/back_ends.h"
#include "viewer/sim/body_proxies.h"

namespace kerf::app {

namespace {

constexpr int kCutsShown = 5;
constexpr double kShownShare = 0.01;  // of a cut's time: shorter phases are left out

/// 12345678 -> "11.8 MB".
std::string bytes_text(std::uint64_t bytes)
{
    std::array<char, 32> text{};
    if (bytes < 10'000)
        std::snprintf(text.data(), text.size(), "%llu B", static_cast<unsigned long long>(bytes));
    else if (bytes < 10'000'000)
        std::snprintf(text.data(), text.size(), "%.1f kB", 1e-3 * double(bytes));
    else
        std::snprintf(text.data(), text.size(), "%.1f MB", 1e-6 * double(bytes));
    return text.data();
}

void heading(const char* text)
{
    ImGui::Spacing();
    ImGui::TextColored(kAccent, "%s", text);
    ImGui::Separator();
}

void show_frames(PanelState& state)
{
    FrameStatistics& frames = state.frames;
    const double mean = frames.mean();
    ImGui::Text("%.1f ms", frames.last());
    ImGui::SameLine();
    const bool in_software = render::draws_in_software();
    ImGui::TextDisabled("%.0f frames/s%s", mean > 0.0 ? 1000.0 / mean : 0.0, in_software ? ", software renderer" : "");
    // Beside those words there is no room.
    if (!in_software) ImGui::SameLine();
    ImGui::TextDisabled("%smin %.1f   max %.1f", in_software ? "" : "   ", frames.least(), frames.most());
    const float top = std::max(20.0f, static_cast<float>(1.15 * frames.most()));
    ImGui::PlotLines("##frames", frames.values(), static_cast<int>(frames.size()),
                     frames.size() == FrameStatistics::kShown ? static_cast<int>(frames.offset()) : 0, nullptr, 0.0f,
                     top, ImVec2(ImGui::GetContentRegionAvail().x, 2.6f * ImGui::GetTextLineHeight()));
    ImGui::Text("worst since reset  %.1f ms", frames.worst_since_reset());
    ImGui::SameLine();
    if (ImGui::SmallButton("reset")) frames.reset_worst();
    ImGui::TextDisabled("simulation %.2f ms   %zu pieces   %llu draws of %llu ranges", state.simulation_ms,
                        state.simulation.bodies().size(),
                        static_cast<unsigned long long>(state.painter.statistics().calls),
                        static_cast<unsigned long long>(state.painter.statistics().ranges));
    ImGui::TextDisabled("on the card %s", bytes_text(state.painter.world().store().bytes_held()).c_str());
}

void show_choices(PanelState& state)
{
    const float wide = 11.5f * ImGui::GetFontSize();
    ImGui::SetNextItemWidth(wide);
    const std::string backend = state.simulation.backend_to_come();
    if (ImGui::BeginCombo("back end", backend.c_str())) {
        for (const std::string& name : sim::backend_names())
            if (ImGui::Selectable(name.c_str(), name == backend)) state.commands.push_back("backend " + name);
        ImGui::EndCombo();
    }
    ImGui::SetNextItemWidth(wide);
    const sim::ProxyKind proxy = state.simulation.proxy_to_come();
    const std::string shown(sim::proxy_name(proxy));
    if (ImGui::BeginCombo("proxy", shown.c_str())) {
        for (const sim::ProxyKind kind : sim::kProxyKinds) {
            const std::string name(sim::proxy_name(kind));
            if (ImGui::Selectable(name.c_str(), kind == proxy)) state.commands.push_back("proxy " + name);
        }
        ImGui::EndCombo();
    }
    bool textured = state.view.lighting == render::Lighting::textured;
    if (ImGui::Checkbox("textured", &textured))
        state.view.lighting = textured ? render::Lighting::textured : render::Lighting::lambert;
    ImGui::SameLine();
    ImGui::Checkbox("edges", &state.view.wireframe);
    ImGui::SameLine();
    ImGui::Checkbox("proxies", &state.view.proxies);
}

void show_phases(const sim::CutRecord& cut)
{
    const double total = std::max(cut.statistics.milliseconds(), 1e-6);
    const ImVec2 bar(9.0f * ImGui::GetFontSize(), 0.0f);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(8.0f, 3.0f));
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(8.0f, 0.0f));
    for (std::size_t i = 0; i < kPhaseCount; ++i) {
        const double ms = cut.statistics.phase_ms[i];
        if (ms < kShownShare * total) continue;
        std::array<char, 48> label{};
        std::snprintf(label.data(), label.size(), "%.3f ms", ms);
        ImGui::ProgressBar(static_cast<float>(ms / total), bar, label.data());
        ImGui::SameLine();
        ImGui::TextUnformatted(text(static_cast<Phase>(i)));
    }
    ImGui::PopStyleVar(2);
}

void show_cut(const sim::CutRecord& cut, const CutUpload& upload, const sim::ModelLibrary& models)
{
    ImGui::Text("%s", models.model(cut.model).name.c_str());
    ImGui::SameLine();
    ImGui::TextDisabled("%s, %s", cut.backend.c_str(), outcome_name(cut.status));
    const CutStatistics& s = cut.statistics;
    ImGui::Text("%llu triangles, %llu crossing, %llu %s", static_cast<unsigned long long>(s.triangles),
                static_cast<unsigned long long>(s.crossing_surface), static_cast<unsigned long long>(s.section_loops),
                s.section_loops == 1 ? "loop" : "loops");
    show_phases(cut);
    ImGui::Text("cut %.3f ms   proxies %.3f ms", cut.cut_ms, cut.proxy_ms);
    ImGui::Text("uploaded %s   swipe to upload %.3f ms", bytes_text(upload.bytes).c_str(),
                cut_to_upload_ms(cut, upload));
}

void show_table(const sim::Simulation& simulation, const GpuWorld& world)
{
    const auto& cuts = simulation.cuts();
    const auto& uploads = world.cut_uploads();
    constexpr ImGuiTableFlags kFlags = ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingFixedFit;
    if (!ImGui::BeginTable("cuts", 6, kFlags)) return;
    for (const char* title : {"model", "triangles", "k", "cut ms", "proxy ms", "upload"})
        ImGui::TableSetupColumn(title);
    ImGui::TableHeadersRow();
    int shown = 0;
    for (std::size_t i = std::min(cuts.size(), uploads.size()); i-- > 0 && shown < kCutsShown; ++shown) {
        const sim::CutRecord& cut = cuts[i];
        ImGui::TableNextRow();
        const auto cell = [](const std::string& text) {
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(text.c_str());
        };
        const auto number = [](double value) {
            std::array<char, 32> text{};
            std::snprintf(text.data(), text.size(), "%.3f", value);
            return std::string(text.data());
        };
        cell(simulation.models().model(cut.model).name);
        cell(std::to_string(cut.statistics.triangles));
        cell(std::to_string(cut.statistics.crossing_surface));
        cell(number(cut.cut_ms));
        cell(number(cut.proxy_ms));
        cell(bytes_text(uploads[i].bytes));
    }
    ImGui::EndTable();
}

/// How things break from now on, in a scene where they do.
void show_breaking(PanelState& state, const game::ShatterSettings& settings)
{
    const float wide = 11.5f * ImGui::GetFontSize();
    int cells = static_cast<int>(settings.cells);
    ImGui::SetNextItemWidth(wide);
    if (ImGui::SliderInt("cells", &cells, game::ShatterSettings::kFewestCells, game::ShatterSettings::kMostCells))
        state.commands.push_back("cells " + std::to_string(cells));
    ImGui::SetNextItemWidth(wide);
    const std::string shown(game::kPatternNames[static_cast<std::size_t>(settings.pattern)]);
    if (ImGui::BeginCombo("pattern", shown.c_str())) {
        for (const std::string_view name : game::kPatternNames)
            if (ImGui::Selectable(std::string(name).c_str(), name == shown))
                state.commands.push_back("pattern " + std::string(name));
        ImGui::EndCombo();
    }
    auto strength = static_cast<float>(settings.strength);
    ImGui::SetNextItemWidth(wide);
    if (ImGui::SliderFloat("strength", &strength, 0.0f, float(game::ShatterSettings::kMostStrength), "%.0f N s/m2",
                           ImGuiSliderFlags_Logarithmic))
        state.commands.push_back("strength " + std::to_string(strength));
}

/// What the last object cost that was taken apart.
void show_break(const sim::Simulation& simulation)
{
    const sim::BreakRecord& broken = simulation.breaks().back();
    ImGui::Text("%s", simulation.models().model(broken.model).name.c_str());
    ImGui::SameLine();
    ImGui::TextDisabled("%s, %s", broken.backend.c_str(), text(broken.status));
    if (broken.pieces.empty()) return;
    const auto pieces = double(broken.pieces.size() + broken.dropped);
    ImGui::Text("%llu triangles, %.0f pieces, %zu bonds", static_cast<unsigned long long>(broken.triangles), pieces,
                broken.bonds);
    ImGui::Text("fracture %.1f ms   proxies %.2f ms, on a thread", broken.fracture_ms, broken.proxy_ms);
    ImGui::Text("%.3f ms a piece   bodies %.2f ms", (broken.fracture_ms + broken.proxy_ms) / pieces, broken.cpu_ms);
    std::size_t bound = 0;
    for (const auto& cluster : simulation.world().clusters()) bound += cluster->bonds().size();
    ImGui::TextDisabled("%zu clusters held by %zu bonds", simulation.world().clusters().size(), bound);
}

void show_main(PanelState& state)
{
    const float margin = ImGui::GetFontSize();
    ImGui::SetNextWindowPos(ImVec2(margin, margin), ImGuiCond_FirstUseEver);
    // As high as what it shows; in a low window it scrolls.
    const float width = 27.0f * ImGui::GetFontSize(), room = ImGui::GetIO().DisplaySize.y - 2.0f * margin;
    ImGui::SetNextWindowSize(ImVec2(width, 0.0f));
    ImGui::SetNextWindowSizeConstraints(ImVec2(width, 0.0f), ImVec2(width, std::max(room, margin)));
    ImGui::Begin("Kerf", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav);
    ImGui::TextColored(kAccent, "Kerf");
    ImGui::SameLine();
    const game::ShatterScene* const shatter = game::shatter_of(state.simulation.scene());
    ImGui::TextDisabled(shatter ? "click to break    H: keys    Tab: hide" : "drag to cut    H: keys    Tab: hide");
    if (state.paused || state.slow_motion) {
        ImGui::SameLine();
        ImGui::TextColored(kAccent, "%s", state.paused ? "  paused" : "  slow motion");
    }
    show_choices(state);
    if (shatter != nullptr) show_breaking(state, shatter->settings());
    heading("Frames");
    show_frames(state);
    if (!state.simulation.breaks().empty()) {
        heading("Last break");
        show_break(state.simulation);
    }
    const auto& cuts = state.simulation.cuts();
    const auto& uploads = state.painter.world().cut_uploads();
    if (!cuts.empty() && uploads.size() == cuts.size()) {
        heading("Last cut");
        show_cut(cuts.back(), uploads.back(), state.simulation.models());
        heading("Cuts");
        show_table(state.simulation, state.painter.world());
    }
    ImGui::End();
}

}  // namespace

void show_panel(PanelState& state)
{
    if (state.view.panel) show_main(state);
    if (state.view.help)
        show_list_of_keys(kKeyBindings, columns_for(kKeyBindings.size()),
                          game::shatter_of(state.simulation.scene()) != nullptr
                              ? "Click with the left mouse button to break."
                              : "Drag with the left mouse button to cut.");
    if (!state.message.empty()) show_message(state.message);
}

}  // namespace kerf::app
