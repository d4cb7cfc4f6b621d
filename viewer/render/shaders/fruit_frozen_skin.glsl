// Clear ice that shows what is in it, with cracks and bubbles, and frost along its edges.
void paint(Look look, Place place, inout Surface s)
{
    vec3 p = place.object;
    Ice ice = in_ice(p);
    // Ice bends the ray towards the middle: each facet shows the strawberry from another side.
    vec3 along = refract(-place.to_eye, ice.normal, 1.0 / 1.31);
    vec3 start = p - 0.004 * ice.normal;
    vec4 seen = through_ice(start, along);
    vec3 blue = srgb(96.0, 184.0, 240.0);
    vec3 clear = mix(seen.rgb, blue, 0.5 * (1.0 - exp(-0.6 * seen.w)));
    clear = mix(clear, srgb(236.0, 246.0, 252.0), 0.38 * cracks(start, along, seen.w));
    clear = mix(clear, srgb(240.0, 248.0, 255.0), 0.8 * bubbles(start, along, seen.w));
    float fine = noise(p * 62.0), patch_ = cloud(p * 5.0 + 4.0, 3);
    float edge = 1.0 - smoothstep(0.0, 0.06, ice.next + 0.05 * (noise(p * 22.0) - 0.5));
    float frost = clamp(0.85 * edge + 0.65 * smoothstep(0.66, 0.82, patch_ + 0.10 * (fine - 0.5)), 0.0, 1.0);
    clear = pow(clear, vec3(1.2));
    s.albedo = mix(clear, srgb(232.0, 242.0, 250.0), frost * (0.6 + 0.4 * fine));
    s.height = 0.003 * frost * fine + 0.004 * cloud(p * 7.0, 2);
    s.roughness = mix(0.10, 0.65, frost);
    s.reflectance = 0.045;
    s.through = clear;
    s.depth = 0.22;
    s.wet = 0.5 * (1.0 - frost);
    float sparkle = smoothstep(0.88, 0.97, noise(p * 85.0)) * frost;
    s.glow = 0.07 * clear * (1.0 - frost) + 0.6 * sparkle;
}
