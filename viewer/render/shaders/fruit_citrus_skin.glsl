// Glands with oil: dimples, each with a bright rim. Orange and lemon differ in their Look.
void paint(Look look, Place place, inout Surface s)
{
    vec3 p = place.object;
    float blotch = cloud(p * 3.0, 3);
    vec3 pore = cells(p * 0.5 * look.second.w);
    vec3 small = cells(p * 0.95 * look.second.w + 4.0);
    float fine = clamp(1.6 - 60.0 * place.pixel, 0.0, 1.0);
    float dimple = (1.0 - smoothstep(0.06, 0.42, pore.x)) + 0.45 * (1.0 - smoothstep(0.05, 0.40, small.x));
    s.albedo = mix(look.colour.rgb, look.second.rgb, smoothstep(0.25, 0.85, blotch));
    s.albedo *= 1.0 - 0.10 * dimple * fine;
    s.albedo = mix(s.albedo, look.third.rgb, 0.55 * bell(polar_of(p), 0.30) * smoothstep(0.3, 0.7, blotch));
    s.albedo = mix(s.albedo, look.third.rgb, 0.45 * bell(kPi - polar_of(p), 0.22));
    s.height = fine * (-0.0045 * dimple) + 0.006 * cloud(p * 6.0, 2);
    s.roughness = look.finish.x + 0.08 * noise(p * 15.0);
    s.through = look.colour.rgb;
    s.depth = 0.16;
}
