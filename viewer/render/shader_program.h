#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

#include "viewer/render/gl_objects.h"

namespace kerf::render {

/// The text of a file of viewer/render/shaders, which the build puts into the program.
/// @throws RenderError  there is none of this name
std::string_view shader_source(std::string_view file_name);

/// Uniform blocks have one binding point each, the same in all programs.
enum class UniformBlock : GLuint
{
    frame = 0,  ///< "Frame" of frame.glsl
    looks = 1,  ///< "Looks" of surface_look.glsl
};

/// A linked GLSL program.
class ShaderProgram
{
public:
    ShaderProgram() = default;

    /// Each stage is several files one after the other; an empty geometry stage is left out.
    /// @throws RenderError  with the driver's message
    ShaderProgram(std::initializer_list<std::string_view> vertex_files,
                  std::initializer_list<std::string_view> fragment_files,
                  std::initializer_list<std::string_view> geometry_files = {});

    void use() const { glUseProgram(program_.id()); }

    /// -1 when the program has no use for the uniform; setting that is no error in GL.
    GLint uniform(const char* name) const { return glGetUniformLocation(program_.id(), name); }

private:
    GlProgram program_;
};

}  // namespace kerf::render
