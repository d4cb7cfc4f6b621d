layout(location = 0) in vec3 position;

uniform mat4 model;
uniform float clipped;  // 1, or 0: there are drivers that clip whether it is enabled or not

invariant gl_Position;

void main()
{
    vec4 world = model * vec4(position, 1.0);
    gl_Position = frame.view_projection * world;
    gl_ClipDistance[0] = clipped * dot(frame.clip, world);
}
