// A steel head with a rune that glows, on a green banana that leather is wound around.
void steel(Head h, vec3 p, float pixel, inout Surface s)
{
    vec3 q = h.place;
    vec3 dent = cells(p * 15.0);
    float blotch = cloud(p * 6.0, 3), fine = noise(p * 80.0);
    s.albedo = mix(srgb(104.0, 112.0, 124.0), srgb(168.0, 176.0, 188.0), smoothstep(0.3, 0.75, blotch) * 0.7 + 0.3 * dent.z);
    // The two faces are worn bright, and so are the rims around them.
    float face = smoothstep(0.375, 0.40, abs(q.x));
    s.albedo = mix(s.albedo, srgb(214.0, 220.0, 228.0), 0.75 * face);
    s.height = 0.006 * (1.0 - face) * dent.x * dent.x;
    s.roughness = mix(0.34, 0.26, face) + 0.16 * blotch;
    s.reflectance = 0.72;
    // Two grooves around, and a bolt between them on either side.
    float groove = bell(abs(q.x) - 0.225, 0.012 + pixel);
    float level = q.z - 0.22;
    // Two strokes along the head that lean, and meet where the bolt turns.
    float side = q.x * sign(q.y), far = abs(side);
    float lean = (level - 0.35 * side) * sign(side) + 0.035;
    float stroke = 0.034 * (1.0 - far / 0.17) + 0.022 * step(far, 0.045);
    float bolt = (1.0 - above(stroke, abs(lean), 0.005 + pixel)) * step(far, 0.17) * step(h.thick * 0.7, abs(q.y));
    float mark = max(groove, bolt);
    s.albedo = mix(s.albedo, srgb(20.0, 60.0, 26.0), mark);
    s.height -= 0.006 * mark;
    s.reflectance = mix(s.reflectance, 0.05, mark);
    s.glow = mark * mix(vec3(0.10, 0.75, 0.12), vec3(0.55, 1.3, 0.35), bolt) * (0.7 + 0.5 * noise(p * 9.0));
    if (q.z < 0.052) {
        // The collar.
        s.albedo = mix(srgb(84.0, 90.0, 98.0), srgb(122.0, 128.0, 136.0), fine);
        s.glow = vec3(0.0);
    }
}

void paint(Look look, Place place, inout Surface s)
{
    vec3 p = place.object;
    Head h = in_head(p);
    if (h.is_head) {
        steel(h, p, place.pixel, s);
        return;
    }
    Bend b = along_banana(p);
    float blotch = cloud(p * 5.0, 3), fine = noise(p * 60.0);
    vec3 peel = mix(srgb(56.0, 158.0, 40.0), srgb(166.0, 222.0, 66.0), smoothstep(0.25, 0.75, blotch));
    float rib = 0.5 + 0.5 * cos(5.0 * b.turn);
    peel = mix(peel, srgb(206.0, 244.0, 120.0), 0.4 * smoothstep(0.7, 1.0, rib));
    float sparkle = smoothstep(0.86, 0.97, noise(p * 70.0));
    // Leather strips, wound around the grip with gaps.
    float wound = fract(b.share * 4.0 + b.turn / (2.0 * kPi));
    float edge = min(wound, 1.0 - wound) * 1.1 / 4.0;
    float grip = smoothstep(-0.66, -0.65, b.share) * smoothstep(0.43, 0.42, b.share);
    float strip = grip * above(0.045, edge, 0.004 + place.pixel);
    float grain = noise(p * 110.0);
    vec3 leather = mix(srgb(92.0, 52.0, 28.0), srgb(146.0, 92.0, 52.0), 0.6 * blotch + 0.4 * grain);
    leather *= 0.75 + 0.25 * smoothstep(0.045, 0.075, edge);
    float stitch = bell(edge - 0.06, 0.005 + 0.5 * place.pixel) * smoothstep(0.3, 0.5, abs(fract(b.turn * 5.0) - 0.5) * 2.0);
    leather = mix(leather, srgb(226.0, 196.0, 140.0), 0.8 * stitch);
    s.albedo = mix(peel, leather, strip);
    float end = smoothstep(-0.93, -0.975, b.share);
    s.albedo = mix(s.albedo, srgb(40.0, 34.0, 22.0), end);
    s.height = 0.008 * strip + 0.002 * fine + 0.001 * grain * strip;
    s.roughness = mix(0.36, 0.7, strip);
    s.through = mix(srgb(150.0, 240.0, 60.0), srgb(140.0, 80.0, 40.0), strip);
    s.depth = 0.25 * (1.0 - strip);
    s.glow = (1.0 - strip) * (1.0 - end) * (0.10 * peel + 0.7 * sparkle * srgb(226.0, 255.0, 160.0));
}
