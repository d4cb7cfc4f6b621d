#include "viewer/app/player.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include "viewer/app/virtual_display.h"
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

class PlayerTest : public ::testing::Test
{
protected:
    void TearDown() override
    {
        player.errors().check();
        for (const std::string& message : player.errors().messages()) ADD_FAILURE() << "GL: " << message;
    }

    void frames(int count)
    {
        for (int i = 0; i < count; ++i) ASSERT_TRUE(player.frame());
    }

    explicit PlayerTest(app::Options chosen = small_window()) : options(std::move(chosen)) {}

    VirtualDisplay display;
    app::Options options;
    app::Session session = app::open_session(options);
    app::Player player{options, session};
};

/// What GLFW calls when the left button moves: the call-backs that the window and the panel have set.
class Hand
{
public:
    explicit Hand(app::Player& player) : window_(player.window().handle()) {}

    void move_to(const glm::dvec2& pixel)
    {
        glfwSetCursorPos(window_, pixel.x, pixel.y);
        const GLFWcursorposfun moved = glfwSetCursorPosCallback(window_, nullptr);
        glfwSetCursorPosCallback(window_, moved);
        moved(window_, pixel.x, pixel.y);
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

/// In fixed steps, so that the hand is as fast on a slow machine; the panel is not in its way.
class DraggingTest : public PlayerTest
{
protected:
    DraggingTest() : PlayerTest(fixed_steps()) {}

private:
    static app::Options fixed_steps()
    {
        app::Options fixed = small_window();
        fixed.frames = 100'000;
        fixed.view.panel = false;
        return fixed;
    }
};

}  // namespace

TEST_F(PlayerTest, SurvivesAnySizeOfItsWindow)
{
    for (const glm::ivec2 size : {glm::ivec2(1, 1), glm::ivec2(1, 400), glm::ivec2(900, 2), glm::ivec2(320, 180)}) {
        player.window().resize(size.x, size.y);
        frames(3);
    }
    EXPECT_EQ(player.painter().target().width(), 320);
    EXPECT_EQ(player.painter().target().height(), 180);
}

TEST_F(PlayerTest, SurvivesBeingMinimised)
{
    frames(2);
    player.window().minimise();
    frames(3);
    player.window().restore();
    frames(3);
}

TEST_F(PlayerTest, PausesWhileAnotherWindowHasTheFocus)
{
    const auto wait_for_focus = [&](bool wanted) {
        for (int i = 0; i < 50 && player.window().has_focus() != wanted; ++i) frames(1);
        ASSERT_EQ(player.window().has_focus(), wanted);
        frames(1);
    };
    glfwFocusWindow(player.window().handle());
    wait_for_focus(true);
    EXPECT_FALSE(player.paused());
    GLFWwindow* const other = glfwCreateWindow(50, 50, "other", nullptr, nullptr);
    ASSERT_NE(other, nullptr);
    glfwFocusWindow(other);
    wait_for_focus(false);
    EXPECT_TRUE(player.paused());
    glfwFocusWindow(player.window().handle());
    wait_for_focus(true);
    EXPECT_FALSE(player.paused());
    glfwDestroyWindow(other);
}

TEST_F(PlayerTest, EveryKeyDoesSomethingAndNothingBreaks)
{
    frames(2);
    for (const app::KeyBinding& binding : app::kKeyBindings) {
        if (binding.action == app::KeyAction::screenshot || binding.action == app::KeyAction::quit) continue;
        for (int twice = 0; twice < 2; ++twice) {
            player.act(binding.action);
            frames(2);
        }
    }
    player.act(app::KeyAction::quit);
    EXPECT_FALSE(player.frame());
}

TEST_F(PlayerTest, TheBackEndKeySwitchesForTheNextThrow)
{
    frames(1);
    const std::string first = player.simulation().backend();
    player.act(app::KeyAction::next_backend);
    for (int i = 0; i < 100 && player.simulation().backend() == first; ++i) frames(1);
    EXPECT_NE(player.simulation().backend(), first);
    player.act(app::KeyAction::next_backend);
    for (int i = 0; i < 100 && player.simulation().backend() != first; ++i) frames(1);
    EXPECT_EQ(player.simulation().backend(), first);
}

TEST_F(DraggingTest, CutsWhatThePointerCrosses)
{
    const sim::Simulation& simulation = player.simulation();
    for (int i = 0; i < 200 && (simulation.bodies().empty() || simulation.bodies().front()->centre().y < 0.0); ++i)
        frames(1);
    ASSERT_EQ(simulation.bodies().size(), 1u);
    // Across the object, ahead of where it flies, over six frames: a tenth of a second.
    const sim::Body& body = *simulation.bodies().front();
    const glm::dvec3 middle = body.centre() + 0.05 * body.motion().velocity;
    const sim::Camera camera(320.0 / 180.0);
    Hand hand(player);
    for (int i = 0; i <= 6; ++i) {
        const glm::dvec2 stage(middle.x + 2.2 * (i - 3) / 3.0, middle.y);
        hand.move_to(camera.stage_to_screen(stage, {320.0, 180.0}));
        if (i == 0) hand.button(GLFW_PRESS);
        if (i == 6) hand.button(GLFW_RELEASE);
        frames(1);
    }
    frames(3);
    ASSERT_GE(simulation.cuts().size(), 1u);
    EXPECT_EQ(simulation.cuts().front().status, Status::cut);
    EXPECT_GE(simulation.bodies().size(), 2u);
}

TEST_F(DraggingTest, EndsASwipeWhenTheFocusIsLost)
{
    frames(2);
    Hand hand(player);
    hand.move_to({100.0, 90.0});
    hand.button(GLFW_PRESS);
    frames(2);
    EXPECT_TRUE(player.simulation().blade().pressed());
    const GLFWwindowfocusfun focused = glfwSetWindowFocusCallback(player.window().handle(), nullptr);
    glfwSetWindowFocusCallback(player.window().handle(), focused);
    focused(player.window().handle(), GLFW_FALSE);
    frames(2);
    EXPECT_FALSE(player.simulation().blade().pressed());
}

}  // namespace kerf::test
