layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 uv;

uniform float clipped;  // 1, or 0: there are drivers that clip whether it is enabled or not
uniform float pattern_scale;  // object units to pattern units

invariant gl_Position;

out vec3 world_position;
out vec3 world_normal;
out vec3 pattern_position;
out vec2 pattern_uv;

void main()
{
    mat4 model = model_matrix();
    vec4 world = model * vec4(position, 1.0);
    world_position = world.xyz;
    // Objects are turned, moved and scaled alike in all directions: normals turn with them.
    world_normal = mat3(model) * normal;
    pattern_position = position * pattern_scale;
    pattern_uv = uv;
    gl_Position = frame.view_projection * world;
    gl_ClipDistance[0] = clipped * dot(frame.clip, world);
}
