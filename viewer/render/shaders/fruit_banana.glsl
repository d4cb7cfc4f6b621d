// The banana's axis is an arc in the plane z = 0: data/maker/fruit/banana.cpp.
struct Bend
{
    float share;      // of the way along the axis: -1 the flower's end, 1 the stalk
    float turn;       // about the axis
    float radius;     // distance from the axis
    float thickness;  // distance of the skin from the axis there
    vec2 across;      // inwards, sideways
};

Bend along_banana(vec3 p)
{
    const float kBend = 1.12, kHalfAngle = 0.98, kDrop = 0.22;
    vec2 from_centre = vec2(p.x, kBend - (p.y + kDrop));
    Bend b;
    b.share = atan(from_centre.x, from_centre.y) / kHalfAngle;
    b.across = vec2(kBend - length(from_centre), p.z);
    b.turn = atan(b.across.y, b.across.x);
    b.radius = length(b.across);
    float tip = 0.36 + 0.64 * smoothstep(-1.0, -0.70, b.share);
    float neck = 1.0 - 0.66 * smoothstep(0.40, 0.86, b.share);
    float rib = cos(5.0 * b.turn) + 0.25 * cos(10.0 * b.turn);
    b.thickness = 0.21 * (1.0 - 0.14 * b.share * b.share) * tip * neck *
                  (1.0 + 0.032 * smoothstep(-1.0, -0.8, b.share) * rib);
    return b;
}

// Flesh of three parts that meet in the middle, where rows of seeds would be; a peel with strings. Returns how much is
// peel.
float banana_flesh(vec3 p, float pixel, vec3 cream, vec3 peel, vec3 inner_peel, vec3 seed_colour, inout Surface s)
{
    Bend b = along_banana(p);
    float t = b.radius / b.thickness;
    float lump = cloud(p * 7.0, 2) - 0.5;
    vec3 grain = cells(p * 40.0);
    float fine = noise(p * 120.0);
    float streak = noise(vec3(b.across * 30.0, b.share * 12.0));
    float ray = noise(vec3(cos(b.turn) * 8.0, sin(b.turn) * 8.0, 10.0 * b.share));
    vec3 flesh = cream * (0.90 + 0.08 * grain.z + 0.07 * fine);
    flesh = mix(flesh, cream * vec3(0.93, 0.86, 0.70), 0.5 * smoothstep(0.4, 0.8, ray) * smoothstep(0.25, 0.5, t));
    // Three seams from the middle and a darker, glassy heart of three lobes.
    float third = abs(fract(b.turn * 3.0 / (2.0 * kPi) + 0.04 * lump) - 0.5);
    float lobes = t * (1.0 + 0.35 * cos(3.0 * b.turn + kPi)) + 0.10 * lump;
    float heart = 1.0 - smoothstep(0.24, 0.36, lobes);
    flesh = mix(flesh, cream * vec3(0.90, 0.78, 0.55), 0.75 * heart);
    float seam = (1.0 - smoothstep(0.004, 0.012 + pixel, (0.5 - third) * b.radius * 2.0)) * (1.0 - smoothstep(0.55, 0.72, t));
    flesh = mix(flesh, cream * vec3(0.84, 0.70, 0.46), 0.45 * seam);
    flesh = mix(flesh, cream * vec3(0.80, 0.64, 0.38), 0.35 * bell(lobes - 0.34, 0.04));
    s.height = 0.0016 * grain.x + 0.001 * streak - 0.003 * seam;
    // Seeds: three double rows of specks.
    float seeds = 0.0;
    for (int k = 0; k < 6; ++k) {
        float at = (float(k / 2) + 0.5) * 2.0 * kPi / 3.0 + (k % 2 == 0 ? 0.30 : -0.30);
        float step_ = b.share * 19.0 + 0.37 * float(k);
        vec3 random = lattice_point(ivec3(int(floor(step_)), k, 11));
        vec2 d = b.across - b.thickness * (0.19 + 0.05 * random.x) * vec2(cos(at), sin(at));
        float along = (fract(step_) - 0.5) / 19.0 * 1.1;
        float r = length(vec3(d, along)) / (0.0075 + 0.006 * random.y);
        seeds = max(seeds, 1.0 - above(1.0, r, 0.25 + 60.0 * pixel));
    }
    flesh = mix(flesh, seed_colour, 0.85 * seeds);
    float is_peel = above(0.845, t + 0.015 * lump, 0.006 + 2.0 * pixel);
    // A thin gap, then strings, then the yellow outside.
    float gap = bell(t - 0.84, 0.012 + 3.0 * pixel);
    vec3 rind = mix(inner_peel, peel, smoothstep(0.93, 0.975, t));
    rind *= 0.9 + 0.2 * noise(vec3(b.turn * 14.0, t * 10.0, b.share * 8.0));
    s.albedo = mix(flesh, rind, is_peel);
    s.albedo *= 1.0 - 0.35 * gap;
    s.height -= 0.004 * gap;
    s.height *= 1.0 - is_peel;
    return is_peel;
}
