#include "viewer/app/inside/inside_panel.h"

#include <imgui.h>

#include <cstddef>

#include "viewer/app/panel_parts.h"

namespace kerf::app {

namespace {

/// A row of a table of two columns.
template <class... Arguments>
void row(const char* title, const char* format, Arguments... arguments)
{
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextDisabled("%s", title);
    ImGui::TableNextColumn();
    ImGui::Text(format, arguments...);
}

void show_section(const inside::Study& study)
{
    const Section& section = study.section();
    std::size_t holes = 0, chains = 0;
    for (std::size_t i = 0; i < section.path_count(); ++i) {
        const SectionPath path = section.path(i);
        holes += path.is_closed && path.area < 0.0 ? 1 : 0;
        chains += path.is_closed ? 0 : 1;
    }
    row("area", "%.5g", section.area);
    row("length", "%.5g", section.length);
    row("loops", "%zu, %zu of them holes", section.path_count() - chains, holes);
    if (chains > 0) row("chains", "%zu, not closed", chains);
    row("crossing", "%llu triangles", static_cast<unsigned long long>(section.statistics().crossing_triangles));
}

void show_main(const InsidePanel& panel)
{
    const float margin = ImGui::GetFontSize();
    ImGui::SetNextWindowPos(ImVec2(margin, margin));
    ImGui::SetNextWindowBgAlpha(0.8f);
    ImGui::Begin("Section", nullptr, kSaysOnly | ImGuiWindowFlags_NoFocusOnAppearing);
    const inside::Study& study = panel.study;
    ImGui::TextColored(kAccent, "%s", study.name().c_str());
    ImGui::SameLine();
    ImGui::TextDisabled("%llu triangles, %s", static_cast<unsigned long long>(study.object().triangle_count()),
                        study.object().back_end_name());
    ImGui::Separator();
    if (ImGui::BeginTable("facts", 2, ImGuiTableFlags_SizingFixedFit)) {
        show_section(study);
        row("section", "%.3f ms, with nesting and triangles", study.cost().cpu_ms);
        row("upload", "%.3f ms", panel.upload_cpu_ms);
        if (study.shows_contours())
            row("contours", "%zu in %.2f ms", study.contours().size(), study.cost().contours_cpu_ms);
        ImGui::EndTable();
    }
    ImGui::Separator();
    ImGui::TextDisabled("drag: move   right drag: turn   C: contours   H: keys");
    ImGui::End();
}

}  // namespace

void show_inside_panel(const InsidePanel& panel, const ViewSettings& view)
{
    if (view.panel) show_main(panel);
    if (view.help)
        show_list_of_keys(kInsideKeys, columns_for(kInsideKeys.size()),
                          "Nothing is cut: the section is asked for anew.");
    if (!panel.message.empty()) show_message(panel.message);
}

}  // namespace kerf::app
