// A thick iron wall round black powder with grains of sulphur.
void paint(Look look, Place place, inout Surface s)
{
    vec3 p = place.object;
    vec3 grain = cells(p * 26.0);
    float fine = noise(p * 90.0);
    vec3 powder = mix(srgb(96.0, 94.0, 92.0), srgb(140.0, 136.0, 130.0), grain.z) * (0.75 + 0.5 * fine);
    powder = mix(powder, srgb(236.0, 198.0, 66.0), 0.7 * step(0.93, grain.z));
    powder = mix(powder, srgb(214.0, 92.0, 40.0), 0.6 * step(grain.z, 0.04));
    float wall = above(0.52, length(p), 0.003 + place.pixel);
    vec3 iron = mix(srgb(112.0, 114.0, 120.0), srgb(168.0, 170.0, 176.0), noise(vec3(p.y * 90.0, p.x * 6.0, p.z * 6.0)));
    s.albedo = mix(powder, iron, wall);
    s.height = mix(0.010 * (1.0 - grain.x), 0.001 * fine, wall);
    s.roughness = mix(0.9, 0.35, wall);
    s.reflectance = mix(0.03, 0.12, wall);
    if (p.y > 0.742) {
        s.albedo = mix(srgb(120.0, 90.0, 52.0), srgb(206.0, 172.0, 116.0), fine);
        s.reflectance = 0.03;
    }
}
