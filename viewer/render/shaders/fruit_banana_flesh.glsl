void paint(Look look, Place place, inout Surface s)
{
    float peel = banana_flesh(place.object, place.pixel, srgb(254.0, 240.0, 196.0), srgb(238.0, 190.0, 36.0),
                              srgb(250.0, 234.0, 176.0), srgb(74.0, 48.0, 24.0), s);
    s.roughness = mix(0.5, 0.7, peel);
    s.through = srgb(255.0, 230.0, 150.0);
    s.depth = 0.34;
    s.wet = 0.45 * (1.0 - peel);
}
