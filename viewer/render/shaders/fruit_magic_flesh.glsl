// The magic bananas inside: their flesh, peel and seeds come from the Look, and they shine a little by themselves.
void paint(Look look, Place place, inout Surface s)
{
    vec3 cream = mix(look.colour.rgb, vec3(1.0), 0.12);
    float peel = banana_flesh(place.object, place.pixel, cream, look.second.rgb, mix(look.second.rgb, cream, 0.5),
                              look.third.rgb, s);
    float sparkle = smoothstep(0.80, 0.95, noise(place.object * 42.0)) * smoothstep(0.5, 0.9, noise(place.object * 17.0));
    s.glow = 0.10 * look.colour.rgb + 0.5 * sparkle * mix(look.colour.rgb, vec3(1.0), 0.5);
    s.roughness = look.finish.x;
    s.through = look.second.rgb;
    s.depth = 0.5;
    s.wet = 0.8;
}
