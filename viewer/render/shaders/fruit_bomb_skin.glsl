// Black iron with a red band that warns, and a fuse of twisted cord with an ember.
void paint(Look look, Place place, inout Surface s)
{
    vec3 p = place.object;
    float fine = noise(p * 70.0), blotch = cloud(p * 4.0, 3);
    if (p.y > 0.71 && length(p.xz) < 0.6) {
        float twist = sin(60.0 * place.uv.y + 2.0 * kPi * 3.0 * place.uv.x);
        s.albedo = mix(srgb(120.0, 90.0, 52.0), srgb(206.0, 172.0, 116.0), 0.5 + 0.5 * twist) * (0.8 + 0.4 * fine);
        s.height = 0.008 * twist;
        s.roughness = 0.9;
        // The far end burns.
        float burning = smoothstep(0.165, 0.215, p.x + 0.015 * (fine - 0.5));
        s.albedo = mix(s.albedo, srgb(36.0, 26.0, 20.0), smoothstep(0.11, 0.165, p.x));
        s.glow = burning * (vec3(1.5, 0.26, 0.02) + vec3(1.6, 0.75, 0.12) * smoothstep(0.4, 0.8, noise(p * 30.0)));
        return;
    }
    s.albedo = mix(srgb(34.0, 35.0, 40.0), srgb(62.0, 62.0, 68.0), blotch) * (0.8 + 0.4 * fine);
    float band = above(0.0, 0.085 - abs(p.y + 0.02), 0.004 + place.pixel);
    float worn = smoothstep(0.30, 0.42, cloud(p * 11.0 + 3.0, 3));
    s.albedo = mix(s.albedo, mix(srgb(196.0, 22.0, 20.0), srgb(150.0, 12.0, 14.0), blotch), band * worn);
    // Casting marks and dents.
    vec3 dent = cells(p * 6.0);
    s.height = 0.006 * blotch + 0.003 * dent.x + 0.0012 * fine;
    s.roughness = 0.30 + 0.22 * blotch;
    s.reflectance = 0.09;
}
