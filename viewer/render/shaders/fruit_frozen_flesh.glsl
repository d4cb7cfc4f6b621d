// Ice that is clear below its skin and white with bubbles farther in, and the strawberry.
void berry(vec3 q, float share, float pixel, inout Surface s)
{
    vec3 radial = normalize(q);
    float strand = noise(radial * 16.0), fine = noise(q * 110.0);
    // Red below the skin, pale inside, with a hollow along the axis.
    vec3 flesh = mix(srgb(250.0, 196.0, 176.0), srgb(226.0, 44.0, 44.0), smoothstep(0.30, 0.86, share + 0.14 * (strand - 0.5)));
    float rays = smoothstep(0.60, 0.85, strand) * smoothstep(0.25, 0.45, share) * (1.0 - smoothstep(0.78, 0.92, share));
    flesh = mix(flesh, srgb(252.0, 220.0, 204.0), 0.6 * rays);
    float heart = length(vec2(length(q.xz) / 0.065, (q.y - 0.06) / 0.19));
    flesh = mix(flesh, srgb(253.0, 232.0, 218.0), 0.8 * bell(heart - 1.1, 0.28));
    flesh = mix(flesh, srgb(206.0, 84.0, 76.0), 0.8 * (1.0 - smoothstep(0.75, 0.95, heart)));
    flesh = mix(flesh, srgb(198.0, 14.0, 26.0), smoothstep(0.90, 0.95, share));
    vec2 seed = berry_seeds(q * (0.985 / max(share, 0.1)));
    float rim = smoothstep(0.91, 0.94, share);
    flesh = mix(flesh, srgb(248.0, 204.0, 98.0), seed.x * rim);
    flesh = mix(flesh, srgb(84.0, 160.0, 56.0), berry_leaf(q) * above(0.90, share, 0.02));
    s.albedo = flesh * (0.90 + 0.14 * fine);
    s.height = 0.002 * fine + 0.0015 * strand;
    s.roughness = 0.4;
    s.through = srgb(255.0, 90.0, 76.0);
    s.depth = 0.32;
    s.wet = 0.8;
}

void paint(Look look, Place place, inout Surface s)
{
    vec3 p = place.object;
    vec3 q = in_berry(p);
    float share = berry_share(q);
    Ice ice = in_ice(p);
    float lump = cloud(p * 6.0, 3) - 0.5, fine = noise(p * 70.0);
    // Water freezes from outside and drives its air inwards.
    float white = smoothstep(0.05, 0.22, ice.depth + 0.12 * lump);
    vec4 seen = through_ice(p, -place.to_eye);
    vec3 clear = mix(seen.rgb, srgb(84.0, 172.0, 232.0), 0.6 * (1.0 - exp(-3.0 * seen.w)) + 0.2);
    vec3 air = mix(srgb(196.0, 222.0, 236.0), srgb(226.0, 238.0, 244.0), smoothstep(0.3, 0.7, cloud(p * 13.0, 2)));
    s.albedo = mix(clear, air, 0.85 * white);
    // Bubbles: chains that run inwards.
    vec3 bubble = cells(p * 24.0), small = cells(p * 46.0 + 5.0);
    float wall = bell(bubble.x - 0.26 * bubble.z, 0.05 + 10.0 * place.pixel) * step(0.45, bubble.z);
    float hole = (1.0 - smoothstep(0.0, 0.26 * bubble.z, bubble.x)) * step(0.45, bubble.z);
    float speck = (1.0 - smoothstep(0.10, 0.20, small.x)) * step(0.6, small.z);
    s.albedo = mix(s.albedo, srgb(242.0, 248.0, 252.0), 0.65 * max(wall, speck) * (0.35 + 0.65 * white));
    s.albedo = mix(s.albedo, srgb(120.0, 178.0, 214.0), 0.45 * hole * (0.35 + 0.65 * white));
    // Cracks.
    float line = 1.0 - smoothstep(0.0, 0.03 + 4.0 * place.pixel, cells(p * 3.4 + 0.5 * lump).y);
    s.albedo = mix(s.albedo, srgb(244.0, 250.0, 254.0), 0.5 * line);
    // Frost where the skin was.
    s.albedo = mix(s.albedo, srgb(226.0, 238.0, 246.0), 0.7 * (1.0 - smoothstep(0.006, 0.016 + place.pixel, ice.depth)));
    s.height = 0.0012 * fine - 0.004 * hole * white - 0.002 * line;
    s.roughness = 0.4;
    s.through = srgb(150.0, 206.0, 240.0);
    s.depth = 0.35;
    s.wet = 0.6;
    float in_fruit = 1.0 - above(1.0, share, 0.012 + 2.0 * place.pixel);
    if (in_fruit > 0.0) {
        Surface inside = s;
        berry(q, share, place.pixel, inside);
        s.albedo = mix(s.albedo, inside.albedo, in_fruit);
        s.height = mix(s.height, inside.height, in_fruit);
        s.through = mix(s.through, inside.through, in_fruit);
        s.wet = mix(s.wet, inside.wet, in_fruit);
    }
}
