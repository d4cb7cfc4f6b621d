layout(location = 0) in vec3 position;

uniform mat4 model;
uniform mat4 shadow_projection;

void main()
{
    gl_Position = shadow_projection * (model * vec4(position, 1.0));
}
