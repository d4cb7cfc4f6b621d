in vec2 place;

uniform sampler2D height_map;
uniform float depth;  // of the relief, in heights of the texture

out vec4 baked;  // slope x, slope y (0.5: flat), tone, hollow

void main()
{
    vec2 texel = 1.0 / vec2(textureSize(height_map, 0));
    float here = texture(height_map, place).r;
    float dx = texture(height_map, place + vec2(texel.x, 0.0)).r - texture(height_map, place - vec2(texel.x, 0.0)).r;
    float dy = texture(height_map, place + vec2(0.0, texel.y)).r - texture(height_map, place - vec2(0.0, texel.y)).r;
    vec2 slope = depth * vec2(0.5 * dx, dy) / (2.0 * texel);  // the texture is twice as wide as high
    float around = 0.0;
    for (int i = 0; i < 8; ++i) {
        float angle = 0.785398 * float(i);
        around += texture(height_map, place + 6.0 * texel * vec2(cos(angle), sin(angle))).r;
    }
    float hollow = clamp(0.5 + 5.0 * (here - around / 8.0), 0.0, 1.0);
    baked = vec4(0.5 + 0.5 * clamp(slope, -1.0, 1.0), clamp(here, 0.0, 1.0), hollow);
}
