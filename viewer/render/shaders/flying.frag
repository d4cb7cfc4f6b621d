in vec2 disc;
in float opacity;
flat in int kind;
flat in vec3 base_colour;
flat in float seed;

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
    } else {
        vec3 n = vec3(disc, sqrt(1.0 - square));
        vec3 l = frame.to_light.xyz;
        float lit = 0.45 + 0.55 * max(dot(n, l), 0.0);
        // Light that goes through a drop leaves it on the far side.
        float through = pow(max(dot(n.xy, -l.xy), 0.0), 2.0);
        float shine = pow(max(dot(n, normalize(l + vec3(0.0, 0.0, 1.0))), 0.0), 40.0);
        vec3 light = base_colour * (lit * frame.light_colour.rgb + frame.sky_colour.rgb);
        light += base_colour * through * frame.light_colour.rgb + 1.8 * shine;
        float alpha = opacity * smoothstep(1.0, 0.75, square) * 0.92;
        colour = vec4(alpha * toned(light), alpha);
    }
}
