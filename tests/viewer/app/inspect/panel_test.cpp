#include "viewer/app/inspect/panel.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include "viewer/app/inspect/keys.h"
#include "viewer/app/user_interface.h"
#include "viewer/game/autopilot.h"
#include "viewer/game/scenes.h"
#include "viewer/render/gl_test.h"
#include "viewer/render/offscreen_context.h"
#include "viewer/sim/camera.h"
#include "viewer/support/stages.h"

namespace kerf::test {

namespace {

class PanelTest : public GlTest
{
protected:
    PanelTest()
    {
        game::Autopilot autopilot(1);
        while (simulation.now() < 2000 && simulation.cuts().empty()) {
            simulation.push(autopilot.play(simulation));
            simulation.advance();
            painter.sync(simulation);
        }
        painter.paint(simulation, view);
    }

    /// All words of the panel, or of the list of keys without it, in a picture of so many pixels, as Dear ImGui logs
    /// them.
    std::string words(int width = 1280, int height = 720) { return words_of(simulation, width, height); }
    std::string words_of(const sim::Simulation& shown, int width = 1280, int height = 720)
    {
        static std::string copied;
        copied.clear();
        ImGui::GetIO().SetClipboardTextFn = [](void*, const char* text) { copied = text; };
        for (int frame = 0; frame < 3; ++frame) {
            interface.begin(width, height, 1.0 / 60.0);
            app::PanelState state{shown, painter, frames, view, ""};
            if (frame == 2) ImGui::LogToClipboard();
            app::show_panel(state);
            if (frame == 2) ImGui::LogFinish();
            interface.skip();
        }
        return copied;
    }

    sim::Simulation simulation{library_of({"torus"}, 2000), {}};
    app::Painter painter{320, 180};
    app::FrameStatistics frames;
    app::ViewSettings view;
    app::UserInterface interface {
        1.0f
    };
};

}  // namespace

TEST_F(PanelTest, ShowsWhatTheLastCutCost)
{
    ASSERT_FALSE(simulation.cuts().empty());
    const sim::CutRecord& cut = simulation.cuts().back();
    const std::string text = words();
    const CutStatistics& s = cut.statistics;
    const std::string loops = std::to_string(s.section_loops) + (s.section_loops == 1 ? " loop" : " loops");
    for (const std::string& wanted : {std::string("torus"), std::to_string(s.triangles) + " triangles",
                                      std::to_string(s.crossing_surface) + " crossing", loops, std::string("proxies"),
                                      std::string("uploaded"), std::string("swipe to upload"), cut.backend})
        EXPECT_NE(text.find(wanted), std::string::npos) << wanted << " in\n" << text;
    for (const Phase phase : {Phase::find, Phase::split, Phase::cap, Phase::rebuild})
        if (s.phase_ms[std::size_t(phase)] > 0.02 * s.milliseconds()) {
            EXPECT_NE(text.find(kerf::text(phase)), std::string::npos) << kerf::text(phase) << " in\n" << text;
        }
}

TEST_F(PanelTest, ShowsWhatBreakingCostsAndHowThingsBreak)
{
    const auto models = library_of({"icosphere"}, 1000);
    sim::Simulation broken(models, {}, game::make_scene("shatter", models));
    broken.command("cells 25");
    broken.advance(60);
    const glm::dvec2 place = sim::Camera::seen_on_stage(broken.bodies().front()->centre());
    broken.push({broken.time() + 1, sim::InputKind::press, place, {}});
    broken.advance(2);
    ASSERT_EQ(broken.breaks().size(), 1u);
    const sim::BreakRecord& record = broken.breaks().front();
    const std::string text = words_of(broken);
    for (const std::string& wanted :
         {std::string("click to break"), std::string("cells"), std::string("impact"), std::string("strength"),
          std::to_string(record.triangles) + " triangles", std::to_string(record.pieces.size()) + " pieces",
          std::to_string(record.bonds) + " bonds", std::string("ms a piece"), record.backend})
        EXPECT_NE(text.find(wanted), std::string::npos) << wanted << " in\n" << text;
}

TEST_F(PanelTest, SaysBesideFrameTimesThatAProgramDraws)
{
    EXPECT_EQ(words().find("software renderer") != std::string::npos, render::draws_in_software());
}

TEST_F(PanelTest, ListsEveryKey)
{
    view.panel = false;
    view.help = true;
    for (const int height : {720, 360}) {
        const std::string text = words(640, height);
        for (const app::KeyBinding& binding : app::kKeyBindings)
            EXPECT_NE(text.find(binding.description), std::string::npos) << binding.description;
    }
}

TEST_F(PanelTest, StaysInALowWindow)
{
    view.help = true;
    for (const glm::ivec2 size : {glm::ivec2(1280, 720), glm::ivec2(640, 360)}) {
        words(size.x, size.y);
        interface.begin(size.x, size.y, 1.0 / 60.0);
        app::PanelState state{simulation, painter, frames, view, ""};
        app::show_panel(state);
        for (const char* name : {"Kerf", "Keys"}) {
            ImGui::Begin(name);
            const ImVec2 place = ImGui::GetWindowPos(), extent = ImGui::GetWindowSize();
            ImGui::End();
            EXPECT_GE(place.x, 0.0f) << name;
            EXPECT_GE(place.y, 0.0f) << name;
            EXPECT_LE(place.x + extent.x, static_cast<float>(size.x)) << name;
            EXPECT_LE(place.y + extent.y, static_cast<float>(size.y)) << name;
        }
        interface.skip();
    }
}

}  // namespace kerf::test
