in vec2 place;

// What is too fine for the relief of the whole wall: sand, pits where grains fell out, scratches of the trowel.
out vec4 grain;  // slope x, slope y (0.5: flat), tone, gloss

float fine_height(vec2 p)
{
    mat2 turn = mat2(0.8, 0.6, -0.6, 0.8);
    float sand = 0.6 * noise(vec3(turn * p * 62.0, 3.0)) + 0.4 * noise(vec3(p * 117.0, 9.0));
    vec3 pit = cells(vec3(p * 13.0, 0.5));
    float pits = step(0.62, pit.z) * (1.0 - smoothstep(0.05, 0.09 + 0.16 * pit.z * pit.z, pit.x));
    vec2 along = vec2(0.94, 0.34);
    vec2 q = vec2(dot(p, along), dot(p, vec2(-along.y, along.x)));
    float scratch = smoothstep(0.74, 0.86, noise(vec3(q * vec2(3.0, 88.0), 17.0))) * noise(vec3(q * 5.0, 2.0));
    float lumps = cloud(vec3(p * 9.0, 29.0), 3);
    return 0.30 * sand + 0.55 * lumps - 0.24 * pits - 0.22 * scratch;
}

// The same, made periodic: towards the far sides it turns into what comes before the near ones. Mirrored instead, the
// scratches would be rows of arrows.
float tiled_height(vec2 p)
{
    const float kMean = 0.40;  // of fine_height()
    vec2 far = smoothstep(0.6, 1.0, p);
    vec2 near = 1.0 - far;
    float sum = near.x * near.y * (fine_height(p) - kMean) +
                far.x * near.y * (fine_height(p - vec2(1.0, 0.0)) - kMean) +
                near.x * far.y * (fine_height(p - vec2(0.0, 1.0)) - kMean) +
                far.x * far.y * (fine_height(p - 1.0) - kMean);
    // Averages are flatter than what they are made of.
    vec2 weight = near * near + far * far;
    return kMean + sum * inversesqrt(weight.x * weight.y);
}

void main()
{
    vec2 texel = vec2(1.0 / 512.0);
    float here = tiled_height(place);
    vec2 slope = vec2(tiled_height(place + vec2(texel.x, 0.0)), tiled_height(place + vec2(0.0, texel.y))) - here;
    grain = vec4(0.5 + 0.5 * clamp(4.0 * slope, -1.0, 1.0), clamp(0.25 + here, 0.0, 1.0), 1.0);
}
