// What all programs of a frame share; FrameBlock in frame_uniforms.h has the same layout.
layout(std140) uniform Frame
{
    mat4 view_projection;
    mat4 shadow_transform;   // world to shadow map, 0 to 1
    vec4 eye;                // world
    vec4 to_light;           // unit, towards the key light; w: strength of the shadow, 0 to 1
    vec4 light_colour;
    vec4 sky_colour;         // ambient light from above
    vec4 ground_colour;      // ambient light from below
    vec4 viewport;           // width, height in pixels; exposure; time in seconds
    mat4 to_world;           // view_projection undone
    vec4 picture;            // lower left corner on the target in pixels; samples a pixel
    vec4 clip;               // of objects that are clipped what has a product with it below 0 is not drawn
} frame;
