in float across;
in float strength;

out vec4 colour;

void main()
{
    float edge = 1.0 - abs(across);
    float core = smoothstep(0.45, 0.8, edge);
    vec3 steel = mix(vec3(0.35, 0.62, 1.0), vec3(1.0, 1.0, 1.0), core);
    colour = vec4(steel, strength * (0.35 * smoothstep(0.0, 0.5, edge) + 0.65 * core));
}
