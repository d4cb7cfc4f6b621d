#include "viewer/render/surface_programs.h"

#include <algorithm>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>
#include <span>

namespace kerf::render {

namespace {

ShaderProgram linked(Lighting lighting, std::span<const std::string_view> pattern_files, PointSource source)
{
    const bool is_deferred = source == PointSource::geometry_buffer;
    ShaderFiles files;
    // What names an extension must come first.
    if (is_deferred) files.push_back("sample_mask.glsl");
    files.insert(files.end(), {"frame.glsl", "tone.glsl", "shadow.glsl"});
    if (lighting == Lighting::textured) files.push_back("noise.glsl");
    files.insert(files.end(), {"surface_look.glsl", "surface_point.glsl",
                               is_deferred ? "deferred_point.glsl" : "forward_point.glsl"});
    const bool is_swarm = source == PointSource::swarm;
    if (lighting == Lighting::textured) {
        files.push_back(is_swarm ? "member_turn.glsl" : "one_model.glsl");
        files.insert(files.end(), pattern_files.begin(), pattern_files.end());
    }
    files.push_back(lighting == Lighting::textured ? "textured.glsl" : "lambert.glsl");
    files.push_back(is_deferred ? "deferred.frag" : "forward.frag");
    if (is_deferred) return ShaderProgram({"shade.vert"}, files);
    return ShaderProgram({"frame.glsl", is_swarm ? "member_model.glsl" : "one_model.glsl", "surface.vert"}, files);
}

}  // namespace

bool shades_from_geometry_buffer(Pattern pattern, TriangleKind kind)
{
    switch (pattern) {
        case Pattern::rock_skin:
        case Pattern::rock_core:
            return true;
        case Pattern::plain:
        case Pattern::coat:
        case Pattern::wood:
        case Pattern::stone:
        case Pattern::brushed:
        case Pattern::fur:
        case Pattern::foam:
            return kind == TriangleKind::surface;  // saw marks follow the cap's uv
        default:
            return false;
    }
}

SurfaceProgram::SurfaceProgram(ShaderProgram linked)
    : program(std::move(linked)),
      model(program.uniform("model")),
      pattern_scale(program.uniform("pattern_scale")),
      look_index(program.uniform("look_index")),
      is_cap(program.uniform("is_cap")),
      clipped(program.uniform("clipped")),
      to_mesh(program.uniform("to_mesh")),
      batch(program.uniform("batch")),
      is_behind(program.uniform("is_behind"))
{
    program.use();
    const auto set = [&](const char* name, GLint unit) {
        if (const GLint place = program.uniform(name); place >= 0) glUniform1i(place, unit);
    };
    set("shadow_map", SurfaceUnits::kShadowMap);
    set("image", SurfaceUnits::kImage);
    set("geometry", SurfaceUnits::kGeometry);
    set("geometry_depth", SurfaceUnits::kGeometryDepth);
}

const SurfaceProgram& SurfacePrograms::find(Lighting lighting, Pattern pattern, PointSource source)
{
    const std::span<const std::string_view> own =
        lighting == Lighting::textured ? shaders_of(pattern) : std::span<const std::string_view>();
    const Key key{own.data(), source};
    const auto known = programs_.find(key);
    if (known != programs_.end()) return known->second;
    in_use_ = nullptr;
    return programs_.emplace(key, SurfaceProgram(linked(lighting, own, source))).first->second;
}

void SurfacePrograms::begin()
{
    in_use_ = nullptr;
    placed_ = nullptr;
    image_ = 0;
}

const SurfaceProgram& SurfacePrograms::use(const SurfaceDraw& draw, Lighting lighting, PointSource source)
{
    const SurfaceLook& look = looks_.look(draw.batch->look);
    const SurfaceProgram& surface = find(lighting, look.pattern, source);
    const bool is_other = &surface != in_use_;
    if (is_other) surface.program.use();
    if (is_other || draw.object != placed_) place(surface, *draw.object);
    in_use_ = &surface;
    placed_ = draw.object;
    if (look.image != 0 && look.image != image_) bind_image(look.image);
    glUniform1i(surface.look_index, static_cast<GLint>(draw.batch->look));
    glUniform1i(surface.is_cap, draw.batch->kind == TriangleKind::cap ? 1 : 0);
    return surface;
}

void SurfacePrograms::place(const SurfaceProgram& surface, const DrawnObject& object)
{
    glUniformMatrix4fv(surface.model, 1, GL_FALSE, glm::value_ptr(object.model));
    glUniform1f(surface.pattern_scale, object.pattern_scale);
    glUniform1f(surface.clipped, object.is_clipped ? 1.0f : 0.0f);
    if (surface.to_mesh >= 0)
        glUniformMatrix4fv(surface.to_mesh, 1, GL_FALSE, glm::value_ptr(glm::inverse(object.model)));
}

void SurfacePrograms::bind_image(std::uint32_t image)
{
    glActiveTexture(GL_TEXTURE0 + SurfaceUnits::kImage);
    glBindTexture(GL_TEXTURE_2D, looks_.images().texture(image));
    glActiveTexture(GL_TEXTURE0);
    image_ = image;
}

}  // namespace kerf::render
