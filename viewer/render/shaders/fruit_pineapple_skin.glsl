// Eyes on 8 spirals one way and 13 the other; each is a shield with a withered bract. The lattice is the one that
// data/maker/fruit/pineapple.cpp raises, over the texture coordinates.
void paint(Look look, Place place, inout Surface s)
{
    vec3 p = place.object;
    vec2 lattice = vec2(8.0 * place.uv.x + 3.2 * place.uv.y, 13.0 * place.uv.x - 5.0 * place.uv.y);
    vec2 cell = fract(lattice) - 0.5;
    ivec2 number = ivec2(int(mod(floor(lattice.x), 8.0)), int(mod(floor(lattice.y), 13.0)));
    vec3 random = lattice_point(ivec3(number, 4));
    // Upright and level in the eye's own frame.
    vec2 eye = vec2(cell.x + cell.y, cell.x - cell.y);
    float r = length(cell) * 2.0, edge = 2.0 * max(abs(cell.x), abs(cell.y));
    float fine = noise(p * 60.0), fibre = noise(vec3(eye.x * 16.0, eye.y * 5.0, random.x * 31.0));
    vec3 gold = mix(srgb(226.0, 150.0, 36.0), srgb(196.0, 118.0, 26.0), random.y);
    gold = mix(gold, srgb(150.0, 128.0, 44.0), 0.8 * smoothstep(0.1, 0.7, p.y / 0.74 + 0.5 * (random.z - 0.5)));
    s.albedo = mix(gold, srgb(240.0, 186.0, 70.0), 0.5 * fibre * (1.0 - r));
    s.albedo = mix(s.albedo, srgb(120.0, 74.0, 24.0), 0.65 * smoothstep(0.35, 0.75, r + 0.2 * (fine - 0.5)));
    // Grooves are green and dark.
    float groove = smoothstep(0.74, 0.96, edge + 0.08 * (fine - 0.5));
    s.albedo = mix(s.albedo, srgb(66.0, 66.0, 24.0), 0.9 * groove);
    // The bract: a pointed flap over the eye's lower half that dried at its tip.
    float flap = 1.0 - smoothstep(0.0, 0.10, abs(eye.x) - 0.30 * (0.55 - eye.y) * step(eye.y, 0.5) );
    float bract = flap * smoothstep(-0.62, -0.3, eye.y) * (1.0 - smoothstep(0.16, 0.30, eye.y));
    s.albedo = mix(s.albedo, mix(srgb(150.0, 128.0, 66.0), srgb(206.0, 170.0, 104.0), fibre), 0.55 * bract);
    float tip = bell(length(vec2(eye.x * 1.6, eye.y - 0.20)), 0.13);
    s.albedo = mix(s.albedo, srgb(58.0, 34.0, 18.0), 0.85 * tip);
    s.height = 0.030 * (1.0 - smoothstep(0.2, 1.0, edge)) + 0.012 * bract + 0.012 * tip + 0.003 * fine;
    s.albedo *= 0.9 + 0.2 * fine;
    s.roughness = 0.5 + 0.2 * groove;
    s.through = srgb(255.0, 180.0, 50.0);
    s.depth = 0.12;
}
