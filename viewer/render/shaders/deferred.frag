out vec4 colour;

void main()
{
    vec2 place = gl_FragCoord.xy - frame.picture.xy;
    Samples samples = samples_of(place);
    if (samples.mask == 0) discard;
    gl_SampleMask[0] = samples.mask;
    // Software renderers go past a loop that nobody enters, but through a branch that nobody takes.
    for (int left = samples.mask; left != 0; left = 0)
        colour = vec4(toned(light_from(point_of(place, samples))), 1.0);
}
