layout(location = 0) in vec4 place_and_size;           // world; radius
layout(location = 1) in vec4 stretch_opacity_kind;     // world units in the plane of the screen
layout(location = 2) in vec3 sprite_colour;

out vec2 disc;  // -1 to 1; x along its way
out float opacity;
flat out int kind;
flat out vec3 base_colour;
flat out float seed;
flat out vec2 way;        // unit, where it goes on the screen
flat out float slimness;  // 0: round, 1: a streak

void main()
{
    disc = vec2((gl_VertexID & 1) == 0 ? -1.0 : 1.0, (gl_VertexID & 2) == 0 ? -1.0 : 1.0);
    opacity = stretch_opacity_kind.z;
    kind = int(stretch_opacity_kind.w + 0.5);
    base_colour = sprite_colour;
    seed = float(gl_InstanceID);
    // The eye looks along -z: the plane of the screen is x and y.
    vec2 reach = stretch_opacity_kind.xy;
    float beyond = length(reach);
    way = beyond > 1e-6 ? reach / beyond : vec2(1.0, 0.0);
    float size = place_and_size.w;
    // What is smaller than a pixel is drawn as large as one, and fainter.
    vec4 middle = frame.view_projection * vec4(place_and_size.xyz, 1.0);
    float pixel = 1.1 * middle.w / (0.5 * frame.viewport.y * length(frame.view_projection[1].xyz));
    if (size < pixel) {
        opacity *= size / pixel;
        size = pixel;
    }
    slimness = beyond / (size + beyond);
    vec2 corner = way * disc.x * (size + beyond) + vec2(-way.y, way.x) * disc.y * size;
    gl_Position = frame.view_projection * vec4(place_and_size.xyz + vec3(corner, 0.0), 1.0);
}
