// Fibres from pole to pole and three eyes at the top.
void paint(Look look, Place place, inout Surface s)
{
    vec3 p = place.object;
    float turn = turn_of(p), polar = polar_of(p);
    vec3 side = vec3(cos(turn), 0.0, -sin(turn));
    float wander = cloud(p * 3.0, 2);
    float fibre = noise(vec3(side.xz * 26.0 + 1.6 * wander, 3.0 * polar)), hair = noise(vec3(side.xz * 70.0 + 3.0 * wander, 7.0 * polar));
    // Towards the outline and towards the poles fibres get finer than pixels.
    float narrow = place.pixel / max(sin(polar), 0.04);
    float fine = narrow * 80.0, coarse = narrow * 32.0;
    hair = mix(0.5, hair, 1.0 / (1.0 + fine * fine));
    fibre = mix(0.5, fibre, 1.0 / (1.0 + coarse * coarse));
    float tuft = smoothstep(0.45, 0.8, cloud(vec3(side.xz * 5.0, 4.0 * polar), 2));
    s.albedo = mix(srgb(66.0, 40.0, 22.0), srgb(122.0, 82.0, 46.0), fibre);
    s.albedo = mix(s.albedo, srgb(176.0, 132.0, 82.0), 0.6 * smoothstep(0.62, 0.9, hair));
    s.albedo *= 0.7 + 0.5 * tuft;
    s.height = 0.016 * fibre + 0.010 * hair;
    s.roughness = 0.92;
    s.fuzz = 0.6;
    for (int k = 0; k < 3; ++k) {
        float at = (float(k) + 0.5) * 2.0 * kPi / 3.0;
        vec3 eye = vec3(sin(0.34) * cos(at), cos(0.34), -sin(0.34) * sin(at));
        float r = length(normalize(p) - eye) / 0.115;
        float hole = 1.0 - smoothstep(0.75, 1.0, r + 0.12 * (fibre - 0.5));
        s.albedo = mix(s.albedo, srgb(34.0, 20.0, 12.0), hole);
        s.albedo = mix(s.albedo, srgb(150.0, 110.0, 66.0), 0.5 * bell(r - 1.1, 0.16));
        s.height = mix(s.height, -0.02, hole);
    }
}
