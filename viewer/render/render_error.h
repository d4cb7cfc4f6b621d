#pragma once

#include <stdexcept>

namespace kerf::render {

/// The graphics system cannot do what is asked: no shader that compiles, no memory for a picture. what() is one
/// sentence.
class RenderError : public std::runtime_error
{
public:
    using std::runtime_error::runtime_error;
};

/// There is nothing to draw on: no display server, or none with OpenGL 3.3.
class NoDisplay : public RenderError
{
public:
    using RenderError::RenderError;
};

}  // namespace kerf::render
