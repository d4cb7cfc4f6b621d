in vec3 world_normal;

uniform float batch;

out vec4 surface;

void main()
{
    // As long as the mesh's unit is in metres: half a float has neither micrometres nor megametres.
    vec3 normal = normalize(world_normal);
    surface = vec4(gl_FrontFacing ? normal : -normal, batch);
}
