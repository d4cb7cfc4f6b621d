// Black seeds on radii, thick towards the rind. Their places are a lattice over turn and height, which every plane
// cuts alike.
float seeds(vec3 u, out vec3 colour, out float rise, float pixel)
{
    const float kColumns = 18.0, kRows = 14.0;
    float t = length(u);
    vec2 at = vec2(turn_of(u) * kColumns / (2.0 * kPi), (u.y / max(t, 1e-4) * 0.5 + 0.5) * kRows);
    float found = 0.0;
    colour = vec3(0.0);
    rise = 0.0;
    for (int shell = 0; shell < 2; ++shell)
        for (int row = -1; row <= 1; ++row)
            for (int column = -1; column <= 1; ++column) {
                ivec2 cell = ivec2(floor(at)) + ivec2(column, row);
                int wrapped = int(mod(float(cell.x), kColumns));
                vec3 random = lattice_point(ivec3(wrapped, cell.y, shell + 7));
                vec3 more = lattice_point(ivec3(wrapped, cell.y, shell + 19));
                if (more.x > (shell == 0 ? 0.92 : 0.5) || cell.y < 1 || float(cell.y) > kRows - 2.0) continue;
                float lon = (float(wrapped) + 0.5 + 0.5 * (random.x - 0.5)) * 2.0 * kPi / kColumns;
                float sine = ((float(cell.y) + 0.5 + 0.6 * (random.y - 0.5)) / kRows) * 2.0 - 1.0;
                float cosine = sqrt(1.0 - sine * sine);
                float radius = shell == 0 ? 0.60 + 0.13 * random.z : 0.36 + 0.14 * random.z;
                vec3 out_ = vec3(cosine * cos(lon), sine, -cosine * sin(lon));
                vec3 side = normalize(cross(out_, vec3(0.0, 1.0, 0.0)));
                vec3 lift = cross(side, out_);
                float roll = more.y * kPi;
                vec3 flat_ = cos(roll) * side + sin(roll) * lift, wide = cross(flat_, out_);
                vec3 d = u - radius * out_;
                float along = dot(d, out_) / 0.068;
                // A drop: the tip points to the middle.
                float taper = mix(0.55, 1.0, smoothstep(-1.0, 0.3, along));
                float r = length(vec3(along, dot(d, wide) / (0.043 * taper), dot(d, flat_) / (0.026 * taper)));
                float inside = 1.0 - above(1.0, r, 0.10 + pixel * 20.0);
                if (inside > found) {
                    found = inside;
                    float bulge = sqrt(max(1.0 - r * r, 0.0));
                    vec3 brown = mix(srgb(52.0, 26.0, 14.0), srgb(20.0, 10.0, 8.0), smoothstep(0.2, 0.8, bulge));
                    colour = brown;
                    rise = bulge;
                }
            }
    return found;
}

void paint(Look look, Place place, inout Surface s)
{
    vec3 p = place.object;
    vec3 u = p / vec3(0.80, 0.98, 0.80);
    float t = length(u);
    if (t > 1.02 && length(p.xz) < 0.12) {
        woody(p, s);
        return;
    }
    vec3 radial = u / max(t, 1e-4);
    float lump = cloud(p * 4.0, 2) - 0.5;
    float rim = t + 0.016 * lump;
    // Watery crystals in strands that run outwards.
    float strand = noise(radial * 13.0 + vec3(0.0, 0.0, 3.0 * t)) * 0.6 + 0.4 * noise(radial * 29.0 + 2.0 * t);
    vec3 grain = cells(p * 30.0 + 1.5 * lump);
    float fine = noise(p * 120.0);
    vec3 red = mix(srgb(206.0, 22.0, 32.0), srgb(238.0, 58.0, 52.0), smoothstep(0.1, 0.8, t + 0.5 * lump));
    red = mix(red, srgb(250.0, 108.0, 90.0), 0.42 * smoothstep(0.45, 0.85, strand) * smoothstep(0.12, 0.5, t));
    red *= 0.78 + 0.24 * grain.z + 0.16 * fine;
    red = mix(red, srgb(255.0, 130.0, 112.0), 0.22 * (1.0 - smoothstep(0.0, 0.10, grain.y)));
    // Three seams where the fruit's chambers meet, paler and a little hollow.
    float third = abs(fract(turn_of(p) * 3.0 / (2.0 * kPi) + 0.1 * lump) - 0.5);
    float seam = (1.0 - smoothstep(0.0, 0.028, (0.5 - third) * length(u.xz))) * (1.0 - smoothstep(0.45, 0.6, t));
    red = mix(red, srgb(246.0, 120.0, 100.0), 0.45 * seam);
    s.albedo = red;
    float rind = smoothstep(0.835, 0.90, rim);
    s.albedo = mix(s.albedo, srgb(248.0, 150.0, 120.0), smoothstep(0.80, 0.86, rim));
    s.albedo = mix(s.albedo, srgb(244.0, 240.0, 200.0), smoothstep(0.85, 0.895, rim));
    s.albedo = mix(s.albedo, srgb(190.0, 214.0, 120.0), smoothstep(0.90, 0.955, rim));
    s.albedo = mix(s.albedo, srgb(36.0, 92.0, 30.0), above(0.972, rim, 0.006));
    s.height = 0.0025 * grain.x * (1.0 - rind) - 0.004 * seam + 0.001 * fine * (1.0 - rind);
    s.roughness = mix(0.42, 0.5, rind);
    s.through = mix(srgb(255.0, 70.0, 50.0), srgb(220.0, 235.0, 150.0), rind);
    s.depth = 0.32;
    s.wet = mix(1.0, 0.4, rind);

    vec3 seed_colour;
    float rise;
    float seed = seeds(u, seed_colour, rise, place.pixel) * (1.0 - rind);
    // The flesh is darker where a seed dents it.
    s.albedo = mix(s.albedo, seed_colour, seed);
    s.height = mix(s.height, 0.022 * rise, seed);
    s.roughness = mix(s.roughness, 0.22, seed);
    s.depth *= 1.0 - seed;
}
