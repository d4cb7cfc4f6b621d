// Smooth noise over an integer lattice, the same on every driver that does integers right.
uint lattice_hash(ivec3 p)
{
    uint h = uint(p.x) * 0x9E3779B1u ^ uint(p.y) * 0x85EBCA77u ^ uint(p.z) * 0xC2B2AE3Du;
    h ^= h >> 15;
    h *= 0x2C1B3C6Du;
    h ^= h >> 13;
    return h;
}

float lattice_value(ivec3 p)
{
    return float(lattice_hash(p) & 0xFFFFu) / 65535.0;
}

// 0 to 1. `slope`: its gradient.
float noise(vec3 p, out vec3 slope)
{
    vec3 cell = floor(p);
    ivec3 i = ivec3(cell);
    vec3 t = p - cell;
    vec3 rise = 6.0 * t * (1.0 - t);
    t = t * t * (3.0 - 2.0 * t);
    vec4 low = vec4(lattice_value(i), lattice_value(i + ivec3(1, 0, 0)), lattice_value(i + ivec3(0, 1, 0)),
                    lattice_value(i + ivec3(1, 1, 0)));
    vec4 high = vec4(lattice_value(i + ivec3(0, 0, 1)), lattice_value(i + ivec3(1, 0, 1)),
                     lattice_value(i + ivec3(0, 1, 1)), lattice_value(i + ivec3(1, 1, 1)));
    vec4 along_z = mix(low, high, t.z);
    vec2 along_y = mix(along_z.xy, along_z.zw, t.y);
    vec2 up_y = along_z.zw - along_z.xy, up_z = mix(high.xy - low.xy, high.zw - low.zw, t.y);
    slope = rise * vec3(along_y.y - along_y.x, mix(up_y.x, up_y.y, t.x), mix(up_z.x, up_z.y, t.x));
    return mix(along_y.x, along_y.y, t.x);
}

float noise(vec3 p)
{
    vec3 slope;
    return noise(p, slope);
}

// 1 for relief that a picture can show, 0 for waves that are too short for it. `pixel`: Place::pixel in waves.
float shown(float pixel)
{
    return clamp(2.0 - 3.0 * pixel, 0.0, 1.0);
}

// Octaves of noise, 0 to 1. `slope`: the gradient of what a picture with pixels of this size can show.
float cloud(vec3 p, int octaves, float pixel, out vec3 slope)
{
    float sum = 0.0, weight = 0.5, weights = 0.0;
    slope = vec3(0.0);
    for (int i = 0; i < octaves; ++i) {
        vec3 along;
        sum += weight * noise(p, along);
        // What each octave turns and shrinks is turned back.
        float size = pow(2.03, float(i));
        along *= weight * size * shown(pixel * size);
        slope += i % 3 == 0 ? along : i % 3 == 1 ? along.zxy : along.yzx;
        weights += weight;
        p = p.yzx * 2.03 + 17.1;
        weight *= 0.5;
    }
    slope /= weights;
    return sum / weights;
}

// Octaves of noise, 0 to 1.
float cloud(vec3 p, int octaves)
{
    float sum = 0.0, weight = 0.5, weights = 0.0;
    for (int i = 0; i < octaves; ++i) {
        sum += weight * noise(p);
        weights += weight;
        p = p.yzx * 2.03 + 17.1;
        weight *= 0.5;
    }
    return sum / weights;
}

vec3 lattice_point(ivec3 p)
{
    uint h = lattice_hash(p);
    return vec3(h & 1023u, (h >> 10) & 1023u, (h >> 20) & 1023u) / 1023.0;
}

// Cells around scattered points: distance to the nearest one, how much farther the next one is, a number of the cell's
// own (Worley, "A cellular texture basis function", 1996). `away`: from the nearest point to here.
vec3 cells(vec3 p, out vec3 away)
{
    ivec3 home = ivec3(floor(p));
    float nearest = 9.0, next = 9.0, id = 0.0;
    for (int z = -1; z <= 1; ++z)
        for (int y = -1; y <= 1; ++y)
            for (int x = -1; x <= 1; ++x) {
                ivec3 cell = home + ivec3(x, y, z);
                vec3 at = lattice_point(cell);
                vec3 d = vec3(cell) + 0.15 + 0.7 * at - p;
                float square = dot(d, d);
                if (square < nearest) {
                    next = nearest;
                    nearest = square;
                    id = at.x;
                    away = -d;
                } else {
                    next = min(next, square);
                }
            }
    return vec3(sqrt(nearest), sqrt(next) - sqrt(nearest), id);
}

vec3 cells(vec3 p)
{
    vec3 away;
    return cells(p, away);
}
