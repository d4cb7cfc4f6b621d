// Gold, hammered, with pairs of violet bands for the points that count twice.
void paint(Look look, Place place, inout Surface s)
{
    vec3 p = place.object;
    Bend b = along_banana(p);
    vec3 dent = cells(p * 9.0);
    float brushed = noise(vec3(b.across * 12.0, b.share * 90.0));
    s.albedo = mix(srgb(250.0, 186.0, 60.0), srgb(255.0, 214.0, 104.0), 0.5 * brushed + 0.3 * dent.z);
    float pair = abs(mod(b.share + 0.25, 0.5) - 0.25);
    float band = bell(pair - 0.055, 0.036);
    float mark = smoothstep(0.35, 0.5, band);
    s.albedo = mix(s.albedo, srgb(116.0, 34.0, 190.0), mark);
    float ends = max(smoothstep(0.955, 0.985, b.share), smoothstep(-0.93, -0.975, b.share));
    s.albedo = mix(s.albedo, srgb(150.0, 92.0, 24.0), ends);
    s.height = 0.006 * dent.x * dent.x + 0.004 * mark;
    s.roughness = 0.24 + 0.12 * brushed;
    s.reflectance = mix(0.8, 0.06, mark);
    s.through = srgb(255.0, 190.0, 60.0);
    s.depth = 0.25;
    s.glow = 0.06 * s.albedo + 0.7 * smoothstep(0.88, 0.97, noise(p * 60.0)) * srgb(255.0, 240.0, 180.0);
}
