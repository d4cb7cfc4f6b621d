// Ice with cracks inside and rime on the ribs.
void paint(Look look, Place place, inout Surface s)
{
    vec3 p = place.object;
    Bend b = along_banana(p);
    vec3 crack = cells(p * 7.0 + 0.6 * (cloud(p * 6.0, 2) - 0.5));
    vec3 fine = cells(p * 17.0);
    float line = 1.0 - smoothstep(0.0, 0.05, crack.y);
    float hair = 1.0 - smoothstep(0.0, 0.05, fine.y);
    float deep = cloud(p * 5.0, 3);
    s.albedo = mix(srgb(40.0, 128.0, 214.0), srgb(150.0, 214.0, 250.0), smoothstep(0.25, 0.75, deep + 0.25 * (crack.z - 0.5)));
    s.albedo = mix(s.albedo, srgb(238.0, 250.0, 255.0), 0.8 * line + 0.25 * hair * (1.0 - line));
    float rib = 0.5 + 0.5 * cos(5.0 * b.turn);
    float rime = smoothstep(0.50, 0.85, 0.55 * rib + 0.6 * noise(p * 30.0) + 0.25 * abs(b.share) - 0.1);
    s.albedo = mix(s.albedo, srgb(246.0, 252.0, 255.0), 0.85 * rime);
    float sparkle = smoothstep(0.86, 0.97, noise(p * 75.0));
    s.height = 0.006 * crack.x + 0.004 * rime * noise(p * 70.0) - 0.004 * line;
    s.roughness = mix(0.14, 0.6, rime);
    s.through = srgb(90.0, 190.0, 255.0);
    s.depth = 0.5;
    s.wet = 0.6 * (1.0 - rime);
    s.glow = vec3(0.01, 0.05, 0.10) + 0.8 * sparkle * vec3(0.7, 0.9, 1.0);
}
