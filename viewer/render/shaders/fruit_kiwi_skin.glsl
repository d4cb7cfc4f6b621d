// Short brown hair over greenish leather.
void paint(Look look, Place place, inout Surface s)
{
    vec3 p = place.object;
    float blotch = cloud(p * 4.0, 3);
    float hair = noise(p * vec3(84.0, 34.0, 84.0) + 2.0 * blotch), more = noise(p * vec3(130.0, 48.0, 130.0));
    vec3 leather = mix(srgb(88.0, 62.0, 30.0), srgb(116.0, 84.0, 42.0), blotch);
    leather = mix(leather, srgb(88.0, 88.0, 38.0), 0.45 * smoothstep(0.45, 0.75, cloud(p * 2.2 + 7.0, 2)));
    s.albedo = mix(leather, srgb(158.0, 118.0, 68.0), 0.6 * smoothstep(0.45, 0.85, hair));
    s.albedo *= 0.72 + 0.5 * more;
    float ends = bell(polar_of(p), 0.18) + bell(kPi - polar_of(p), 0.18);
    s.albedo = mix(s.albedo, srgb(70.0, 48.0, 24.0), 0.7 * clamp(ends, 0.0, 1.0));
    s.height = 0.008 * hair + 0.004 * more;
    s.roughness = 0.85;
    s.fuzz = 1.3;
    s.through = srgb(190.0, 150.0, 80.0);
    s.depth = 0.1;
}
