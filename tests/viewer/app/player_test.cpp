#include "viewer/app/player.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include "viewer/app/virtual_display.h"

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

    VirtualDisplay display;
    app::Options options = small_window();
    app::Session session = app::open_session(options);
    app::Player player{options, session};
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

}  // namespace kerf::test
