layout(location = 0) in vec4 place_size_run;     // world x, y; radius; in radii
layout(location = 1) in vec4 colour_and_opacity;
layout(location = 2) in vec2 shape_and_wet;

uniform float wall_z;
uniform float reach;   // of the splat shapes, in radii
uniform float shapes;  // how many there are

out vec2 from_middle;  // in radii
out vec2 on_wall;      // world
flat out vec4 base;
flat out float wet;
flat out float run;
flat out float layer;
flat out vec2 turn;    // cosine, sine; the shape is mirrored where `mirror` is -1
flat out float mirror;
flat out vec4 drip_x;  // in radii from the middle
flat out vec4 drip_width;
flat out vec4 drip_length;

vec4 dice4(float seed)
{
    return vec4(noise(vec3(seed, 0.5, 1.5)), noise(vec3(seed, 3.5, 7.5)), noise(vec3(seed, 9.5, 2.5)),
                noise(vec3(seed, 5.5, 4.5)));
}

void main()
{
    base = colour_and_opacity;
    wet = shape_and_wet.y;
    run = place_size_run.w;
    float which = shape_and_wet.x * shapes;
    layer = min(floor(which), shapes - 1.0);
    float angle = 6.2831853 * 7.0 * fract(which);
    turn = vec2(cos(angle), sin(angle));
    mirror = fract(which * 2.0) < 0.5 ? 1.0 : -1.0;
    float seed = 97.0 * shape_and_wet.x;
    drip_x = vec4(-0.30, -0.11, 0.09, 0.27) + 0.22 * (dice4(seed) - 0.5);
    drip_width = 0.016 + 0.032 * dice4(seed + 17.3);
    // Most drips stay short; one or two run.
    vec4 share = dice4(seed + 41.7);
    drip_length = 0.1 + 1.6 * share * share * share;

    float size = place_size_run.z;
    from_middle.x = (gl_VertexID & 1) == 0 ? -reach : reach;
    from_middle.y = (gl_VertexID & 2) == 0 ? -max(reach, 0.7 + run) : reach;
    on_wall = place_size_run.xy + size * from_middle;
    gl_Position = frame.view_projection * vec4(on_wall, wall_z, 1.0);
}
