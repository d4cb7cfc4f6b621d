uniform vec4 wall;  // half width, half height, z, widths of the relief in one world unit

out vec3 world_position;
out vec2 wall_uv;

void main()
{
    vec2 corner = vec2((gl_VertexID & 1) == 0 ? -1.0 : 1.0, (gl_VertexID & 2) == 0 ? -1.0 : 1.0);
    world_position = vec3(corner * wall.xy, wall.z);
    wall_uv = 0.5 + world_position.xy * vec2(1.0, 2.0) * wall.w;
    gl_Position = frame.view_projection * vec4(world_position, 1.0);
}
