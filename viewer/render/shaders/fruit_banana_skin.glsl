// Yellow, greener towards the stalk, with bruised ribs, freckles and a black flower's end.
void paint(Look look, Place place, inout Surface s)
{
    vec3 p = place.object;
    Bend b = along_banana(p);
    float rib = 0.5 + 0.5 * cos(5.0 * b.turn);
    float blotch = cloud(p * 4.0, 3), fine = noise(p * 44.0);
    vec3 yellow = mix(srgb(250.0, 208.0, 44.0), srgb(240.0, 184.0, 24.0), blotch);
    float green = smoothstep(0.35, 0.95, b.share + 0.2 * (blotch - 0.5)) + 0.5 * smoothstep(-0.72, -0.95, b.share);
    s.albedo = mix(yellow, srgb(172.0, 184.0, 52.0), 0.75 * clamp(green, 0.0, 1.0));
    // Ribs are bruised first.
    float bruise = smoothstep(0.86, 1.0, rib) * smoothstep(0.40, 0.72, noise(p * vec3(9.0, 9.0, 30.0)));
    s.albedo = mix(s.albedo, srgb(134.0, 84.0, 26.0), 0.55 * bruise);
    vec3 spots = cells(p * vec3(13.0));
    float freckle = (1.0 - above(0.05 + 0.16 * spots.z * spots.z, spots.x, 0.03)) * step(0.45, spots.z);
    s.albedo = mix(s.albedo, srgb(110.0, 64.0, 20.0), 0.8 * freckle);
    vec3 specks = cells(p * vec3(34.0) + 3.0);
    s.albedo = mix(s.albedo, srgb(150.0, 96.0, 30.0), 0.5 * (1.0 - above(0.12, specks.x, 0.05)) * step(0.7, specks.z));
    s.albedo *= 0.94 + 0.1 * fine;
    float ends = max(smoothstep(0.955, 0.985, b.share + 0.02 * blotch), smoothstep(-0.93, -0.975, b.share - 0.03 * blotch));
    s.albedo = mix(s.albedo, srgb(46.0, 32.0, 20.0), ends);
    s.height = 0.0016 * fine - 0.002 * freckle + 0.004 * cloud(p * 8.0, 2);
    s.roughness = mix(0.44 + 0.1 * blotch, 0.9, ends);
    s.through = srgb(255.0, 214.0, 70.0);
    s.depth = 0.2;
}
