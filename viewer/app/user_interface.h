#pragma once

#include "viewer/ui/typeface.h"

struct GLFWwindow;

namespace kerf::app {

/// Dear ImGui over the picture: with a window, or without one for pictures. One at a time; needs a current GL context.
class UserInterface
{
public:
    /// @param scale   of texts and spacing; 1 at 96 dots per inch
    /// @param window  gets call-backs for mouse and keyboard, before which its own must be set; null: nobody types
    explicit UserInterface(float scale, GLFWwindow* window = nullptr);
    ~UserInterface();
    UserInterface(const UserInterface&) = delete;
    UserInterface& operator=(const UserInterface&) = delete;

    /// Loads the game's letters for pictures of this size, unless those that are there fit. Before begin(). What is
    /// narrower than 16:9 has smaller letters, so that as much fits beside one another.
    void use_game_letters(int picture_width, int picture_height);
    const ui::Typeface& letters() const { return letters_; }

    /// Starts a frame of the window.
    void begin();
    /// Starts a frame of so many pixels.
    void begin(int width, int height, double seconds);
    /// Draws what was shown since begin() into the current framebuffer.
    void draw();
    /// Ends a frame without drawing it.
    void skip();

    /// The pointer is on a panel: it does not cut.
    bool wants_mouse() const;
    bool wants_keyboard() const;

private:
    GLFWwindow* window_;
    ui::Typeface letters_;
    bool has_begun_ = false;
};

}  // namespace kerf::app
