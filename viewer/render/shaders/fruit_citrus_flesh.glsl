float citrus_outline(float polar, bool is_lemon)
{
    if (is_lemon)
        return superellipse(polar, 0.46, 0.60, 2.1) + 0.115 * bell(polar, 0.27) + 0.06 * bell(kPi - polar, 0.24);
    float c = cos(polar);
    return 0.60 * (1.0 - 0.05 * c * c - 0.035 * bell(polar, 0.20) - 0.02 * bell(kPi - polar, 0.16));
}

// Zest, pith, and segments of juice sacs between membranes that meet in a white column. The Look says how many
// segments there are and in which colours: sac, its wall, pith.
void paint(Look look, Place place, inout Surface s)
{
    vec3 p = place.object;
    float segments = look.second.w;
    bool is_lemon = segments < 9.5;
    float polar = polar_of(p);
    float outline = citrus_outline(polar, is_lemon);
    float r = length(p), lump = cloud(p * 5.0, 2) - 0.5;
    // The column is not straight, and segments lean a little: a long cut meets membranes here and there, not all along.
    vec3 grown = p + vec3(0.022 * sin(6.0 * p.y + 0.7), 0.0, 0.022 * cos(5.0 * p.y));
    float turn = turn_of(grown) + 0.20 * sin(3.6 * p.y + 0.9) + 0.10 * lump, rho = length(grown.xz);
    // Metres below the skin.
    float below = outline - r;
    float zest_depth = 0.020 + 0.008 * (noise(p * 30.0) - 0.5), pith_depth = (is_lemon ? 0.070 : 0.058) + 0.016 * lump;

    // Segments are not quite even.
    float share = turn / (2.0 * kPi) * segments + 0.40 + 0.12 * sin(turn * 2.0 + 1.0) + 0.06 * sin(3.0 * turn);
    float number = mod(floor(share), segments), across = fract(share);
    float half_angle = kPi / segments;
    // Distance to the nearer membrane, to the pith and to the column: the corners of a segment are round.
    float to_side = rho * sin(min(across, 1.0 - across) * 2.0 * half_angle);
    float to_pith = below - pith_depth;
    // Thin in the middle, wide where it meets the pith at the ends.
    float end = abs(p.y) / (is_lemon ? 0.62 : 0.55);
    float column = (is_lemon ? 0.020 : 0.026) + 0.075 * end * end * end * end + 0.014 * lump;
    float to_column = rho - column;
    const float kRound = 0.035;
    vec3 inner = max(vec3(kRound) - vec3(to_side, to_pith, to_column), 0.0);
    float wall = kRound - length(inner);

    // Sacs: long drops from the skin to the middle.
    float lean = (across - 0.5) * 2.0 * half_angle;
    // They fan out: seen along the axis they are as wide as far out as near the column.
    vec3 sac_space = vec3(rho * 6.0, rho * sin(lean) * 24.0 + 31.0 * number, 14.5 * p.y / (0.32 + rho));
    sac_space.x += 1.1 * noise(sac_space * 0.6) + 0.45 * sac_space.z * step(0.5, fract(0.37 * number));
    // Where a pixel is as large as a sac, they would hide the segments under dots.
    vec3 sac = mix(cells(sac_space + 0.6 * lump), vec3(0.45, 0.2, 0.5), 0.85 * smoothstep(0.018, 0.036, place.pixel));
    float tear = smoothstep(-0.05, 0.24, sac.y);
    vec3 juice = mix(look.colour.rgb, look.second.rgb, 0.55 * sac.z + 0.25 * noise(p * 38.0));
    juice *= 1.10 - 0.45 * sac.x * sac.x;
    vec3 skin_of_sac = mix(look.second.rgb, look.third.rgb, 0.18);
    vec3 flesh = mix(skin_of_sac, juice, 0.30 + 0.70 * tear);
    vec3 pith = look.third.rgb * (0.90 + 0.14 * noise(p * 44.0));
    // A membrane lets the colour behind it through.
    vec3 membrane = mix(look.third.rgb, mix(look.second.rgb, juice, 0.4), 0.45 + 0.25 * noise(p * vec3(30.0, 12.0, 30.0)));

    float soft = 0.002 + place.pixel;
    float is_flesh = above(0.007, wall, soft);
    float is_pith = max(1.0 - above(0.0, to_pith, 0.004), 1.0 - above(0.0, to_column, 0.006));
    s.albedo = mix(mix(membrane, pith, is_pith), flesh, is_flesh);
    s.albedo = mix(s.albedo, skin_of_sac, 0.35 * is_flesh * (1.0 - smoothstep(0.007, 0.022, wall)));
    // Zest with its glands.
    float zest = 1.0 - above(zest_depth, below, 0.003 + 0.5 * place.pixel);
    vec3 gland = cells(p * 24.0);
    vec3 peel = mix(is_lemon ? srgb(244.0, 206.0, 40.0) : srgb(248.0, 142.0, 20.0),
                    is_lemon ? srgb(232.0, 186.0, 20.0) : srgb(234.0, 104.0, 8.0), 1.0 - smoothstep(0.1, 0.35, gland.x));
    s.albedo = mix(s.albedo, peel, zest);
    s.height = is_flesh * 0.012 * (1.0 - sac.x * sac.x) - 0.004 * (1.0 - is_flesh) * (1.0 - is_pith);
    s.roughness = mix(0.6, 0.28, is_flesh);
    s.through = mix(look.third.rgb, look.colour.rgb, is_flesh);
    s.depth = mix(0.2, 0.45, is_flesh);
    s.wet = mix(0.25, 1.0, is_flesh);

    // A pip near the column in some segments.
    vec3 random = lattice_point(ivec3(int(number), 5, is_lemon ? 2 : 1));
    float middle = 0.5 + 0.2 * (random.y - 0.5);
    vec3 d = vec3(rho - (is_lemon ? 0.11 : 0.13), p.y - 0.16 * (random.z - 0.5), rho * sin((across - middle) * 2.0 * half_angle));
    float taper = mix(1.0, 0.5, smoothstep(0.0, 1.0, -d.x / 0.06));
    float q = length(vec3(d.x / 0.058, d.y / (0.034 * taper), d.z / (0.026 * taper)));
    if (random.x < (is_lemon ? 0.75 : 0.45)) {
        float pip = 1.0 - above(1.0, q, 0.08 + 10.0 * place.pixel);
        float bulge = sqrt(max(1.0 - q * q, 0.0));
        s.albedo = mix(s.albedo, mix(srgb(206.0, 176.0, 110.0), srgb(246.0, 232.0, 190.0), bulge), pip);
        s.height = mix(s.height, 0.02 * bulge * bulge, pip);
        s.depth *= 1.0 - 0.7 * pip;
    }
    // A pixel at the edge of a cut looks beyond the skin: only the button is of wood.
    if (below < -0.004 && length(p.xz) < 0.06) woody(p, s);
}
