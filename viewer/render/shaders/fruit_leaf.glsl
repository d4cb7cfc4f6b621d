// A blade with veins along it; texture coordinates are across, 0 to 1, and along. Colours: blade, its middle, edges.
void paint(Look look, Place place, inout Surface s)
{
    vec3 p = place.object;
    float across = abs(place.uv.x - 0.5) * 2.0, along = place.uv.y;
    float vein = noise(vec3(place.uv.x * 34.0, along * 3.0, 1.0)), blotch = cloud(p * 6.0, 2);
    s.albedo = mix(look.second.rgb, look.colour.rgb, smoothstep(0.0, 0.55, across + 0.2 * (blotch - 0.5)));
    s.albedo *= 0.75 + 0.5 * vein;
    s.albedo = mix(s.albedo, look.third.rgb, 0.7 * smoothstep(0.80, 1.0, across) + 0.6 * smoothstep(0.55, 0.85, along));
    s.height = 0.004 * vein;
    s.roughness = look.finish.x - 0.1 * vein;
    s.through = srgb(150.0, 205.0, 60.0);
    s.depth = 0.28;
}
