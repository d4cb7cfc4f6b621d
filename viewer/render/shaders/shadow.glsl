uniform sampler2DShadow shadow_map;

// How much of the key light arrives: a wide, smooth kernel over a coarse map, so that edges are soft.
// `spread` is the distance of the samples in texels: a shadow that falls far is softer
float light_at(vec3 world, vec3 n, float spread)
{
    // A step along the normal keeps a surface out of its own shadow.
    vec3 place = (frame.shadow_transform * vec4(world + 1.6 * n * frame.eye.w, 1.0)).xyz;
    if (place.z >= 1.0) return 1.0;
    vec2 texel = 1.0 / vec2(textureSize(shadow_map, 0));
    float light = 0.0, weights = 0.0;
    for (int y = -2; y <= 2; ++y)
        for (int x = -2; x <= 2; ++x) {
            float weight = (3.0 - abs(float(x))) * (3.0 - abs(float(y)));
            light += weight * texture(shadow_map, vec3(place.xy + spread * texel * vec2(x, y), place.z));
            weights += weight;
        }
    return mix(1.0, light / weights, frame.to_light.w);
}
