// The patterns of common materials. Each pattern file has a function describe(); a program is made with one of them.

// Wood that was a tree along y: rings around the axis, bent a little, and fibres along it.
vec3 wood(Look look, vec3 p, out float height)
{
    vec3 q = p * look.second.w;
    float bend = cloud(q * vec3(0.55, 0.16, 0.55), 2);
    float radius = length(q.xz + vec2(0.37, -0.21)) + 1.1 * bend;
    float ring = fract(radius);
    // Spring wood is wide and pale, autumn wood narrow and dark.
    float dark = smoothstep(0.25, 0.88, ring) * (1.0 - smoothstep(0.9, 1.0, ring));
    float fibre = noise(q * vec3(19.0, 1.3, 19.0));
    float pores = smoothstep(0.72, 0.9, noise(q * vec3(31.0, 2.6, 31.0)));
    float tone = cloud(q * 0.7 + 5.0, 2);
    vec3 colour = mix(look.colour.rgb, look.second.rgb, look.third.w * dark);
    colour = mix(colour, look.third.rgb, 0.28 * fibre + 0.35 * pores * dark);
    height = 0.4 * fibre - 0.5 * pores;
    return colour * (0.86 + 0.28 * tone);
}

// Grains of three minerals.
vec3 stone(Look look, vec3 p, out float height)
{
    vec3 q = p * look.second.w;
    float cloudy = cloud(q * 0.35, 3);
    float grain = noise(q * 3.1);
    float speck = noise(q * 5.7 + 9.0);
    vec3 colour = mix(look.colour.rgb, look.second.rgb, look.third.w * smoothstep(0.35, 0.7, grain));
    colour = mix(colour, look.third.rgb, look.third.w * smoothstep(0.68, 0.8, speck));
    height = grain - 0.6 * smoothstep(0.68, 0.8, speck);
    return colour * (0.78 + 0.44 * cloudy);
}

// Metal brushed around y.
vec3 brushed(Look look, vec3 p, out float height)
{
    vec3 q = p * look.second.w;
    float line = noise(vec3(q.x * 0.6, q.y * 17.0, q.z * 0.6));
    height = line;
    return mix(look.colour.rgb, look.second.rgb, look.third.w * line);
}

// Short hair: streaks along y with tufts.
vec3 fur(Look look, vec3 p, out float height)
{
    vec3 q = p * look.second.w;
    float streak = noise(q * vec3(9.0, 2.6, 9.0));
    float tuft = cloud(q * 1.1, 2);
    height = 1.4 * streak;
    return mix(look.colour.rgb, look.second.rgb, look.third.w * streak) * (0.7 + 0.6 * tuft);
}

// Paint or lacquer: a plain colour, hardly alive.
vec3 coat(Look look, vec3 p, out float height)
{
    float tone = cloud(p * look.second.w, 2);
    height = 0.15 * tone;
    return mix(look.colour.rgb, look.second.rgb, look.third.w * tone);
}

// Crumbs and bubbles.
vec3 foam(Look look, vec3 p, out float height)
{
    vec3 q = p * look.second.w;
    float lump = noise(q * 2.3);
    float hole = smoothstep(0.62, 0.8, noise(q * 4.9 + 3.0));
    height = lump - hole;
    return mix(mix(look.colour.rgb, look.second.rgb, look.third.w * lump), look.third.rgb, 0.6 * hole);
}

vec3 colour_of(Look look, vec3 p, out float height)
{
    switch (int(look.colour.w + 0.5)) {
        case 1: return coat(look, p, height);
        case 2: return wood(look, p, height);
        case 3: return stone(look, p, height);
        case 4: return brushed(look, p, height);
        case 5: return fur(look, p, height);
        case 6: return foam(look, p, height);
        default: height = 0.0; return look.colour.rgb;
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
    float height;
    surface.albedo = colour_of(look, place.pattern, height);
    if (place.is_cap) {
        float mark = saw_marks(place.uv);
        surface.albedo *= 0.92 + 0.14 * mark;
        height += 0.5 * mark;
    }
    // Bumps are as deep as `finish.w` pattern units.
    surface.height = height * look.finish.w / pattern_scale;
}
