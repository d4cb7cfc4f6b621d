layout(location = 0) in vec4 place_size_run;     // world x, y; radius; in radii
layout(location = 1) in vec4 colour_and_opacity;
layout(location = 2) in float stain_shape;

uniform float wall_z;

out vec2 from_middle;  // in radii
out vec2 on_wall;      // world
flat out vec4 base;
flat out float shape;
flat out float run;

const float kReach = 1.75;  // of the farthest droplet, in radii

void main()
{
    base = colour_and_opacity;
    shape = stain_shape;
    run = place_size_run.w;
    float size = place_size_run.z;
    from_middle.x = (gl_VertexID & 1) == 0 ? -kReach : kReach;
    from_middle.y = (gl_VertexID & 2) == 0 ? -kReach - run : kReach;
    on_wall = place_size_run.xy + size * from_middle;
    gl_Position = frame.view_projection * vec4(on_wall, wall_z, 1.0);
}
