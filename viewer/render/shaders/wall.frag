in vec3 world_position;
in vec2 wall_uv;

uniform sampler2D relief;
uniform vec3 colour_low;
uniform vec3 colour_high;
uniform float light_radius;  // world units: the lamp lights the middle of the wall

out vec4 colour;

void main()
{
    vec4 baked = texture(relief, wall_uv);
    vec2 slope = 2.0 * baked.xy - 1.0;
    vec3 n = normalize(vec3(-slope, 1.0));
    vec3 albedo = mix(colour_low, colour_high, baked.z) * (0.8 + 0.4 * baked.w);
    float from_middle = length((world_position.xy - vec2(-0.12, 0.16) * light_radius) / light_radius);
    float pool = 0.24 + 0.76 * exp(-1.05 * from_middle * from_middle);
    float cosine = max(dot(n, frame.to_light.xyz), 0.0);
    vec3 ambient = mix(frame.ground_colour.rgb, frame.sky_colour.rgb, 0.5 + 0.5 * n.y);
    vec3 light = ambient * (0.45 + 0.55 * pool);
    light += frame.light_colour.rgb * pool * cosine * light_at(world_position, vec3(0.0, 0.0, 1.0), 2.0);
    colour = vec4(toned(albedo * light), 1.0);
}
