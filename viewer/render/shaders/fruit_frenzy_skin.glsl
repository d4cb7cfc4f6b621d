// Flames from the flower's end to the stalk, which glow.
void paint(Look look, Place place, inout Surface s)
{
    vec3 p = place.object;
    Bend b = along_banana(p);
    vec3 q = vec3(cos(b.turn) * 1.3, sin(b.turn) * 1.3, 2.6 * b.share);
    float tongue = cloud(q * 1.6 + 1.4 * vec3(noise(q * 2.0), noise(q * 2.0 + 5.0), 0.0), 3);
    float heat = clamp(1.25 * tongue + 0.35 * sin(5.0 * b.turn + 6.0 * noise(q * 1.3)) * 0.5 - 0.28 * b.share - 0.08, 0.0, 1.0);
    vec3 fire = mix(srgb(110.0, 8.0, 6.0), srgb(226.0, 44.0, 8.0), smoothstep(0.15, 0.45, heat));
    fire = mix(fire, srgb(255.0, 150.0, 16.0), smoothstep(0.42, 0.62, heat));
    fire = mix(fire, srgb(255.0, 232.0, 110.0), smoothstep(0.62, 0.85, heat));
    s.albedo = fire;
    float ends = max(smoothstep(0.955, 0.985, b.share), smoothstep(-0.93, -0.975, b.share));
    s.albedo = mix(s.albedo, srgb(40.0, 12.0, 8.0), ends);
    s.height = 0.010 * heat;
    s.roughness = 0.4;
    s.through = srgb(255.0, 110.0, 20.0);
    s.depth = 0.4;
    s.glow = (1.0 - ends) * fire * (0.15 + 1.1 * smoothstep(0.4, 0.9, heat));
}
