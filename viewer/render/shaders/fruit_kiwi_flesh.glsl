float kiwi_outline(float polar, float turn)
{
    float oval = 0.45 * (1.0 + 0.045 * cos(2.0 * turn));
    return superellipse(polar, oval, 0.56, 2.25) + 0.012 * bell(polar, 0.10) + 0.012 * bell(kPi - polar, 0.10);
}

// A cream spindle on the axis, rays from it, black seeds between the rays, paler green under the skin.
void paint(Look look, Place place, inout Surface s)
{
    vec3 p = place.object;
    float turn = turn_of(p), rho = length(p.xz);
    float t = length(p) / kiwi_outline(polar_of(p), turn);
    float lump = cloud(p * 6.0, 2) - 0.5;
    // Shares of the way from the axis to the skin at this height.
    float reach = 0.45 * (1.0 + 0.045 * cos(2.0 * turn)) * sqrt(max(1.0 - p.y * p.y / (0.56 * 0.56), 1e-3));
    float q = rho / max(reach, 0.05);
    float spindle = length(vec2(rho / (0.092 + 0.016 * cos(2.0 * turn)), p.y / 0.43));
    float field = length(vec2(rho / 0.315, p.y / 0.45));
    const float kRays = 34.0;
    float wave = turn * kRays / (2.0 * kPi) + 0.5 * noise(p * 7.0) + 0.25 * sin(turn * 5.0);
    float ray = pow(0.5 + 0.5 * cos(2.0 * kPi * wave), 2.0);
    float fibre = noise(vec3(cos(turn) * 36.0, p.y * 16.0 + 3.0 * q, sin(turn) * 36.0));
    vec3 dark = mix(srgb(72.0, 128.0, 12.0), srgb(104.0, 160.0, 22.0), fibre);
    vec3 flesh = mix(dark, srgb(176.0, 208.0, 72.0), 0.75 * ray * smoothstep(1.0, 1.6, spindle));
    vec3 outer = mix(srgb(134.0, 182.0, 44.0), srgb(164.0, 204.0, 76.0), noise(p * vec3(22.0, 12.0, 22.0)));
    outer = mix(outer, srgb(120.0, 172.0, 36.0), 0.5 * smoothstep(0.4, 0.8, fibre));
    flesh = mix(flesh, outer, smoothstep(0.88, 1.12, field + 0.10 * lump + 0.05 * ray));
    flesh = mix(flesh, srgb(206.0, 222.0, 128.0), 0.5 * bell(t - 0.90, 0.045));
    // The spindle frays into the rays.
    float cream = 1.0 - smoothstep(0.86, 1.16, spindle + 0.10 * lump - 0.16 * ray);
    vec3 white = mix(srgb(238.0, 236.0, 186.0), srgb(222.0, 226.0, 160.0), fibre);
    flesh = mix(flesh, srgb(206.0, 224.0, 120.0), 0.55 * bell(spindle - 1.25, 0.35) );
    s.albedo = mix(flesh, white, cream);
    vec3 grain = cells(p * 42.0);
    s.albedo *= 0.88 + 0.16 * grain.z;
    s.height = 0.003 * grain.x + 0.004 * ray * (1.0 - cream);
    s.roughness = 0.36;
    s.through = mix(srgb(170.0, 230.0, 40.0), srgb(250.0, 246.0, 190.0), cream);
    s.depth = 0.42;
    s.wet = 1.0;

    // Seeds sit between the rays, two or three deep, in rows along the axis.
    const float kRows = 21.0;
    float seed = 0.0, rise = 0.0;
    vec2 at = vec2(turn * kRays / (2.0 * kPi), (p.y / 0.46 * 0.5 + 0.5) * kRows);
    for (int row = -1; row <= 1; ++row)
        for (int column = -1; column <= 1; ++column)
            for (int layer = 0; layer < 2; ++layer) {
                ivec2 cell = ivec2(floor(at)) + ivec2(column, row);
                int wrapped = int(mod(float(cell.x), kRays));
                vec3 random = lattice_point(ivec3(wrapped, cell.y, 31 + layer));
                if (random.z > (layer == 0 ? 0.80 : 0.45)) continue;
                float lon = (float(wrapped) + 0.5 + 0.5 * (random.x - 0.5)) * 2.0 * kPi / kRays;
                float y = ((float(cell.y) + 0.2 + 0.6 * random.y) / kRows * 2.0 - 1.0) * 0.46;
                float widest = sqrt(max(1.0 - y * y / (0.43 * 0.43), 0.0));
                if (widest < 0.25) continue;
                float radius = widest * (0.185 + 0.055 * float(layer) + 0.04 * (random.x - 0.5));
                vec3 out_ = vec3(cos(lon), 0.0, -sin(lon)), side = vec3(sin(lon), 0.0, cos(lon));
                vec3 d = p - radius * out_ - vec3(0.0, y, 0.0);
                float along = dot(d, out_) / 0.029;
                float taper = mix(0.6, 1.0, smoothstep(-1.0, 0.4, along));
                float r = length(vec3(along, d.y / (0.019 * taper), dot(d, side) / (0.0135 * taper)));
                float inside = 1.0 - above(1.0, r, 0.10 + 30.0 * place.pixel);
                if (inside > seed) {
                    seed = inside;
                    rise = sqrt(max(1.0 - r * r, 0.0));
                }
            }
    s.albedo = mix(s.albedo, mix(srgb(46.0, 30.0, 18.0), srgb(22.0, 14.0, 14.0), rise), seed);
    s.height = mix(s.height, 0.012 * rise, seed);
    s.roughness = mix(s.roughness, 0.2, seed);
    s.depth *= 1.0 - seed;
    float skin = above(0.968, t, 0.005 + 2.0 * place.pixel);
    s.albedo = mix(s.albedo, srgb(104.0, 76.0, 36.0), skin);
    s.wet *= 1.0 - skin;
    if (t > 1.015 && length(p.xz) < 0.045) woody(p, s);
}
