// Red in streaks over yellow, which shows in both hollows and on the side that the sun did not reach.
void paint(Look look, Place place, inout Surface s)
{
    vec3 p = place.object;
    float polar = polar_of(p), turn = turn_of(p);
    vec3 side = vec3(cos(turn), 0.0, -sin(turn));
    float streak = 0.6 * noise(vec3(side.xz * 17.0, 2.2 * polar)) + 0.4 * noise(vec3(side.xz * 39.0, 4.0 * polar + 7.0));
    float blotch = cloud(p * 2.6 + 3.0, 2);
    float sun = 0.5 + 0.5 * dot(normalize(p), normalize(vec3(0.7, 0.15, 0.7)));
    float red = smoothstep(0.16, 0.62, 0.42 * sun + 0.42 * blotch + 0.34 * (streak - 0.5) + 0.16);
    // Yellow-green round the stalk, with rays of russet.
    float hollow = bell(polar, 0.46) + 0.7 * bell(kPi - polar, 0.34);
    red *= 1.0 - smoothstep(0.25, 0.95, hollow + 0.35 * (streak - 0.5));
    vec3 yellow = mix(srgb(232.0, 196.0, 78.0), srgb(196.0, 196.0, 66.0), blotch);
    vec3 crimson = mix(srgb(196.0, 20.0, 30.0), srgb(134.0, 8.0, 22.0), smoothstep(0.35, 0.75, streak));
    s.albedo = mix(yellow, crimson, red);
    float russet = bell(polar, 0.26) * smoothstep(0.3, 0.6, streak);
    s.albedo = mix(s.albedo, srgb(150.0, 110.0, 52.0), 0.7 * russet);
    // Lenticels: pale dots, closer together towards the calyx.
    vec3 dots = cells(p * 17.0);
    float dot_ = (1.0 - above(0.10 + 0.07 * dots.z, dots.x, 0.03 + 8.0 * place.pixel));
    s.albedo = mix(s.albedo, srgb(240.0, 206.0, 140.0), 0.55 * dot_);
    s.height = 0.0012 * noise(p * 26.0) + 0.001 * dot_;
    s.roughness = 0.25 + 0.10 * noise(p * 11.0) + 0.3 * russet;
    s.through = srgb(255.0, 90.0, 50.0);
    s.depth = 0.14;
    // The withered calyx.
    float calyx = 1.0 - smoothstep(0.03, 0.06, length(p.xz) + 0.02 * (noise(vec3(side.xz * 4.0, 0.0)) - 0.5));
    if (p.y < 0.0) s.albedo = mix(s.albedo, srgb(58.0, 42.0, 26.0), calyx);
}
