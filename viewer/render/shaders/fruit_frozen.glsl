// A strawberry in a lump of ice. The facets are those of data/maker/fruit/frozen.cpp.
const int kFacets = 18;
const vec4 kFacet[kFacets] = vec4[kFacets](
    vec4(1.00, 0.07, 0.05, 0.50), vec4(-1.00, 0.05, -0.08, 0.52), vec4(0.05, 1.00, -0.06, 0.55),
    vec4(-0.06, -1.00, 0.05, 0.54), vec4(-0.05, 0.06, 1.00, 0.49), vec4(0.07, -0.05, -1.00, 0.50),
    vec4(1.00, 1.00, 0.90, 0.70), vec4(-0.90, 1.00, 1.10, 0.77), vec4(1.00, 0.80, -1.00, 0.78),
    vec4(-1.00, 1.10, -0.90, 0.69), vec4(0.90, -1.10, 1.00, 0.76), vec4(-1.00, -1.00, 0.80, 0.69),
    vec4(1.10, -0.90, -1.00, 0.68), vec4(-0.90, -1.00, -1.10, 0.79), vec4(0.25, 1.00, 0.90, 0.655),
    vec4(-1.00, 0.15, 0.90, 0.64), vec4(1.00, -0.95, -0.10, 0.665), vec4(-0.90, 0.10, -1.00, 0.66));

// A place in the ice.
struct Ice
{
    float depth;  // below the nearest facet
    float next;   // how much farther the next facet is: small at edges
    vec3 normal;  // of the nearest facet
};

Ice in_ice(vec3 p)
{
    Ice ice = Ice(9.0, 9.0, vec3(0.0));
    float second = 9.0;
    for (int i = 0; i < kFacets; ++i) {
        vec3 n = normalize(kFacet[i].xyz);
        float depth = kFacet[i].w - dot(n, p);
        if (depth < ice.depth) {
            second = ice.depth;
            ice.depth = depth;
            ice.normal = n;
        } else {
            second = min(second, depth);
        }
    }
    ice.next = second - ice.depth;
    return ice;
}

// Where a ray that starts inside leaves the ice, and a number of the facet's own.
vec2 way_out(vec3 p, vec3 along)
{
    vec2 out_ = vec2(9.0, 0.0);
    for (int i = 0; i < kFacets; ++i) {
        vec3 n = normalize(kFacet[i].xyz);
        float towards = dot(n, along);
        float way = (kFacet[i].w - dot(n, p)) / max(towards, 1e-4);
        if (towards > 1e-4 && way < out_.x) out_ = vec2(way, lattice_value(ivec3(i, 3, 5)));
    }
    return out_;
}

// Mesh coordinates to the strawberry's own: its axis is y, the tip below.
vec3 in_berry(vec3 p)
{
    const float kCos = cos(0.38), kSin = sin(0.38);
    vec3 q = p - vec3(0.01, -0.02, 0.0);
    return vec3(kCos * q.x - kSin * q.y, kSin * q.x + kCos * q.y, q.z);
}

// The share of the way from the strawberry's middle to its skin.
float berry_share(vec3 q)
{
    float y = q.y / 0.43;
    float wide = 0.375 * mix(0.60, 1.0, smoothstep(-1.1, 0.35, y));
    return length(vec3(q.x / wide, y, q.z / wide));
}

// Seeds in dimples on its skin. x: how much is seed; y: how much is dimple.
vec2 berry_seeds(vec3 q)
{
    vec3 dots = cells(q * 13.5);
    return vec2(1.0 - smoothstep(0.13, 0.19, dots.x), 1.0 - smoothstep(0.16, 0.42, dots.x));
}

// How much of its skin is leaf: a star at the shoulders.
float berry_leaf(vec3 q)
{
    float polar = acos(clamp(q.y / max(length(q), 1e-5), -1.0, 1.0));
    float point = 0.5 + 0.5 * cos(7.0 * atan(q.z, q.x));
    return 1.0 - smoothstep(-0.04, 0.04, polar - 0.36 - 0.62 * point * point);
}

vec3 berry_skin(vec3 q)
{
    vec2 seed = berry_seeds(q);
    vec3 red = mix(srgb(184.0, 2.0, 14.0), srgb(222.0, 18.0, 20.0), noise(q * 9.0));
    red = mix(red, srgb(120.0, 4.0, 16.0), 0.6 * seed.y);
    red = mix(red, srgb(250.0, 206.0, 96.0), seed.x);
    float vein = noise(q * 40.0);
    return mix(red, mix(srgb(40.0, 120.0, 36.0), srgb(116.0, 186.0, 70.0), vein), berry_leaf(q));
}

// What is seen from a place in the ice along a ray: the strawberry, or a facet behind. w: how far away it is.
vec4 through_ice(vec3 p, vec3 along)
{
    vec2 out_ = way_out(p, along);
    vec3 q = in_berry(p), step_ = in_berry(p + along) - q;
    // Sphere tracing (Hart 1996). The share changes by at most 1 / 0.22 a metre.
    float way = 0.0;
    for (int i = 0; i < 16 && way < out_.x; ++i) {
        float share = berry_share(q + way * step_);
        if (share < 1.02) break;
        way += (share - 1.0) * 0.22;
    }
    if (way < out_.x && berry_share(q + way * step_) < 1.12) {
        vec3 at = q + way * step_;
        const float kStep = 0.01;
        float here = berry_share(at);
        vec3 normal = normalize(vec3(berry_share(at + vec3(kStep, 0.0, 0.0)), berry_share(at + vec3(0.0, kStep, 0.0)),
                                     berry_share(at + vec3(0.0, 0.0, kStep))) - here);
        float facing = max(-dot(normal, step_), 0.0);
        return vec4(berry_skin(at) * (0.35 + 0.75 * facing), way);
    }
    vec3 behind = mix(srgb(34.0, 118.0, 196.0), srgb(150.0, 212.0, 244.0), out_.y);
    return vec4(behind, out_.x);
}

// White sheets where the ice has cracked: how white a ray becomes on a way of this length.
float cracks(vec3 p, vec3 along, float way)
{
    const vec4 kSheets[3] = vec4[3](vec4(0.62, 0.64, 0.45, 0.30), vec4(-0.70, 0.10, 0.71, 0.34), vec4(0.30, -0.86, 0.42, 0.33));
    float white = 0.0;
    for (int i = 0; i < 3; ++i) {
        float towards = dot(kSheets[i].xyz, along);
        float at = (kSheets[i].w - dot(kSheets[i].xyz, p)) / (abs(towards) < 1e-3 ? 1e-3 : towards);
        if (at < 0.0 || at > way) continue;
        vec3 q = p + at * along;
        float ragged = cloud(q * 5.0 + float(i) * 7.0, 3);
        white = max(white, smoothstep(0.57, 0.63, ragged) * (0.30 + 0.5 * noise(q * 26.0)));
    }
    return white;
}

// Bubbles along a ray, near its start.
float bubbles(vec3 p, vec3 along, float way)
{
    float found = 0.0;
    for (int i = 0; i < 2; ++i) {
        float at = 0.05 + 0.09 * float(i);
        if (at > way) continue;
        vec3 cell = cells((p + at * along) * (15.0 - 4.0 * float(i)));
        float ring = bell(cell.x - 0.16 * cell.z, 0.035);
        found = max(found, step(0.55, cell.z) * (0.7 * ring + 0.25 * step(cell.x, 0.16 * cell.z)));
    }
    return found;
}
