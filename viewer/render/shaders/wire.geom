layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;

noperspective out vec3 distance_to_edge;  // pixels

// Baerentzen et al., "Single-pass wireframe rendering", 2006. A triangle with a corner behind the eye has no picture on
// the screen plane to measure in; it is drawn without edges.
void main()
{
    vec2 corner[3];
    bool is_seen = true;
    for (int i = 0; i < 3; ++i) {
        is_seen = is_seen && gl_in[i].gl_Position.w > 1e-6;
        corner[i] = 0.5 * frame.viewport.xy * gl_in[i].gl_Position.xy / max(gl_in[i].gl_Position.w, 1e-6);
    }
    for (int i = 0; i < 3; ++i) {
        vec2 a = corner[(i + 1) % 3], b = corner[(i + 2) % 3];
        vec2 side = b - a;
        float size = length(side);
        vec2 to_corner = corner[i] - a;
        float height = size > 1e-6 ? abs(side.x * to_corner.y - side.y * to_corner.x) / size : 0.0;
        distance_to_edge = is_seen ? vec3(0.0) : vec3(1e3);
        if (is_seen) distance_to_edge[i] = height;
        gl_Position = gl_in[i].gl_Position;
        gl_ClipDistance[0] = gl_in[i].gl_ClipDistance[0];
        EmitVertex();
    }
    EndPrimitive();
}
