in vec2 from_middle;
in vec2 on_wall;
flat in vec4 base;
flat in float shape;
flat in float run;

uniform float light_radius;

out vec4 colour;  // multiplied by its opacity

// A blob's thickness: 1 in its middle, 0 from its edge on.
float blob(vec2 p, float radius)
{
    return smoothstep(1.0, 0.55, length(p) / radius);
}

// Where juice lies, 0 to 1: a body with fingers, droplets that were thrown out, drips that run down.
float thickness(vec2 p)
{
    float seed = 91.7 * shape;
    float angle = atan(p.y, p.x);
    vec2 turn = vec2(cos(angle), sin(angle));
    float fingers = noise(vec3(2.6 * turn, seed));
    float fine = noise(vec3(7.0 * turn, seed + 5.0));
    float edge = 0.42 + 0.42 * fingers * fingers + 0.30 * smoothstep(0.55, 0.95, fine);
    float t = smoothstep(edge, edge - 0.16, length(p));
    for (int i = 0; i < 9; ++i) {
        vec3 dice = vec3(float(i) * 3.7, seed, 1.5);
        float where = 6.2832 * noise(dice * 1.7 + 0.5);
        float far = 0.75 + 0.85 * noise(dice + 11.0);
        float radius = 0.035 + 0.10 * noise(dice + 23.0) * noise(dice + 31.0);
        t = max(t, blob(p - far * vec2(cos(where), sin(where)), radius));
    }
    for (int i = 0; i < 4; ++i) {
        vec3 dice = vec3(float(i) * 5.3, seed, 7.5);
        float x = mix(-0.42, 0.42, (float(i) + noise(dice)) / 4.0);
        float far = run * (0.25 + 0.75 * noise(dice + 3.0));
        float top = -0.15, bottom = -0.4 - far;
        float down = clamp((top - p.y) / (top - bottom), 0.0, 1.0);
        float width = mix(0.075, 0.035, down) * (0.7 + 0.6 * noise(dice + 17.0));
        float wobble = 0.03 * (noise(vec3(p.y * 3.0, dice.xy)) - 0.5);
        float body = p.y < top && p.y > bottom ? smoothstep(1.0, 0.5, abs(p.x - x - wobble) / width) : 0.0;
        float tip = blob(p - vec2(x + wobble, bottom), 1.35 * width);
        t = max(t, max(0.8 * body, tip));
    }
    return t;
}

void main()
{
    float t = thickness(from_middle);
    // Seen from above thick juice bulges: its rim catches the light of the lamp.
    vec2 slope = vec2(dFdx(t), dFdy(t)) / max(fwidth(from_middle.x), 1e-5);
    if (t <= 0.004 || base.a <= 0.0) discard;
    vec3 n = normalize(vec3(-0.10 * slope, 1.0));
    float from_lamp = length((on_wall - vec2(-0.12, 0.16) * light_radius) / light_radius);
    float pool = 0.24 + 0.76 * exp(-1.05 * from_lamp * from_lamp);
    vec3 l = frame.to_light.xyz;
    float shine = pow(max(dot(n, normalize(l + vec3(0.0, 0.0, 1.0))), 0.0), 24.0);
    vec3 body = base.rgb * mix(0.9, 0.5, t);
    vec3 light = pool * (body * (0.55 * frame.light_colour.rgb * max(dot(n, l), 0.0) + 0.6 * frame.sky_colour.rgb));
    light += pool * base.a * 0.22 * shine * t * (1.0 - t) * 4.0;
    float alpha = base.a * smoothstep(0.0, 0.25, t) * mix(0.72, 0.88, t);
    colour = vec4(alpha * toned(light), alpha);
}
