in vec3 world_position;
in vec3 world_normal;

out vec4 colour;

// The report's own shading: a colour, a light, the cosine between.
void main()
{
    vec3 n = normalize(gl_FrontFacing ? world_normal : -world_normal);
    float cosine = max(dot(n, frame.to_light.xyz), 0.0);
    vec3 ambient = 0.5 * (frame.sky_colour.rgb + frame.ground_colour.rgb);
    vec3 light = ambient + frame.light_colour.rgb * cosine * light_at(world_position, n, 1.2);
    colour = vec4(toned(looks[look_index].colour.rgb * light), 1.0);
}
