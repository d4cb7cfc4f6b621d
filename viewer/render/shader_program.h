#pragma once

#include <string>
#include <string_view>
#include <vector>

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
    swarm = 2,  ///< "Swarm" of member_model.glsl
};

/// Names of shader files, in the order of the text.
using ShaderFiles = std::vector<std::string_view>;

/// A linked GLSL program.
class ShaderProgram
{
public:
    ShaderProgram() = default;

    /// Each stage is several files one after the other; an empty geometry stage is left out.
    /// @throws RenderError  with the driver's message
    ShaderProgram(const ShaderFiles& vertex_files, const ShaderFiles& fragment_files,
                  const ShaderFiles& geometry_files = {});

    void use() const { glUseProgram(program_.id()); }

    /// -1 when the program has no use for the uniform; setting that is no error in GL.
    GLint uniform(const char* name) const { return glGetUniformLocation(program_.id(), name); }

private:
    GlProgram program_;
};

}  // namespace kerf::render
