// The handle is a magic banana inside, the head cast steel around a core that glows.
void paint(Look look, Place place, inout Surface s)
{
    vec3 p = place.object;
    Head h = in_head(p);
    if (h.is_head) {
        float fine = noise(p * 120.0), blotch = cloud(p * 9.0, 3);
        vec3 grain = cells(p * 30.0);
        vec3 iron = mix(srgb(132.0, 140.0, 150.0), srgb(196.0, 202.0, 210.0), 0.5 * grain.z + 0.5 * fine);
        // Hardened from outside: a bright case, darker inside.
        iron = mix(srgb(226.0, 232.0, 238.0), iron, smoothstep(0.015, 0.05, h.depth + 0.01 * blotch));
        float core = smoothstep(0.075, 0.125, h.depth + 0.05 * (blotch - 0.5));
        s.albedo = mix(iron, srgb(120.0, 214.0, 90.0), core);
        s.glow = core * vec3(0.10, 0.42, 0.08) * (0.5 + fine);
        s.height = 0.002 * grain.x;
        s.roughness = 0.5;
        s.through = srgb(200.0, 220.0, 210.0);
        s.depth = 0.2;
        return;
    }
    vec3 cream = mix(look.colour.rgb, vec3(1.0), 0.12);
    banana_flesh(p, place.pixel, cream, look.second.rgb, mix(look.second.rgb, cream, 0.5), look.third.rgb, s);
    float sparkle = smoothstep(0.80, 0.95, noise(p * 42.0)) * smoothstep(0.5, 0.9, noise(p * 17.0));
    s.glow = 0.10 * look.colour.rgb + 0.5 * sparkle * mix(look.colour.rgb, vec3(1.0), 0.5);
    s.roughness = look.finish.x;
    s.through = look.second.rgb;
    s.depth = 0.5;
    s.wet = 0.8;
}
