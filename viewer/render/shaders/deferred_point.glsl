// The point is where the geometry buffer says. Of a pixel's samples those that show one place of the batch are shaded
// together: first the nearest place, then, where an outline of the batch lies before the batch itself, what is behind.
uniform sampler2DMS geometry;
uniform sampler2DMS geometry_depth;
uniform float batch;      // its number
uniform mat4 to_mesh;     // world to mesh coordinates
uniform bool is_behind;   // shade what is behind the nearest place

const float kNothing = 1.0;   // depth where nothing is
const float kOutline = 16.0;  // what is further apart than so many pixels' sides is not one place

// From pixels of the picture and depth.
vec4 projected_back(vec2 place, float depth)
{
    return frame.to_world * vec4(2.0 * vec3(place / frame.viewport.xy, depth) - 1.0, 1.0);
}

vec3 world_at(vec2 place, float depth)
{
    vec4 world = projected_back(place, depth);
    return world.xyz / world.w;
}

// In the direction of the view.
float distance_at(vec2 place, float depth)
{
    return 1.0 / projected_back(place, depth).w;
}

float depth_of(ivec2 pixel, int i)
{
    bool is_mine = texelFetch(geometry, pixel, i).w == batch;
    return is_mine ? texelFetch(geometry_depth, pixel, i).x : kNothing;
}

// Where a pixel's ray meets the plane through a point.
vec3 on_plane(vec2 place, float depth, vec3 point, vec3 n)
{
    vec3 ray = world_at(place, depth) - frame.eye.xyz;
    return frame.eye.xyz + ray * (dot(point - frame.eye.xyz, n) / dot(ray, n));
}

// The pixel's samples to shade.
struct Samples
{
    int mask;
    float depth;  // their mean
    vec3 normal;  // of no certain length
};

Samples samples_of(vec2 place)
{
    ivec2 pixel = ivec2(place);
    int count = int(frame.picture.z);
    float nearest = kNothing;
    for (int i = 0; i < count; ++i) nearest = min(nearest, depth_of(pixel, i));
    float side = length(world_at(place + vec2(1.0, 0.0), nearest) - world_at(place, nearest));
    float edge = distance_at(place, nearest) + kOutline * side;
    Samples samples = Samples(0, 0.0, vec3(0.0));
    float found = 0.0;
    for (int i = 0; i < count; ++i) {
        float depth = depth_of(pixel, i);
        if (depth == kNothing || (distance_at(place, depth) > edge) != is_behind) continue;
        samples.mask |= 1 << i;
        samples.normal += texelFetch(geometry, pixel, i).xyz;
        samples.depth += depth;
        found += 1.0;
    }
    samples.depth /= max(found, 1.0);
    return samples;
}

SurfacePoint point_of(vec2 place, Samples samples)
{
    vec3 world = world_at(place, samples.depth), n = normalize(samples.normal);
    // A plane seen edge on has no size: it is taken for one that leans a little.
    vec3 v = normalize(frame.eye.xyz - world);
    vec3 plane = n + max(0.1 - dot(n, v), 0.0) * v;
    vec3 dx = on_plane(place + vec2(1.0, 0.0), samples.depth, world, plane) - world;
    vec3 dy = on_plane(place + vec2(0.0, 1.0), samples.depth, world, plane) - world;
    vec3 mesh = (to_mesh * vec4(world, 1.0)).xyz;
    return SurfacePoint(world, dx, dy, n, mesh, mat3(to_mesh) * dx, mat3(to_mesh) * dy, pattern_scale * mesh,
                        vec2(0.0));
}

// What is shaded here has no relief but slopes that are worked out: a neighbour may be another surface.
vec2 steps_of(float value)
{
    return vec2(0.0);
}
