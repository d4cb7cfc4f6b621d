noperspective in vec3 distance_to_edge;

uniform vec4 line_colour;
uniform float line_width;  // pixels

out vec4 colour;

void main()
{
    float nearest = min(distance_to_edge.x, min(distance_to_edge.y, distance_to_edge.z));
    float cover = 1.0 - smoothstep(0.5 * line_width - 0.5, 0.5 * line_width + 0.5, nearest);
    if (cover < 0.01) discard;
    colour = vec4(line_colour.rgb, line_colour.a * cover);
}
