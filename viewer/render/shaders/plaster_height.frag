in vec2 place;

out float height;

// Strokes of a trowel: noise stretched along a direction that changes from patch to patch.
float stroke(vec2 p, float turn, float seed)
{
    vec2 along = vec2(cos(turn), sin(turn));
    vec2 q = vec2(dot(p, along), dot(p, vec2(-along.y, along.x)));
    return cloud(vec3(q * vec2(1.2, 7.0), seed), 3);
}

void main()
{
    vec2 p = place * 9.0;
    float patch_of = cloud(vec3(p * 0.45, 2.0), 2);
    float strokes = mix(stroke(p, 0.5, 11.0), stroke(p, 2.2, 23.0), smoothstep(0.38, 0.62, patch_of));
    float grain = cloud(vec3(p * 14.0, 31.0), 2);
    height = 0.7 * cloud(vec3(p * 0.8, 7.0), 3) + 0.5 * strokes + 0.13 * grain;
}
