// What holds for all fruit, after paint() of the fruit's own file.
void describe(Look look, Place place, inout Surface s)
{
    paint(look, place, s);
    // Relief finer than pixels would glitter.
    float ratio = place.pixel / 0.012;
    s.height /= 1.0 + ratio * ratio;
    // A cut is flat: where it happens to mirror the light it must not turn white all over.
    if (place.is_cap) {
        s.reflectance = min(s.reflectance, 0.010);
        s.roughness = max(s.roughness, 0.5);
    }
}
