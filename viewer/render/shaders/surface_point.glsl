// The point of a surface that a pixel shows, wherever it is known from.
struct SurfacePoint
{
    vec3 world;
    vec3 world_dx, world_dy;    // to the pixel on the right, to the one above
    vec3 normal;                // world, unit, towards the eye
    vec3 mesh;                  // mesh coordinates
    vec3 mesh_dx, mesh_dy;
    vec3 pattern;               // the same as shares of the object's size
    vec2 uv;
};
