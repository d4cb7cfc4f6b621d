// Dark and pale stripes from pole to pole, torn at their edges, with a net of veins.
void paint(Look look, Place place, inout Surface s)
{
    vec3 p = place.object;
    float turn = turn_of(p);
    float ragged = cloud(p * vec3(5.0, 5.0, 5.0), 3) - 0.5 + 0.45 * (noise(p * vec3(17.0, 26.0, 17.0)) - 0.5);
    float stripe = abs(fract(turn * 11.0 / (2.0 * kPi) + 0.55 * ragged) - 0.5) * 2.0;
    float pale = smoothstep(0.50, 0.68, stripe + 0.22 * (noise(p * 13.0) - 0.5));
    float vein = 1.0 - smoothstep(0.0, 0.16, cells(p * vec3(9.0, 7.0, 9.0) + 0.5 * ragged).y);
    vec3 dark = mix(srgb(18.0, 62.0, 22.0), srgb(34.0, 88.0, 30.0), noise(p * 7.0));
    vec3 light = mix(srgb(138.0, 176.0, 76.0), srgb(186.0, 204.0, 116.0), noise(p * 9.0 + 4.0));
    light = mix(light, srgb(78.0, 128.0, 46.0), 0.55 * vein);
    dark = mix(dark, srgb(12.0, 44.0, 16.0), 0.6 * vein);
    s.albedo = mix(dark, light, pale);
    // Where it lay on the ground it stayed yellow.
    float ground = smoothstep(0.80, 0.95, dot(normalize(p), normalize(vec3(-0.25, -0.15, -0.96))) + 0.06 * ragged);
    s.albedo = mix(s.albedo, srgb(222.0, 200.0, 120.0), 0.75 * ground);
    s.albedo *= 0.9 + 0.2 * noise(p * 60.0);
    s.height = 0.004 * pale + 0.003 * noise(p * 21.0);
    s.roughness = 0.34 + 0.1 * noise(p * 31.0);
    s.through = srgb(120.0, 190.0, 60.0);
    s.depth = 0.10;
}
