// What holds for all fruit, after paint() of the fruit's own file.
void describe(Look look, Place place, inout Surface s)
{
    paint(look, place, s);
    // Relief finer than pixels would glitter.
    float ratio = place.pixel / 0.012;
    s.height /= 1.0 + ratio * ratio;
    // A cut is flat: where it happens to mirror the light it must not turn white all over.
    if (place.is_cap) {
        // Flesh swallows light; what comes back has gone through colour more than once.
        s.albedo = 0.82 * pow(max(s.albedo, 0.0), vec3(1.25));
        s.reflectance = min(s.reflectance, 0.004);
        s.roughness = max(s.roughness, 0.5);
    }
}
