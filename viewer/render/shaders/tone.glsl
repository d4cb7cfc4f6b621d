// Bright light rolls off instead of being cut: the curve x / (x + a), scaled so that small values keep their size.
// The framebuffer turns linear light into sRGB.
vec3 toned(vec3 light)
{
    vec3 x = light * frame.viewport.z;
    return x * (1.0 + x / 9.0) / (1.0 + x);
}
