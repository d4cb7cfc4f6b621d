#pragma once

#include <stdexcept>

namespace kerf::render {

/// The graphics system cannot do what is asked: no display, no OpenGL 3.3, no memory for a picture. what() is one
/// sentence.
class RenderError : public std::runtime_error
{
public:
    using std::runtime_error::runtime_error;
};

}  // namespace kerf::render
