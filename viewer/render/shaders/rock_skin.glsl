// Stone that was hit for a long time: craters in craters, dust in patches, pale veins, grains. All in shares of the
// object's size, so that it is the same for any number of triangles.

// A crater around a cell's point: a bowl with a raised rim. Height in depths of the bowl; `inside`: 1 in the bowl. The
// slope is worked out, not taken from the neighbouring pixels: rims are too sharp for that.
float crater(vec3 p, out float inside, out vec3 slope)
{
    vec3 away;
    vec3 cell = cells(p, away);
    // Few are large, some cells have none.
    float radius = 0.10 + 0.38 * cell.z * cell.z;
    float r = cell.x / radius;
    float exists = step(0.28, fract(cell.z * 7.3));
    inside = exists * (1.0 - smoothstep(0.75, 1.05, r));
    float bowl = min(r * r - 1.0, 0.0);
    float rim = exp(-14.0 * (r - 1.06) * (r - 1.06));
    float steep = 4.2 * r * (1.0 - smoothstep(0.94, 1.06, r)) - 22.4 * (r - 1.06) * rim;
    slope = exists * steep * away / max(cell.x, 1e-4);
    return exists * radius * (2.1 * bowl + 0.8 * rim);
}

void describe(Look look, Place place, inout Surface s)
{
    vec3 p = place.pattern;
    vec3 bent = p + 0.045 * (vec3(noise(p * 9.0), noise(p * 9.0 + 31.0), noise(p * 9.0 + 57.0)) - 0.5);
    float large_bowl, small_bowl;
    vec3 large_slope, small_slope;
    float large = crater(bent * look.second.w, large_bowl, large_slope);
    float small = crater(bent.zxy * 2.9 * look.second.w + 5.0, small_bowl, small_slope);
    float pixel = place.pixel * pattern_scale;
    // From afar small craters are no more than a roughness.
    float near = 1.0 - smoothstep(0.003, 0.008, pixel);
    small *= near;
    small_bowl *= 0.3 + 0.7 * near;
    vec3 rough_slope, sand_slope;
    float rough = cloud(p * 38.0, 3, 38.0 * pixel, rough_slope);
    float sand = mix(0.5, noise(p.yzx * 310.0 + 2.0, sand_slope), clamp(1.4 - 250.0 * pixel, 0.0, 1.0));

    // Bare dark stone, dust where it stayed, rust here and there.
    float patches = cloud(p * 4.2 + 3.0, 3);
    float dusty = smoothstep(0.36, 0.66, patches + 0.22 * (rough - 0.5) + 0.10 * large_bowl);
    vec3 stone = look.second.rgb * (0.65 + 0.75 * rough);
    vec3 dust = look.colour.rgb * (0.78 + 0.44 * rough);
    vec3 albedo = mix(stone, dust, dusty);
    float rust = smoothstep(0.56, 0.74, cloud(p.zyx * 6.1 + 11.0, 2));
    albedo = mix(albedo, albedo * vec3(1.55, 0.92, 0.62), 0.6 * rust);
    // What was thrown out lies pale on the rims; the bottoms are dark.
    albedo *= 1.0 - 0.34 * large_bowl - 0.28 * small_bowl;
    albedo = mix(albedo, look.third.rgb, 0.30 * smoothstep(0.05, 0.30, large) + 0.22 * smoothstep(0.05, 0.22, small));

    // Veins: where a slow noise passes its middle.
    float vein_at = abs(cloud(bent * 5.3 + 20.0, 2) - 0.5);
    float width = 0.006 + 0.010 * noise(p * 13.0);
    float vein = 1.0 - smoothstep(width, width + 0.006 + 6.0 * pixel, vein_at);
    vein *= smoothstep(0.38, 0.58, noise(p * 6.0 + 40.0));
    albedo = mix(albedo, look.third.rgb * 1.25, 0.75 * vein);
    s.albedo = albedo * (0.80 + 0.40 * sand);

    // All slopes are worked out: this relief is as fine as pixels.
    s.slope = 0.62 * (large_slope + near * small_slope.yzx) + 48.0 * look.finish.w * rough_slope +
              0.37 * shown(310.0 * pixel) * sand_slope.zxy;
    s.roughness = mix(0.9, 0.5, vein);
    s.reflectance = 0.03;
}
