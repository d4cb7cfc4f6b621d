in vec3 world_normal;

uniform float batch;

out vec4 surface;

void main()
{
    surface = vec4(gl_FrontFacing ? world_normal : -world_normal, batch);
}
