#include "viewer/render/shader_program.h"

#include <array>
#include <utility>
#include <vector>

#include "viewer/render/render_error.h"

namespace kerf::render {

namespace {

std::string joined(const ShaderFiles& files)
{
    std::string names;
    for (const std::string_view file : files) names += (names.empty() ? "" : " + ") + std::string(file);
    return names;
}

/// A shader that dies at the end of the scope: the program keeps what it needs of it.
struct CompiledShader
{
    GLuint id = 0;

    explicit CompiledShader(GLenum stage) : id(glCreateShader(stage)) {}
    CompiledShader(CompiledShader&& other) noexcept : id(std::exchange(other.id, 0)) {}
    CompiledShader& operator=(CompiledShader&&) = delete;
    ~CompiledShader() { glDeleteShader(id); }
};

CompiledShader compiled(GLenum stage, const ShaderFiles& files)
{
    std::string source = "#version 330 core\n";
    for (const std::string_view file : files) source += shader_source(file);
    CompiledShader shader(stage);
    const GLchar* const text = source.c_str();
    glShaderSource(shader.id, 1, &text, nullptr);
    glCompileShader(shader.id);
    GLint is_good = 0;
    glGetShaderiv(shader.id, GL_COMPILE_STATUS, &is_good);
    if (is_good == 0) {
        std::array<char, 2000> log{};
        glGetShaderInfoLog(shader.id, static_cast<GLsizei>(log.size()), nullptr, log.data());
        throw RenderError("the driver does not compile the shader " + joined(files) + ": " + log.data());
    }
    return shader;
}

}  // namespace

ShaderProgram::ShaderProgram(const ShaderFiles& vertex_files, const ShaderFiles& fragment_files,
                             const ShaderFiles& geometry_files)
    : program_(GlProgram::create())
{
    std::vector<CompiledShader> shaders;
    shaders.push_back(compiled(GL_VERTEX_SHADER, vertex_files));
    shaders.push_back(compiled(GL_FRAGMENT_SHADER, fragment_files));
    if (!geometry_files.empty()) shaders.push_back(compiled(GL_GEOMETRY_SHADER, geometry_files));
    for (const CompiledShader& shader : shaders) glAttachShader(program_.id(), shader.id);
    glLinkProgram(program_.id());
    for (const CompiledShader& shader : shaders) glDetachShader(program_.id(), shader.id);
    GLint is_good = 0;
    glGetProgramiv(program_.id(), GL_LINK_STATUS, &is_good);
    if (is_good == 0) {
        std::array<char, 2000> log{};
        glGetProgramInfoLog(program_.id(), static_cast<GLsizei>(log.size()), nullptr, log.data());
        throw RenderError("the driver does not link the shaders " + joined(vertex_files) + " and " +
                          joined(fragment_files) + ": " + log.data());
    }
    const auto bind = [&](const char* name, UniformBlock block) {
        const GLuint index = glGetUniformBlockIndex(program_.id(), name);
        if (index != GL_INVALID_INDEX) glUniformBlockBinding(program_.id(), index, static_cast<GLuint>(block));
    };
    bind("Frame", UniformBlock::frame);
    bind("Looks", UniformBlock::looks);
    bind("Swarm", UniformBlock::swarm);
}

}  // namespace kerf::render
