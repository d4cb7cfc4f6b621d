in vec2 disc;
in float opacity;
flat in int kind;
flat in vec3 base_colour;
flat in float seed;
flat in vec2 way;
flat in float slimness;

out vec4 colour;  // multiplied by its opacity

void main()
{
    float square = dot(disc, disc);
    if (square > 1.0) discard;
    if (kind == 1) {
        float glow = exp(-5.0 * square) * (1.0 - square);
        colour = vec4(opacity * (1.6 * base_colour * glow + vec3(1.0) * pow(glow, 4.0)), 0.0);
    } else if (kind == 2) {
        float puff = cloud(vec3(disc * 1.6, seed * 7.31), 3);
        float thick = smoothstep(1.0, 0.1, square) * smoothstep(0.25, 0.75, puff);
        float alpha = 0.6 * opacity * thick;
        vec3 light = base_colour * (0.6 + 0.5 * disc.y) * (frame.light_colour.rgb + frame.sky_colour.rgb);
        colour = vec4(alpha * toned(light), alpha);
    } else if (kind == 3) {
        float puff = noise(vec3(disc * 2.3, seed * 3.17));
        float thin = (1.0 - square) * (1.0 - square) * mix(0.35, 1.0, puff);
        float alpha = opacity * thin;
        colour = vec4(alpha * toned(base_colour * (0.7 * frame.light_colour.rgb + frame.sky_colour.rgb)), alpha);
    } else if (kind == 4) {
        // A chip of five or six sides, of which the lamp finds each another way.
        float angle = atan(disc.y, disc.x) + 6.2832 * fract(seed * 0.618), sides = 5.0 + mod(seed, 2.0);
        float sector = floor(angle / 6.2832 * sides), middle = (sector + 0.5) / sides * 6.2832;
        if (length(disc) * cos(angle - middle) > 0.66) discard;
        float face = fract(sin(seed * 12.9898 + sector * 4.1414) * 43758.5453);
        vec3 light = base_colour * (frame.light_colour.rgb * mix(0.25, 1.0, face) + frame.sky_colour.rgb);
        colour = vec4(opacity * toned(light), opacity);
    } else {
        // A drop: round at its head, drawn out to a thin tail.
        float tail = mix(1.0, 0.16 + 0.84 * smoothstep(-1.0, 0.55, disc.x), slimness);
        vec2 p = vec2(disc.x, disc.y / tail);
        float r2 = dot(p, p);
        if (r2 > 1.0) discard;
        vec3 n = vec3(p.x * way + p.y * vec2(-way.y, way.x), sqrt(1.0 - r2));
        vec3 l = frame.to_light.xyz;
        // Light from the lamp gathers on the far side of a drop; its rim shows what is darkest in the room.
        float gathered = smoothstep(0.1, 0.8, dot(n.xy, -normalize(l.xy)));
        float rim = smoothstep(0.35, 0.95, r2);
        vec3 deep = base_colour * mix(base_colour, vec3(1.0), 0.35);
        vec3 light = mix(base_colour, deep, 0.25 + 0.6 * rim) * (0.55 * frame.light_colour.rgb + frame.sky_colour.rgb);
        light += base_colour * gathered * (1.0 - 0.5 * rim) * 0.8 * frame.light_colour.rgb;
        float shine = pow(max(dot(n, normalize(l + vec3(0.0, 0.0, 1.0))), 0.0), 60.0);
        float alpha = opacity * (1.0 - smoothstep(0.40, 1.0, r2)) * mix(0.62, 0.95, max(rim, gathered));
        float bright = opacity * shine;
        colour = vec4(alpha * toned(light) + 0.9 * bright, min(alpha + 0.6 * bright, 1.0));
    }
}
