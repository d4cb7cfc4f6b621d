// From light to what a screen shows: a filmic curve with a toe and a shoulder (Narkowicz, "ACES filmic tone mapping
// curve", 2015). The framebuffer turns the result into sRGB.
vec3 toned(vec3 light)
{
    vec3 x = light * frame.viewport.z;
    return clamp(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14), 0.0, 1.0);
}
