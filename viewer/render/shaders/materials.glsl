// The patterns of common materials. Each pattern file has a function describe(); a program is made with one of them.

// They say how steep their relief is, over pattern units: it is worked out, because patterns are as fine as pixels.

// The noise that `p` stretched has, and what its relief shows.
float waves(vec3 p, vec3 stretch, float pixel, out vec3 slope)
{
    float value = noise(p * stretch, slope);
    slope *= stretch * shown(pixel * max(stretch.x, max(stretch.y, stretch.z)));
    return value;
}

// How fast smoothstep() rises.
float smooth_rise(float low, float high, float x)
{
    float t = clamp((x - low) / (high - low), 0.0, 1.0);
    return 6.0 * t * (1.0 - t) / (high - low);
}

// Wood that was a tree along y: rings around the axis, bent a little, and fibres along it.
vec3 wood(Look look, vec3 q, float pixel, out vec3 slope)
{
    float bend = cloud(q * vec3(0.55, 0.16, 0.55), 2);
    float radius = length(q.xz + vec2(0.37, -0.21)) + 1.1 * bend;
    float ring = fract(radius);
    // Spring wood is wide and pale, autumn wood narrow and dark.
    float dark = smoothstep(0.25, 0.88, ring) * (1.0 - smoothstep(0.9, 1.0, ring));
    vec3 fibre_slope, pore_slope;
    float fibre = waves(q, vec3(19.0, 1.3, 19.0), pixel, fibre_slope);
    float pore = waves(q, vec3(31.0, 2.6, 31.0), pixel, pore_slope);
    float pores = smoothstep(0.72, 0.9, pore);
    float tone = cloud(q * 0.7 + 5.0, 2);
    vec3 colour = mix(look.colour.rgb, look.second.rgb, look.third.w * dark);
    colour = mix(colour, look.third.rgb, 0.28 * fibre + 0.35 * pores * dark);
    slope = 0.4 * fibre_slope - 0.5 * smooth_rise(0.72, 0.9, pore) * pore_slope;
    return colour * (0.86 + 0.28 * tone);
}

// Grains of three minerals.
vec3 stone(Look look, vec3 q, float pixel, out vec3 slope)
{
    vec3 grain_slope, speck_slope;
    float cloudy = cloud(q * 0.35, 3);
    float grain = waves(q, vec3(3.1), pixel, grain_slope);
    float speck = waves(q + 9.0 / 5.7, vec3(5.7), pixel, speck_slope);
    vec3 colour = mix(look.colour.rgb, look.second.rgb, look.third.w * smoothstep(0.35, 0.7, grain));
    colour = mix(colour, look.third.rgb, look.third.w * smoothstep(0.68, 0.8, speck));
    slope = grain_slope - 0.6 * smooth_rise(0.68, 0.8, speck) * speck_slope;
    return colour * (0.78 + 0.44 * cloudy);
}

// Metal brushed around y.
vec3 brushed(Look look, vec3 q, float pixel, out vec3 slope)
{
    float line = waves(q, vec3(0.6, 17.0, 0.6), pixel, slope);
    return mix(look.colour.rgb, look.second.rgb, look.third.w * line);
}

// Short hair: streaks along y with tufts.
vec3 fur(Look look, vec3 q, float pixel, out vec3 slope)
{
    float streak = waves(q, vec3(9.0, 2.6, 9.0), pixel, slope);
    slope *= 1.4;
    float tuft = cloud(q * 1.1, 2);
    return mix(look.colour.rgb, look.second.rgb, look.third.w * streak) * (0.7 + 0.6 * tuft);
}

// Paint or lacquer: a plain colour, hardly alive.
vec3 coat(Look look, vec3 q, float pixel, out vec3 slope)
{
    float tone = cloud(q, 2, pixel, slope);
    slope *= 0.15;
    return mix(look.colour.rgb, look.second.rgb, look.third.w * tone);
}

// Crumbs and bubbles.
vec3 foam(Look look, vec3 q, float pixel, out vec3 slope)
{
    vec3 lump_slope, hole_slope;
    float lump = waves(q, vec3(2.3), pixel, lump_slope);
    float bubble = waves(q + 3.0 / 4.9, vec3(4.9), pixel, hole_slope);
    float hole = smoothstep(0.62, 0.8, bubble);
    slope = lump_slope - smooth_rise(0.62, 0.8, bubble) * hole_slope;
    return mix(mix(look.colour.rgb, look.second.rgb, look.third.w * lump), look.third.rgb, 0.6 * hole);
}

vec3 colour_of(Look look, vec3 p, float pixel, out vec3 slope)
{
    switch (int(look.colour.w + 0.5)) {
        case 1: return coat(look, p, pixel, slope);
        case 2: return wood(look, p, pixel, slope);
        case 3: return stone(look, p, pixel, slope);
        case 4: return brushed(look, p, pixel, slope);
        case 5: return fur(look, p, pixel, slope);
        case 6: return foam(look, p, pixel, slope);
        default: slope = vec3(0.0); return look.colour.rgb;
    }
}

// The marks that a saw leaves, in the cap's own uv: they stay where the blade went while the object tumbles.
float saw_marks(vec2 uv)
{
    float across = uv.y * pattern_scale;
    float wave = across + 0.02 * sin(7.0 * uv.x * pattern_scale);
    return noise(vec3(wave * 52.0, uv.x * pattern_scale * 2.0, 3.0));
}

void describe(Look look, Place place, inout Surface surface)
{
    float size = look.second.w;
    vec3 slope;
    surface.albedo = colour_of(look, place.pattern * size, place.pixel * pattern_scale * size, slope);
    // Bumps are as deep as `finish.w` pattern units, and no cliffs.
    const float kSteepest = 1.3;
    slope *= size * look.finish.w;
    surface.slope = slope * inversesqrt(1.0 + dot(slope, slope) / (kSteepest * kSteepest));
    if (place.is_cap) {
        float mark = saw_marks(place.uv);
        surface.albedo *= 0.92 + 0.14 * mark;
        surface.height = 0.5 * mark * look.finish.w / pattern_scale;
    }
}
