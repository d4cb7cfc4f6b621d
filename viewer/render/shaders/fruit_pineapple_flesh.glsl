float pineapple_outline(float polar)
{
    return superellipse(polar, 0.53, 0.74, 2.6);
}

// Yellow strands from the core to the eyes, with a glassy dark spot at the root of each eye.
void paint(Look look, Place place, inout Surface s)
{
    vec3 p = place.object;
    float turn = turn_of(p), rho = length(p.xz), polar = polar_of(p);
    float t = length(p) / pineapple_outline(polar);
    float fine = noise(p * 100.0), lump = cloud(p * 5.0, 2) - 0.5;
    if (p.y > 0.70 && t > 0.99) {
        // The crown: white at the heart, green in its leaves.
        float green = smoothstep(0.06, 0.17, rho) + smoothstep(0.9, 1.3, p.y);
        float vein = noise(p * vec3(60.0, 12.0, 60.0));
        s.albedo = mix(srgb(232.0, 226.0, 176.0), srgb(96.0, 138.0, 66.0), clamp(green, 0.0, 1.0)) * (0.8 + 0.35 * vein);
        s.roughness = 0.5;
        s.through = srgb(170.0, 210.0, 90.0);
        s.depth = 0.25;
        s.wet = 0.4;
        s.height = 0.002 * vein;
        return;
    }
    // Strands: noise that hardly changes along the way out.
    float up = p.y * 1.0 - 0.25 * rho;
    vec3 ray = vec3(cos(turn), up * 2.1, -sin(turn));
    float strand = noise(vec3(ray.x * 21.0, ray.y * 21.0, ray.z * 21.0) + vec3(0.0, 1.5 * rho, 0.0));
    float thin = noise(ray * 52.0 + 3.0 * rho);
    vec3 flesh = mix(srgb(250.0, 194.0, 40.0), srgb(255.0, 216.0, 84.0), strand);
    flesh = mix(flesh, srgb(226.0, 148.0, 18.0), 0.65 * smoothstep(0.5, 0.85, thin) * smoothstep(0.14, 0.3, rho));
    // Fruitlets: wedges between pale walls, the lattice of the skin carried inwards.
    float v = 0.95 + 1.12 * p.y + 0.1 * p.y * abs(p.y);
    vec2 lattice = vec2(8.0 * turn / (2.0 * kPi) + 3.2 * v, 13.0 * turn / (2.0 * kPi) - 5.0 * v) + 0.12 * lump;
    vec2 cell = fract(lattice) - 0.5;
    float wall = smoothstep(0.36, 0.49, max(abs(cell.x), abs(cell.y))) * smoothstep(0.38, 0.7, t);
    flesh = mix(flesh, srgb(255.0, 238.0, 160.0), 0.55 * wall);
    float root = bell(length(cell), 0.16) * bell(t - 0.86, 0.045);
    flesh = mix(flesh, srgb(172.0, 110.0, 30.0), 0.75 * root);
    // The core is paler, and tough.
    float core = 1.0 - smoothstep(0.11, 0.145, rho + 0.03 * lump);
    vec3 heart = mix(srgb(255.0, 240.0, 180.0), srgb(246.0, 222.0, 140.0), noise(p * vec3(48.0, 6.0, 48.0)));
    flesh = mix(flesh, heart, 0.9 * core);
    flesh = mix(flesh, srgb(238.0, 190.0, 60.0), 0.5 * bell(rho - 0.15, 0.018));
    s.albedo = flesh * (0.88 + 0.16 * fine);
    // Rind: green-brown, thicker between the eyes.
    float eye = sqrt(abs(sin(kPi * lattice.x) * sin(kPi * lattice.y)));
    float rim = t + 0.035 * (1.0 - eye);
    s.albedo = mix(s.albedo, srgb(214.0, 172.0, 62.0), smoothstep(0.90, 0.95, rim));
    s.albedo = mix(s.albedo, srgb(132.0, 96.0, 34.0), smoothstep(0.955, 0.985, rim));
    s.albedo = mix(s.albedo, srgb(82.0, 62.0, 24.0), smoothstep(0.99, 1.02, rim));
    float rind = smoothstep(0.93, 0.98, rim);
    s.height = (1.0 - rind) * (0.005 * strand + 0.003 * thin) - 0.006 * root + 0.002 * wall;
    s.roughness = mix(0.4, 0.7, rind);
    s.through = srgb(255.0, 206.0, 60.0);
    s.depth = mix(0.42, 0.1, rind);
    s.wet = mix(1.0, 0.1, rind);
}
