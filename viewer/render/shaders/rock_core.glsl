// The inside of an asteroid: a burnt crust, bent strata, pockets of crystals, and a heart that still glows, with cracks
// through which its light comes. Distances from the object's origin, in shares of its size.
void describe(Look look, Place place, inout Surface s)
{
    vec3 p = place.pattern;
    float pixel = place.pixel * pattern_scale;
    vec3 bend = vec3(noise(p * 5.0), noise(p * 5.0 + 31.0), noise(p * 5.0 + 57.0)) - 0.5;
    float depth = length(p + 0.10 * bend);
    vec3 rough_slope, sand_slope;
    float rough = cloud(p * 34.0, 3, 34.0 * pixel, rough_slope);
    float sand = mix(0.5, noise(p.zxy * 290.0, sand_slope), clamp(1.4 - 230.0 * pixel, 0.0, 1.0));

    // Strata like shells that were folded.
    float layer = 26.0 * (depth + 0.05 * bend.y + 0.012 * rough);
    float which = floor(layer), within = layer - which;
    float tone = fract(0.618 * which + 0.13);
    vec3 strata = mix(look.colour.rgb, look.second.rgb, smoothstep(0.35, 0.9, tone) * 0.85);
    strata = mix(strata, look.third.rgb * 1.8, 0.7 * smoothstep(0.3, 0.05, tone));
    strata *= (0.72 + 0.5 * rough) * (0.85 + 0.3 * smoothstep(0.0, 0.25, within));
    // Grains of minerals.
    vec3 grain = cells(p * 46.0 + 3.0 * bend);
    strata *= 0.78 + 0.44 * grain.z;
    strata = mix(strata, vec3(0.52, 0.48, 0.42), 0.7 * step(0.90, grain.z) * (1.0 - smoothstep(0.12, 0.30, grain.x)));

    // Towards the heart the stone is dark and cracked.
    vec3 block = cells(p * 14.0 + 2.6 * bend + 0.5 * (rough - 0.5));
    float heat = 1.0 - smoothstep(0.05, 0.25, depth + 0.05 * (rough - 0.5));
    float heart = 1.0 - smoothstep(0.055, 0.115, depth + 0.05 * (rough - 0.5));
    float crack = (1.0 - smoothstep(0.0, 0.03 + 0.13 * heat * heat + 8.0 * pixel, block.y)) * smoothstep(0.02, 0.45, heat);
    s.albedo = mix(strata, look.third.rgb * (0.6 + 0.8 * rough), 0.75 * heat);

    // Crystals in pockets of the layers.
    float pocket = smoothstep(0.60, 0.64, cloud(p * 7.5 + 23.0, 2)) * (1.0 - smoothstep(0.02, 0.2, heat));
    vec3 away;
    vec3 crystal = cells(p.yxz * 58.0, away);
    vec3 gem = mix(vec3(0.30, 0.13, 0.50), vec3(0.22, 0.52, 0.66), smoothstep(0.35, 0.65, noise(p * 6.0 + 70.0)));
    gem *= 0.35 + 1.3 * crystal.z;
    float facet = smoothstep(0.0, 0.12 + 116.0 * pixel, crystal.y);
    s.albedo = mix(s.albedo, gem * mix(1.9, 1.0, facet), pocket);
    // The crust was melted once.
    float crust = smoothstep(0.31, 0.35, depth + 0.02 * (rough - 0.5));
    s.albedo = mix(s.albedo, look.third.rgb * (0.8 + 0.8 * rough), 0.55 * crust * (1.0 - pocket));
    s.albedo *= 0.85 + 0.30 * sand;

    // Iron-white in the middle, orange around it, red in the last cracks.
    float melt = max(heart * (0.55 + 0.45 * smoothstep(0.25, 0.6, rough)), crack * (0.20 + 0.80 * heat));
    vec3 hot = mix(vec3(0.85, 0.07, 0.01), vec3(2.3, 0.75, 0.10), smoothstep(0.15, 0.65, melt));
    hot = mix(hot, vec3(3.0, 1.9, 0.75), smoothstep(0.75, 1.0, melt));
    s.glow = hot * melt + vec3(0.16, 0.022, 0.004) * heat * (0.5 + 0.5 * rough);
    s.albedo *= 1.0 - 0.8 * melt;

    // Each crystal is a flat face with a tilt of its own. All slopes are worked out: this relief is as fine as pixels.
    vec3 tilt = fract(crystal.z * vec3(17.0, 113.0, 761.0)) - 0.5;
    s.slope = (1.0 - pocket) * (0.16 * rough_slope + 0.29 * shown(290.0 * pixel) * sand_slope.yzx) +
              pocket * (0.9 * tilt - 0.2 * away.yxz / max(crystal.x, 1e-4));
    s.roughness = mix(mix(0.85, 0.95, heat), 0.22, pocket);
    s.reflectance = mix(0.03, 0.08, pocket);
}
