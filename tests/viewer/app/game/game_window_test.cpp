#include "viewer/app/game/game_window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "viewer/app/virtual_display.h"

namespace kerf::test {

namespace {

/// No sound device is looked for, and none complains on the terminal.
struct Quiet
{
    Quiet() { ::setenv("ALSOFT_DRIVERS", "null", 1); }
    ~Quiet() { ::unsetenv("ALSOFT_DRIVERS"); }
};

class GameWindowTest : public ::testing::Test
{
protected:
    void TearDown() override
    {
        errors.check();
        for (const std::string& message : errors.messages()) ADD_FAILURE() << "GL: " << message;
    }

    static app::Options small_window()
    {
        app::Options options;
        options.data_folder = KERF_DATA_DIR;
        options.width = 320;
        options.height = 180;
        options.has_size = true;
        options.vsync = false;
        options.seed = 1;
        return options;
    }

    /// As GLFW reports it.
    void press(int key)
    {
        GLFWwindow* const handle = window.handle();
        const GLFWkeyfun pressed = glfwSetKeyCallback(handle, nullptr);
        glfwSetKeyCallback(handle, pressed);
        pressed(handle, key, 0, GLFW_PRESS, 0);
        pressed(handle, key, 0, GLFW_RELEASE, 0);
        ASSERT_TRUE(loop.frame());
    }

    void wait_for_scene(const std::string& scene)
    {
        while (game.flow().scene() != scene) ASSERT_TRUE(loop.frame());
    }

    Quiet quiet;
    VirtualDisplay display;
    app::Options options = small_window();
    app::Window window{options.width, options.height, options.fullscreen, "Kerf"};
    render::GlErrorLog errors;
    app::GameWindow game{options, {}, window};
    app::WindowDisplay seen{window};
    app::MainLoop loop{game, seen, errors, {}};
};

}  // namespace

TEST_F(GameWindowTest, OpensWithTheMenuAndIsPlayedByKeys)
{
    ASSERT_TRUE(loop.frame());
    EXPECT_EQ(game.flow().scene(), "menu");
    press(GLFW_KEY_RIGHT);
    press(GLFW_KEY_ENTER);
    wait_for_scene("arcade");
    press(GLFW_KEY_ESCAPE);
    EXPECT_EQ(game.flow().screens().screen(), ui::Screen::paused);
    press(GLFW_KEY_ENTER);
    EXPECT_EQ(game.flow().screens().screen(), ui::Screen::play);
    press(GLFW_KEY_P);
    press(GLFW_KEY_UP);
    press(GLFW_KEY_ENTER);
    EXPECT_EQ(game.flow().scene(), "menu");
}

TEST_F(GameWindowTest, KeysThatAreHeldSteerABladeWhileAGameIsPlayed)
{
    ASSERT_TRUE(loop.frame());
    press(GLFW_KEY_SPACE);
    wait_for_scene("classic");
    const auto key = [&](int code, int action) {
        GLFWwindow* const handle = window.handle();
        const GLFWkeyfun pressed = glfwSetKeyCallback(handle, nullptr);
        glfwSetKeyCallback(handle, pressed);
        pressed(handle, code, 0, action, 0);
        ASSERT_TRUE(loop.frame());
    };
    key(GLFW_KEY_W, GLFW_PRESS);
    key(GLFW_KEY_SPACE, GLFW_PRESS);
    EXPECT_EQ(game.flow().screens().screen(), ui::Screen::play);
    EXPECT_TRUE(game.flow().round().blade_input().keyboard().is_cutting());
    EXPECT_GT(game.flow().round().blade_input().keyboard().place().y, 0.0);
    key(GLFW_KEY_SPACE, GLFW_RELEASE);
    key(GLFW_KEY_W, GLFW_RELEASE);
    EXPECT_FALSE(game.flow().round().blade_input().keyboard().is_cutting());
    const glm::dvec2 place = game.flow().round().blade_input().keyboard().place();
    ASSERT_TRUE(loop.frame());
    EXPECT_EQ(game.flow().round().blade_input().keyboard().place(), place);
}

TEST_F(GameWindowTest, FollowsItsSettings)
{
    ASSERT_TRUE(loop.frame());
    press(GLFW_KEY_M);
    EXPECT_TRUE(game.flow().settings().mute);
    game.flow().show_screen(ui::Screen::settings);
    for (int i = 0; i < 4; ++i) press(GLFW_KEY_DOWN);
    press(GLFW_KEY_LEFT);
    for (int i = 0; i < 50 && window.size().x != 960; ++i) ASSERT_TRUE(loop.frame());
    EXPECT_EQ(window.size(), glm::ivec2(960, 540));
    press(GLFW_KEY_DOWN);
    press(GLFW_KEY_RIGHT);
    EXPECT_FALSE(window.vsync());
}

TEST_F(GameWindowTest, TheKeyAndTheSettingForTheWholeScreenAreOne)
{
    ASSERT_TRUE(loop.frame());
    press(GLFW_KEY_F11);
    ASSERT_TRUE(loop.frame());
    EXPECT_TRUE(window.fullscreen());
    EXPECT_TRUE(game.flow().settings().fullscreen);
    press(GLFW_KEY_F11);
    ASSERT_TRUE(loop.frame());
    EXPECT_FALSE(window.fullscreen());
    EXPECT_FALSE(game.flow().settings().fullscreen);
}

TEST_F(GameWindowTest, AKeyThatIsHeldGivesItsCommandOnce)
{
    ASSERT_TRUE(loop.frame());
    GLFWwindow* const handle = window.handle();
    const GLFWkeyfun pressed = glfwSetKeyCallback(handle, nullptr);
    glfwSetKeyCallback(handle, pressed);
    for (const int key : {GLFW_KEY_M, GLFW_KEY_RIGHT}) {
        pressed(handle, key, 0, GLFW_PRESS, 0);
        pressed(handle, key, 0, GLFW_REPEAT, 0);
        ASSERT_TRUE(loop.frame());
    }
    EXPECT_TRUE(game.flow().settings().mute);
    EXPECT_EQ(game.flow().screens().selected(), 2u) << "arrows move on";
}

TEST_F(GameWindowTest, SurvivesAnySizeAndBeingMinimised)
{
    for (const glm::ivec2 size : {glm::ivec2(1, 1), glm::ivec2(1, 300), glm::ivec2(700, 2), glm::ivec2(320, 180)}) {
        window.resize(size.x, size.y);
        for (int i = 0; i < 3; ++i) ASSERT_TRUE(loop.frame());
    }
    window.minimise();
    ASSERT_TRUE(loop.frame());
    window.restore();
    ASSERT_TRUE(loop.frame());
}

TEST_F(GameWindowTest, EndsWhenThePlayerQuits)
{
    ASSERT_TRUE(loop.frame());
    press(GLFW_KEY_ESCAPE);  // chooses "Quit"
    GLFWwindow* const handle = window.handle();
    const GLFWkeyfun pressed = glfwSetKeyCallback(handle, nullptr);
    glfwSetKeyCallback(handle, pressed);
    pressed(handle, GLFW_KEY_ENTER, 0, GLFW_PRESS, 0);
    loop.frame();
    EXPECT_FALSE(loop.frame());
}

}  // namespace kerf::test
