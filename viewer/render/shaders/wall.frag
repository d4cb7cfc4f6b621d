in vec3 world_position;
in vec2 wall_uv;

uniform sampler2D relief;
uniform sampler2D grain;
uniform vec3 colour_low;
uniform vec3 colour_high;
uniform float light_radius;  // world units: the lamp lights the middle of the wall

out vec4 colour;

void main()
{
    vec4 baked = texture(relief, wall_uv);
    vec2 slope = 2.0 * baked.xy - 1.0;
    // Twice, turned and in two sizes, so that its repetition is not seen.
    vec2 p = world_position.xy;
    vec3 fine = texture(grain, 0.53 * p).xyz;
    vec3 finer = texture(grain, mat2(0.36, 0.93, -0.93, 0.36) * p * 1.27).xyz;
    slope += 0.85 * (fine.xy - 0.5) + 0.45 * (finer.xy - 0.5);
    float tone = fine.z + 0.6 * (finer.z - 0.5);
    vec3 n = normalize(vec3(-slope, 1.0));
    vec3 albedo = mix(colour_low, colour_high, baked.z) * (0.8 + 0.4 * baked.w) * (0.62 + 0.76 * tone);
    float from_middle = length((world_position.xy - vec2(-0.12, 0.16) * light_radius) / light_radius);
    float pool = 0.24 + 0.76 * exp(-1.05 * from_middle * from_middle);
    float cosine = max(dot(n, frame.to_light.xyz), 0.0);
    vec3 ambient = mix(frame.ground_colour.rgb, frame.sky_colour.rgb, 0.5 + 0.5 * n.y);
    vec3 light = ambient * (0.45 + 0.55 * pool);
    light += frame.light_colour.rgb * pool * cosine * light_at(world_position, vec3(0.0, 0.0, 1.0), 2.0);
    colour = vec4(toned(albedo * light), 1.0);
}
