layout(location = 0) in vec3 position;

uniform mat4 shadow_projection;
uniform vec4 clip;      // 0 of what is not clipped

void main()
{
    vec4 world = model_matrix() * vec4(position, 1.0);
    gl_Position = shadow_projection * world;
    gl_ClipDistance[0] = dot(clip, world);
}
