#include "viewer/app/inspect/inspection_window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "support/temporary_folder.h"
#include "viewer/app/virtual_display.h"
#include "viewer/sim/back_ends.h"
#include "viewer/sim/camera.h"

namespace kerf::test {

namespace {

app::Options small_window()
{
    app::Options options;
    options.data_folder = KERF_DATA_DIR;
    options.width = 320;
    options.height = 180;
    options.vsync = false;
    return options;
}

class InspectionWindowTest : public ::testing::Test
{
protected:
    void TearDown() override
    {
        errors.check();
        for (const std::string& message : errors.messages()) ADD_FAILURE() << "GL: " << message;
    }

    // Where a test waits for something that takes real time, it does so as long as ctest lets it: machines differ.
    void frames(int count)
    {
        for (int i = 0; i < count; ++i) ASSERT_TRUE(loop.frame());
    }

    explicit InspectionWindowTest(app::Options chosen = small_window()) : options(std::move(chosen)) {}

    VirtualDisplay display;
    app::Options options;
    app::RunSetup setup = app::read_run_setup(options);
    app::Window window{options.width, options.height, options.fullscreen, "Kerf"};
    render::GlErrorLog errors;
    app::InspectionWindow inspection{options, setup, window};
    app::WindowDisplay seen{window};
    app::MainLoop loop{
        inspection, seen, errors, {options.frames > 0 ? app::Pace::fixed_step : app::Pace::real_time, options.frames}};
};

/// What GLFW calls when the left button moves: the call-backs that the window and the panel have set.
class Hand
{
public:
    explicit Hand(const app::Window& window) : window_(window.handle()) {}

    void move_to(const glm::dvec2& pixel)
    {
        glfwSetCursorPos(window_, pixel.x, pixel.y);
        const GLFWcursorposfun moved = glfwSetCursorPosCallback(window_, nullptr);
        glfwSetCursorPosCallback(window_, moved);
        moved(window_, pixel.x, pixel.y);
    }
    void key(int code)
    {
        const GLFWkeyfun pressed = glfwSetKeyCallback(window_, nullptr);
        glfwSetKeyCallback(window_, pressed);
        pressed(window_, code, 0, GLFW_PRESS, 0);
        pressed(window_, code, 0, GLFW_RELEASE, 0);
    }
    void button(int action)
    {
        const GLFWmousebuttonfun pressed = glfwSetMouseButtonCallback(window_, nullptr);
        glfwSetMouseButtonCallback(window_, pressed);
        pressed(window_, GLFW_MOUSE_BUTTON_LEFT, action, 0);
    }

private:
    GLFWwindow* window_;
};

/// The key that the list of keys calls so.
int code_of(const std::string& name)
{
    if (name.size() == 1) return GLFW_KEY_A + (name[0] - 'A');
    static const std::map<std::string, int> kNamed{{"Space", GLFW_KEY_SPACE},
                                                   {"Tab", GLFW_KEY_TAB},
                                                   {"F11", GLFW_KEY_F11},
                                                   {"F12", GLFW_KEY_F12},
                                                   {"Esc", GLFW_KEY_ESCAPE}};
    return kNamed.at(name);
}

/// In fixed steps, so that the hand is as fast on a slow machine; the panel is not in its way.
class DraggingTest : public InspectionWindowTest
{
protected:
    DraggingTest() : InspectionWindowTest(fixed_steps()) {}

private:
    static app::Options fixed_steps()
    {
        app::Options fixed = small_window();
        fixed.frames = 100'000;
        fixed.view.panel = false;
        return fixed;
    }
};

/// A game that the program plays itself.
class InspectionOfAGameTest : public InspectionWindowTest
{
protected:
    InspectionOfAGameTest()
        : InspectionWindowTest([] {
              app::Options chosen = small_window();
              chosen.scene = "classic";
              chosen.autopilot = true;
              return chosen;
          }())
    {
    }
};

}  // namespace

TEST_F(InspectionOfAGameTest, ShowsTheGameInsteadOfThePanel)
{
    EXPECT_FALSE(inspection.view().panel);
    frames(20);
    inspection.act(app::KeyAction::panel);
    EXPECT_TRUE(inspection.view().panel);
    frames(2);
}

TEST_F(InspectionWindowTest, SurvivesAnySizeOfItsWindow)
{
    for (const glm::ivec2 size : {glm::ivec2(1, 1), glm::ivec2(1, 400), glm::ivec2(900, 2), glm::ivec2(320, 180)}) {
        window.resize(size.x, size.y);
        frames(3);
    }
    EXPECT_EQ(inspection.picture().width(), 320);
    EXPECT_EQ(inspection.picture().height(), 180);
}

TEST_F(InspectionWindowTest, SurvivesBeingMinimised)
{
    frames(2);
    window.minimise();
    frames(3);
    EXPECT_FALSE(inspection.paused());
    window.restore();
    frames(3);
    EXPECT_EQ(inspection.picture().width(), 320);
    EXPECT_EQ(inspection.picture().height(), 180);
}

TEST_F(InspectionWindowTest, PausesWhileAnotherWindowHasTheFocus)
{
    const auto wait_for_focus = [&](bool wanted) {
        while (window.has_focus() != wanted) frames(1);
        frames(1);
    };
    glfwFocusWindow(window.handle());
    wait_for_focus(true);
    EXPECT_FALSE(inspection.paused());
    GLFWwindow* const other = glfwCreateWindow(50, 50, "other", nullptr, nullptr);
    ASSERT_NE(other, nullptr);
    glfwFocusWindow(other);
    wait_for_focus(false);
    EXPECT_TRUE(inspection.paused());
    glfwFocusWindow(window.handle());
    wait_for_focus(true);
    EXPECT_FALSE(inspection.paused());
    glfwDestroyWindow(other);
}

TEST_F(InspectionWindowTest, EveryKeyDoesSomethingAndNothingBreaks)
{
    frames(2);
    for (const app::KeyBinding& binding : app::kKeyBindings) {
        if (binding.action == app::KeyAction::screenshot || binding.action == app::KeyAction::quit) continue;
        for (int twice = 0; twice < 2; ++twice) {
            inspection.act(binding.action);
            frames(2);
        }
    }
    inspection.act(app::KeyAction::quit);
    EXPECT_FALSE(loop.frame());
}

TEST(Keys, MeanWhatTheirListSays)
{
    for (const app::KeyBinding& binding : app::kKeyBindings)
        EXPECT_EQ(app::action_of(code_of(binding.key)), binding.action) << binding.key;
    EXPECT_FALSE(app::action_of(GLFW_KEY_F7));
}

TEST_F(DraggingTest, KeysChangeWhatTheySay)
{
    frames(40);
    Hand hand(window);
    const auto press = [&](const char* key) {
        hand.key(code_of(key));
        frames(1);
    };
    for (const bool on : {true, false}) {
        press("Space");
        EXPECT_EQ(inspection.paused(), on);
    }
    for (const bool on : {true, false}) {
        press("M");
        EXPECT_EQ(inspection.slow_motion(), on);
    }
    for (const bool on : {true, false}) {
        press("P");
        EXPECT_EQ(inspection.view().proxies, on);
        press("W");
        EXPECT_EQ(inspection.view().wireframe, on);
        press("Tab");
        EXPECT_EQ(inspection.view().panel, on);
        press("H");
        EXPECT_EQ(inspection.view().help, on);
        press("I");
        EXPECT_EQ(inspection.view().lighting, on ? render::Lighting::lambert : render::Lighting::textured);
        const bool vsync = window.vsync();
        press("V");
        EXPECT_NE(window.vsync(), vsync);
    }
    const sim::Simulation& simulation = inspection.simulation();
    ASSERT_EQ(simulation.bodies().size(), 1u);
    press("R");
    ASSERT_EQ(simulation.bodies().size(), 2u);
    const auto model = [&](std::size_t i) { return simulation.bodies()[i]->identity().origin.model; };
    EXPECT_EQ(model(1), model(0)) << "R repeats";
    press("T");
    ASSERT_EQ(simulation.bodies().size(), 3u);
    EXPECT_NE(model(2), model(0)) << "T throws the next";
    press("Esc");
    EXPECT_FALSE(loop.frame());
}

TEST_F(InspectionWindowTest, FillsTheScreenAndComesBack)
{
    frames(1);
    Hand hand(window);
    hand.key(GLFW_KEY_F11);
    frames(3);
    EXPECT_TRUE(window.fullscreen());
    EXPECT_EQ(window.size(), glm::ivec2(1280, 1024)) << "the whole screen";
    hand.key(GLFW_KEY_F11);
    frames(3);
    EXPECT_FALSE(window.fullscreen());
    EXPECT_EQ(window.size(), glm::ivec2(320, 180));
}

TEST_F(InspectionWindowTest, SingleStepsWhilePaused)
{
    frames(1);
    Hand hand(window);
    hand.key(GLFW_KEY_SPACE);
    frames(1);
    const sim::Tick before = inspection.simulation().now();
    frames(3);
    EXPECT_EQ(inspection.simulation().now(), before);
    hand.key(GLFW_KEY_N);
    frames(3);
    EXPECT_EQ(inspection.simulation().now(), before + sim::kTicksPerFrame);
}

TEST_F(InspectionWindowTest, ChoosesAndSaysSoWhilePaused)
{
    if (sim::backend_names().front() != "halfedge") GTEST_SKIP() << "there is one kind of back end";
    frames(1);
    inspection.act(app::KeyAction::pause);
    frames(1);
    const sim::Simulation& simulation = inspection.simulation();
    const std::string first = simulation.backend();
    Hand hand(window);
    const auto press = [&](const char* key) {
        hand.key(code_of(key));
        frames(1);
        EXPECT_NE(inspection.message(), "") << key;
    };
    press("B");
    const std::string other = simulation.backend_to_come();
    EXPECT_NE(other, first);
    EXPECT_NE(inspection.message().find(other), std::string::npos);
    press("L");
    EXPECT_NE(simulation.backend_to_come(), other);
    press("B");
    EXPECT_EQ(simulation.backend_to_come(), first);
    const sim::ProxyKind proxy = simulation.proxy();
    press("K");
    const sim::ProxyKind second = simulation.proxy_to_come();
    EXPECT_NE(second, proxy);
    press("K");
    EXPECT_NE(simulation.proxy_to_come(), second);
    EXPECT_NE(simulation.proxy_to_come(), proxy);
    press("G");
    EXPECT_EQ(simulation.gesture_to_come(), sim::Gesture::segment);
    press("G");
    EXPECT_EQ(simulation.gesture_to_come(), sim::Gesture::blade);
    press("G");
    EXPECT_EQ(simulation.blade().gesture(), sim::Gesture::blade) << "nothing happens while paused";
    inspection.act(app::KeyAction::single_step);
    frames(2);
    EXPECT_EQ(simulation.blade().gesture(), sim::Gesture::segment);
    EXPECT_EQ(simulation.backend(), first);
    EXPECT_NE(simulation.proxy(), proxy);
}

TEST_F(InspectionWindowTest, NeverOverwritesAPicture)
{
    const TemporaryFolder folder;
    for (const char* name : {"kerf_000.png", "kerf_002.png"}) folder.write(name, "mine");
    const std::filesystem::path here = std::filesystem::current_path();
    std::filesystem::current_path(folder.path());
    frames(1);
    for (int i = 0; i < 2; ++i) inspection.act(app::KeyAction::screenshot);
    std::filesystem::current_path(here);
    for (const char* name : {"kerf_000.png", "kerf_002.png"})
        EXPECT_EQ(std::filesystem::file_size(folder.file(name)), 4u) << name;
    for (const char* name : {"kerf_001.png", "kerf_003.png"})
        EXPECT_GT(std::filesystem::file_size(folder.file(name)), 100u) << name;
}

TEST_F(InspectionWindowTest, TheBackEndKeySwitchesForTheNextThrow)
{
    if (sim::backend_names().front() != "halfedge") GTEST_SKIP() << "there is one kind of back end";
    frames(1);
    const std::string first = inspection.simulation().backend();
    inspection.act(app::KeyAction::next_backend);
    while (inspection.simulation().backend() == first) frames(1);
    inspection.act(app::KeyAction::next_backend);
    while (inspection.simulation().backend() != first) frames(1);
}

TEST_F(DraggingTest, CutsWhatThePointerCrosses)
{
    const sim::Simulation& simulation = inspection.simulation();
    for (int i = 0; i < 200 && (simulation.bodies().empty() || simulation.bodies().front()->centre().y < 0.0); ++i)
        frames(1);
    ASSERT_EQ(simulation.bodies().size(), 1u);
    // Across the object, ahead of where it flies, over six frames: a tenth of a second.
    const sim::Body& body = *simulation.bodies().front();
    const glm::dvec3 middle = body.centre() + 0.05 * body.motion().velocity;
    const sim::Camera camera(320.0 / 180.0);
    Hand hand(window);
    for (int i = 0; i <= 6; ++i) {
        const glm::dvec2 stage(middle.x + 2.2 * (i - 3) / 3.0, middle.y);
        hand.move_to(camera.stage_to_screen(stage, {320.0, 180.0}));
        if (i == 0) hand.button(GLFW_PRESS);
        if (i == 6) hand.button(GLFW_RELEASE);
        frames(1);
    }
    frames(3);
    ASSERT_GE(simulation.cuts().size(), 1u);
    EXPECT_EQ(simulation.cuts().front().status, Status::done);
    EXPECT_GE(simulation.bodies().size(), 2u);
}

TEST_F(DraggingTest, EndsASwipeWhenTheFocusIsLost)
{
    frames(2);
    Hand hand(window);
    hand.move_to({100.0, 90.0});
    hand.button(GLFW_PRESS);
    frames(2);
    EXPECT_TRUE(inspection.simulation().blade().pressed());
    const GLFWwindowfocusfun focused = glfwSetWindowFocusCallback(window.handle(), nullptr);
    glfwSetWindowFocusCallback(window.handle(), focused);
    focused(window.handle(), GLFW_FALSE);
    frames(2);
    EXPECT_FALSE(inspection.simulation().blade().pressed());
}

namespace {

class ShatterWindowTest : public InspectionWindowTest
{
protected:
    ShatterWindowTest() : InspectionWindowTest(shatter_window()) {}

    static app::Options shatter_window()
    {
        app::Options options = small_window();
        options.scene = "shatter";
        options.view.panel = false;
        return options;
    }
};

}  // namespace

TEST_F(ShatterWindowTest, AClickBreaksAndNoFrameWaits)
{
    Hand hand(window);
    sim::Simulation& simulation = inspection.simulation();
    const auto is_high = [&] {
        return !simulation.bodies().empty() && simulation.bodies().front()->centre().y > -0.5 * sim::kStageHalfHeight;
    };
    while (!is_high()) frames(1);
    const glm::dvec2 size(window.size());
    const sim::Camera camera(size.x / size.y);
    const glm::dvec2 place = sim::Camera::seen_on_stage(simulation.bodies().front()->centre());
    hand.move_to(camera.stage_to_screen(place, size));
    hand.button(GLFW_PRESS);
    frames(1);
    hand.button(GLFW_RELEASE);
    const sim::ObjectId struck = simulation.bodies().front()->id();
    while (simulation.breaks().empty() && simulation.world().find(struck) != nullptr) frames(1);
    ASSERT_EQ(simulation.breaks().size(), 1u);
    EXPECT_EQ(simulation.breaks().front().status, Status::done);
    EXPECT_GT(simulation.bodies().size(), 10u);
    frames(3);
}

}  // namespace kerf::test
