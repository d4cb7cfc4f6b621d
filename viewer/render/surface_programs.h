#pragma once

#include <cstdint>
#include <map>
#include <string_view>
#include <utility>

#include "viewer/render/drawn_object.h"
#include "viewer/render/shader_program.h"

namespace kerf::render {

enum class Lighting : std::uint8_t
{
    lambert,   ///< the report's: a colour, a light, the cosine between
    textured,  ///< patterns in object space and cap uv, highlights, the light of the room
};

/// From where a shader knows what it shades.
enum class PointSource : std::uint8_t
{
    triangle,         ///< the triangle that is being drawn
    swarm,            ///< the same, and the triangle's vertices say of which of a Swarm's members it is
    geometry_buffer,  ///< what the GeometryBuffer holds at the pixel
};

/// True if the pattern needs no uv and no differences to its neighbours: the geometry buffer says enough to shade it.
bool shades_from_geometry_buffer(Pattern pattern, TriangleKind kind);

/// A program that shades surfaces. Uniforms that only one of the sources has are -1 in the other.
struct SurfaceProgram
{
    ShaderProgram program;
    GLint model, pattern_scale, look_index, is_cap;
    GLint clipped;                    ///< not of PointSource::geometry_buffer
    GLint to_mesh, batch, is_behind;  ///< of PointSource::geometry_buffer

    explicit SurfaceProgram(ShaderProgram linked);
};

/// Texture units of all surface programs.
struct SurfaceUnits
{
    static constexpr GLint kShadowMap = 0, kImage = 1, kGeometry = 2, kGeometryDepth = 3;
};

/// The programs that shade surfaces, made when they are asked for first.
class SurfacePrograms
{
public:
    explicit SurfacePrograms(const LookTable& looks) : looks_(looks) {}

    /// @throws RenderError
    const SurfaceProgram& find(Lighting lighting, Pattern pattern, PointSource source);

    /// Makes the program of this batch the one in use, with the object's uniforms and the batch's image. What is in use
    /// already is not set again: call begin() when somebody else may have used another program.
    /// @throws RenderError
    const SurfaceProgram& use(const SurfaceDraw& draw, Lighting lighting, PointSource source);
    void begin();

private:
    void place(const SurfaceProgram& surface, const DrawnObject& object);
    void bind_image(std::uint32_t image);

    using Key = std::pair<const std::string_view*, PointSource>;  ///< place of shaders_of(pattern); null: Lambert's

    const LookTable& looks_;
    std::map<Key, SurfaceProgram> programs_;
    const SurfaceProgram* in_use_ = nullptr;
    const DrawnObject* placed_ = nullptr;
    std::uint32_t image_ = 0;
};

}  // namespace kerf::render
