float coconut_outline(float polar, float turn)
{
    float ridge = 0.012 * cos(3.0 * turn) * sin(polar);
    return 0.66 * (1.0 + 0.05 * cos(polar) * cos(polar) + 0.04 * bell(polar, 0.5) + ridge);
}

// Husk, shell, a brown skin, white meat; the same from the hollow, where milk makes it shine.
void paint(Look look, Place place, inout Surface s)
{
    vec3 p = place.object;
    float turn = turn_of(p);
    float t = length(p) / coconut_outline(polar_of(p), turn);
    vec3 radial = normalize(p);
    float lump = cloud(p * 4.0, 2) - 0.5;
    float strand = noise(radial * 34.0 + 2.0 * t), fine = noise(p * 90.0);
    vec3 grain = cells(vec3(radial * 22.0) + 0.6 * t);
    vec3 meat = mix(srgb(255.0, 252.0, 242.0), srgb(236.0, 230.0, 212.0), 0.6 * strand + 0.25 * fine);
    meat *= 0.90 + 0.14 * noise(p * 17.0);
    meat = mix(meat, srgb(222.0, 206.0, 172.0), 0.45 * (1.0 - smoothstep(0.0, 0.10, grain.y)));
    meat = mix(meat, srgb(206.0, 216.0, 222.0), 0.5 * smoothstep(0.765, 0.70, t));
    meat = mix(meat, srgb(240.0, 214.0, 172.0), 0.6 * smoothstep(0.84, 0.895, t + 0.01 * lump));
    float rim = t + 0.008 * lump;
    vec3 husk = mix(srgb(92.0, 58.0, 32.0), srgb(158.0, 112.0, 66.0), noise(vec3(radial * 30.0 + 9.0 * t)));
    husk *= 0.75 + 0.5 * noise(p * vec3(60.0));
    vec3 shell = mix(srgb(44.0, 26.0, 16.0), srgb(82.0, 50.0, 30.0), fine);
    float soft = 0.004 + 1.5 * place.pixel;
    s.albedo = meat;
    s.albedo = mix(s.albedo, srgb(122.0, 72.0, 38.0), above(0.892, rim, soft));
    s.albedo = mix(s.albedo, shell, above(0.908, rim, soft));
    s.albedo = mix(s.albedo, husk, above(0.948, rim + 0.006 * strand, soft));
    float dry = above(0.892, rim, soft);
    s.height = mix(0.0015 * fine + 0.001 * strand, 0.006 * noise(p * 70.0), dry);
    s.roughness = mix(0.42, 0.85, dry);
    s.through = srgb(255.0, 244.0, 222.0);
    s.depth = mix(0.30, 0.0, dry);
    s.wet = mix(0.7, 0.0, dry);
    if (!place.is_cap) {
        // Light that reaches the bottom of the hollow has been on its walls.
        s.albedo = mix(s.albedo, srgb(216.0, 204.0, 178.0), 0.6) * (0.88 + 0.12 * cloud(p * 7.0, 3));
        s.height = 0.004 * cloud(p * 9.0, 2);
        s.wet = 1.0;
        s.roughness = 0.3;
    }
}
