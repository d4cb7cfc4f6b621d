// The point is on the triangle that is being drawn.
in vec3 world_position;
in vec3 world_normal;
in vec3 pattern_position;
in vec2 pattern_uv;

SurfacePoint surface_point()
{
    vec3 mesh = pattern_position / pattern_scale;
    return SurfacePoint(world_position, dFdx(world_position), dFdy(world_position),
                        normalize(gl_FrontFacing ? world_normal : -world_normal), mesh, dFdx(mesh), dFdy(mesh),
                        pattern_position, pattern_uv);
}

// How a value differs from that of the pixel on the right and the one above.
vec2 steps_of(float value)
{
    return vec2(dFdx(value), dFdy(value));
}
