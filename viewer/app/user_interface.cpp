#include "viewer/app/user_interface.h"

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <epoxy/gl.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <system_error>

namespace kerf::app {

namespace {

constexpr float kFontSize = 14.0f;  // pixels at scale 1

/// Debian's place for the font (package fonts-dejavu-core); without it Dear ImGui's own is used, enlarged.
constexpr const char* kFontFile = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";

void load_font(float scale)
{
    ImGuiIO& io = ImGui::GetIO();
    std::error_code ignored;
    if (std::filesystem::is_regular_file(kFontFile, ignored) &&
        io.Fonts->AddFontFromFileTTF(kFontFile, kFontSize * scale) != nullptr)
        return;
    ImFontConfig own;
    own.SizePixels = kFontSize * scale;
    io.Fonts->AddFontDefault(&own);
}

void set_style(float scale)
{
    ImGui::StyleColorsDark();
    ImGuiStyle& style = ImGui::GetStyle();
    style.WindowRounding = 9.0f;
    style.FrameRounding = 5.0f;
    style.GrabRounding = 5.0f;
    style.WindowPadding = {14.0f, 12.0f};
    style.FramePadding = {8.0f, 3.0f};
    style.ItemSpacing = {8.0f, 4.0f};
    style.CellPadding = {6.0f, 2.0f};
    style.WindowBorderSize = 0.0f;
    const auto set = [&](ImGuiCol which, float r, float g, float b, float a) {
        style.Colors[which] = ImVec4(r, g, b, a);
    };
    set(ImGuiCol_WindowBg, 0.055f, 0.066f, 0.070f, 0.84f);
    set(ImGuiCol_Text, 0.93f, 0.92f, 0.89f, 1.0f);
    set(ImGuiCol_TextDisabled, 0.62f, 0.64f, 0.62f, 1.0f);
    set(ImGuiCol_FrameBg, 1.0f, 1.0f, 1.0f, 0.07f);
    set(ImGuiCol_FrameBgHovered, 1.0f, 1.0f, 1.0f, 0.12f);
    set(ImGuiCol_FrameBgActive, 1.0f, 1.0f, 1.0f, 0.18f);
    set(ImGuiCol_Button, 0.80f, 0.40f, 0.16f, 0.55f);
    set(ImGuiCol_ButtonHovered, 0.86f, 0.46f, 0.20f, 0.85f);
    set(ImGuiCol_ButtonActive, 0.92f, 0.52f, 0.24f, 1.0f);
    set(ImGuiCol_Header, 0.80f, 0.40f, 0.16f, 0.35f);
    set(ImGuiCol_HeaderHovered, 0.86f, 0.46f, 0.20f, 0.55f);
    set(ImGuiCol_HeaderActive, 0.92f, 0.52f, 0.24f, 0.75f);
    set(ImGuiCol_CheckMark, 0.98f, 0.62f, 0.30f, 1.0f);
    set(ImGuiCol_PlotLines, 0.98f, 0.66f, 0.34f, 1.0f);
    set(ImGuiCol_PlotHistogram, 0.98f, 0.62f, 0.30f, 1.0f);
    set(ImGuiCol_Separator, 1.0f, 1.0f, 1.0f, 0.12f);
    set(ImGuiCol_TableHeaderBg, 1.0f, 1.0f, 1.0f, 0.06f);
    set(ImGuiCol_TableRowBgAlt, 1.0f, 1.0f, 1.0f, 0.03f);
    style.ScaleAllSizes(scale);
}

}  // namespace

UserInterface::UserInterface(float scale, GLFWwindow* window) : window_(window)
{
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;  // the program writes no file that nobody asked for
    load_font(scale);
    set_style(scale);
    if (window_ != nullptr) ImGui_ImplGlfw_InitForOpenGL(window_, true);
    ImGui_ImplOpenGL3_Init("#version 330 core");
}

UserInterface::~UserInterface()
{
    ImGui_ImplOpenGL3_Shutdown();
    if (window_ != nullptr) ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

void UserInterface::use_game_letters(int picture_width, int picture_height)
{
    const int height = std::min(picture_height, picture_width * 9 / 16);
    if (ui::fits(letters_, height)) return;
    letters_ = ui::load_typeface(height);
    // Before the first frame there is no texture of letters yet: that frame makes it.
    if (!has_begun_) return;
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
}

void UserInterface::begin()
{
    has_begun_ = true;
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
}

void UserInterface::begin(int width, int height, double seconds)
{
    has_begun_ = true;
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {static_cast<float>(width), static_cast<float>(height)};
    io.DeltaTime = static_cast<float>(seconds);
    ImGui_ImplOpenGL3_NewFrame();
    ImGui::NewFrame();
}

void UserInterface::draw()
{
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

void UserInterface::skip()
{
    ImGui::EndFrame();
}

bool UserInterface::wants_mouse() const
{
    return ImGui::GetIO().WantCaptureMouse;
}

bool UserInterface::wants_keyboard() const
{
    return ImGui::GetIO().WantTextInput;
}

}  // namespace kerf::app
