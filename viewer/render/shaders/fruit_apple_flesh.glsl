float apple_outline(float polar, float turn)
{
    float down = 0.5 - 0.5 * cos(polar);
    float humps = 0.022 * cos(5.0 * turn) * down * down * sin(polar);
    return 0.64 * (1.0 + 0.06 * cos(polar) + humps - 0.50 * bell(polar, 0.42) - 0.20 * bell(kPi - polar, 0.30));
}

// Five chambers with papery walls stand round the axis like a star; each holds two pips, tips up.
void paint(Look look, Place place, inout Surface s)
{
    vec3 p = place.object;
    float polar = polar_of(p), turn = turn_of(p), rho = length(p.xz);
    float t = length(p) / apple_outline(polar, turn);
    float climb = max(p.y - 0.39, 0.0) / 0.31;
    if (p.y > 0.30 && length(p.xz - vec2(0.088, 0.02) * climb * climb) < 0.042 && (t > 1.03 || rho < 0.016)) {
        woody(p, s);
        return;
    }
    vec3 side = vec3(cos(turn), 0.0, -sin(turn));
    float lump = cloud(p * 5.0, 2) - 0.5;
    vec3 grain = cells(p * 34.0);
    float fine = noise(p * 110.0);
    // Cream, greener under the skin.
    vec3 flesh = mix(srgb(252.0, 240.0, 196.0), srgb(244.0, 230.0, 168.0), smoothstep(0.3, 0.9, t + 0.4 * lump));
    flesh = mix(flesh, srgb(222.0, 222.0, 140.0), smoothstep(0.86, 0.985, t));
    flesh *= 0.93 + 0.08 * grain.z + 0.06 * fine;
    flesh = mix(flesh, srgb(255.0, 250.0, 226.0), 0.25 * (1.0 - smoothstep(0.0, 0.12, grain.y)));
    // The core line: ten strands on a heart round the chambers.
    float core = length(vec2(rho / 0.285, (p.y + 0.02) / (0.30 + 0.06 * smoothstep(0.0, 0.3, p.y))));
    float line = bell(core - 1.0 - 0.06 * lump, 0.035);
    float strand = pow(0.5 + 0.5 * cos(10.0 * turn), 3.0);
    flesh = mix(flesh, srgb(188.0, 190.0, 96.0), line * (0.25 + 0.45 * strand) * smoothstep(0.2, 0.6, noise(p * 9.0)));
    flesh = mix(flesh, srgb(240.0, 234.0, 182.0), 0.5 * (1.0 - smoothstep(0.8, 1.0, core)));
    // It browns from the edge of the core and under the skin.
    float brown = 0.28 * smoothstep(0.35, 0.8, cloud(p * 7.0 + 9.0, 2)) * (bell(t - 0.95, 0.10) + bell(core - 0.75, 0.25));
    flesh = mix(flesh, srgb(204.0, 150.0, 74.0), brown);
    s.albedo = flesh;
    s.height = 0.0016 * grain.x + 0.0012 * fine;
    s.roughness = 0.48;
    s.through = srgb(255.0, 226.0, 130.0);
    s.depth = 0.30;
    s.wet = 0.75;

    // A chamber in its own frame: x outwards, y up, z across.
    float fifth = (fract(turn * 5.0 / (2.0 * kPi) + 0.5) - 0.5) * 2.0 * kPi / 5.0;
    vec3 c = vec3(rho * cos(fifth), p.y + 0.015, rho * sin(fifth));
    vec3 from_middle = vec3((c.x - 0.105) / 0.085, c.y / 0.145, c.z / (0.030 + 0.10 * max(c.x - 0.05, 0.0)));
    float chamber = length(from_middle * vec3(1.0, 1.0, 1.0 + 0.5 * max(from_middle.x, 0.0)));
    float soft = 0.03 + 10.0 * place.pixel;
    float hollow = 1.0 - above(1.0, chamber, soft);
    float wall = bell(chamber - 1.08, 0.10 + 8.0 * place.pixel);
    s.albedo = mix(s.albedo, srgb(206.0, 176.0, 98.0), 0.7 * wall);
    vec3 papery = mix(srgb(120.0, 84.0, 40.0), srgb(196.0, 158.0, 90.0), smoothstep(0.1, 1.0, chamber));
    s.albedo = mix(s.albedo, papery, hollow);
    s.height = mix(s.height, -0.03 * (1.0 - chamber * chamber), hollow);
    s.wet *= 1.0 - hollow;
    s.depth *= 1.0 - 0.7 * hollow;
    // Two pips in each chamber.
    float index = floor(turn * 5.0 / (2.0 * kPi) + 0.5);
    for (int k = 0; k < 2; ++k) {
        vec3 random = lattice_point(ivec3(int(mod(index, 5.0)), k, 3));
        vec3 d = c - vec3(0.108 + 0.02 * (random.x - 0.5), (k == 0 ? 0.035 : -0.05) + 0.02 * (random.y - 0.5),
                          0.012 * (random.z - 0.5));
        float taper = mix(1.0, 0.45, smoothstep(-0.1, 1.0, d.y / 0.062));
        float r = length(vec3(d.x / (0.036 * taper), d.y / 0.066, d.z / (0.024 * taper)));
        float pip = 1.0 - above(1.0, r, 0.08 + 14.0 * place.pixel);
        float bulge = sqrt(max(1.0 - r * r, 0.0));
        s.albedo = mix(s.albedo, mix(srgb(48.0, 22.0, 10.0), srgb(112.0, 58.0, 26.0), bulge), pip);
        s.height = mix(s.height, 0.02 * bulge * bulge, pip);
        s.roughness = mix(s.roughness, 0.25, pip);
    }
    // The tube from the calyx.
    float tube = (1.0 - smoothstep(0.012, 0.022, rho)) * (1.0 - smoothstep(-0.25, -0.12, p.y));
    s.albedo = mix(s.albedo, srgb(120.0, 92.0, 46.0), 0.8 * tube);
    // The skin, seen on edge.
    float skin = above(0.978, t, 0.004 + place.pixel);
    s.albedo = mix(s.albedo, srgb(176.0, 24.0, 30.0), skin);
    s.depth *= 1.0 - 0.6 * skin;
}
