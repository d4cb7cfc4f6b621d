// SurfaceLook in surface_look.h; the patterns are numbered there.
const int kMostLooks = 128;

struct Look
{
    vec4 colour;    // linear rgb; w: pattern
    vec4 second;    // linear rgb; w: pattern cells for one pattern unit
    vec4 third;     // linear rgb; w: contrast
    vec4 finish;    // roughness, reflectance, fuzz, depth of the bumps
};

layout(std140) uniform Looks
{
    Look looks[kMostLooks];
};
uniform int look_index;
uniform float pattern_scale;  // object units to pattern units

// Where on the object a pixel is.
struct Place
{
    vec3 object;    // mesh coordinates
    vec3 pattern;   // the same as shares of the object's size
    vec3 to_eye;    // mesh directions, unit
    vec2 uv;
    float pixel;    // side of a pixel, in mesh units: what is smaller is drawn as its mean
    bool is_cap;
};

// What light meets there.
struct Surface
{
    vec3 albedo;
    float height;       // of the relief, mesh units
    vec3 slope;         // of further relief that is not in `height`: its gradient over mesh coordinates
    float roughness;    // 0: mirror, 1: chalk
    float reflectance;  // seen straight on; above 0.5 it is a metal
    float fuzz;         // shine of hair and cloth
    vec3 through;       // what light becomes on its way through the flesh
    float depth;        // 0: light stays on the surface, 1: it comes round to the dark side
    float wet;          // a film of juice, 0 to 1
    vec3 glow;          // light of its own
};
