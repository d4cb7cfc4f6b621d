in vec2 place;

out float height;

// Sweeps of a trowel: noise stretched along a direction that turns slowly from patch to patch.
float sweep(vec2 p, float turn, float seed)
{
    vec2 along = vec2(cos(turn), sin(turn));
    vec2 q = vec2(dot(p, along), dot(p, vec2(-along.y, along.x)));
    return cloud(vec3(q * vec2(1.0, 3.2), seed), 2);
}

void main()
{
    vec2 p = place * vec2(22.0, 11.0);  // about a cell a world unit
    float clouds = cloud(vec3(p * 0.55, 7.0), 3);
    float which = smoothstep(0.4, 0.6, noise(vec3(p * 0.5, 2.0)));
    float sweeps = mix(sweep(p, 0.35, 11.0), sweep(p, 2.0, 23.0), which);
    float grain = noise(vec3(mat2(0.8, 0.6, -0.6, 0.8) * p * 13.0, 31.0));
    height = 0.64 * clouds + 0.33 * sweeps + 0.03 * grain;
}
