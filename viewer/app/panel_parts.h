#pragma once

#include <imgui.h>

#include <string>

// What the panels over pictures have in common.

namespace kerf::app {

inline const ImVec4 kAccent(0.98f, 0.70f, 0.40f, 1.0f);

/// Of a window that only says something.
inline constexpr ImGuiWindowFlags kSaysOnly = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                                              ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoNav |
                                              ImGuiWindowFlags_NoSavedSettings;

/// A line at the lower rim.
inline void show_message(const std::string& message)
{
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos(ImVec2(0.5f * size.x, size.y - ImGui::GetFontSize()), ImGuiCond_Always, ImVec2(0.5f, 1.0f));
    ImGui::Begin("Message", nullptr, kSaysOnly);
    ImGui::TextUnformatted(message.c_str());
    ImGui::End();
}

/// A list of keys, in the middle: what has `key` and `description`, one beside the other in so many columns.
template <class Keys>
void show_list_of_keys(const Keys& keys, int columns, const char* below)
{
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos(ImVec2(0.5f * size.x, 0.5f * size.y), ImGuiCond_Always, ImVec2(0.5f, 0.5f));
    ImGui::SetNextWindowBgAlpha(0.92f);
    ImGui::Begin("Keys", nullptr, kSaysOnly);
    ImGui::TextColored(kAccent, "Keys");
    ImGui::Separator();
    if (ImGui::BeginTable("keys", 2 * columns, ImGuiTableFlags_SizingFixedFit)) {
        for (const auto& key : keys) {
            ImGui::TableNextColumn();
            ImGui::TextColored(kAccent, "%s", key.key);
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(key.description);
        }
        ImGui::EndTable();
    }
    ImGui::Separator();
    ImGui::TextDisabled("%s", below);
    ImGui::End();
}

/// How many columns a list of so many keys needs: two where the window is too low for one.
inline int columns_for(std::size_t keys)
{
    const float line = ImGui::GetTextLineHeight() + 2.0f * ImGui::GetStyle().CellPadding.y;
    return (static_cast<float>(keys) + 4.0f) * line > ImGui::GetIO().DisplaySize.y ? 2 : 1;
}

}  // namespace kerf::app
