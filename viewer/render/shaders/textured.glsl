uniform bool is_cap;

// A bump's slope from the differences to the neighbouring pixels (Mikkelsen, "Bump mapping unparametrized surfaces on
// the GPU", 2010).
vec3 bumped(vec3 n, SurfacePoint point, float height, vec3 gradient)
{
    vec3 r1 = cross(point.world_dy, n), r2 = cross(n, point.world_dx);
    float det = dot(point.world_dx, r1);
    vec2 steps = steps_of(height);
    vec3 slope = sign(det) * (steps.x * r1 + steps.y * r2);
    // The differences are those of two by two pixels: a step between two such blocks is seen, one within a block is a
    // cliff. Limited, an edge is not dotted black and white.
    const float kSteepest = 1.3;
    float steepness = length(slope) / max(kSteepest * abs(det), 1e-20);
    slope *= inversesqrt(1.0 + steepness * steepness);
    vec3 result = abs(det) * (n - gradient + dot(gradient, n) * n) - slope;
    return dot(result, result) > 1e-20 ? normalize(result) : n;
}

// Place.pixel of a cut. Seen aslant a pixel is long there: taken for its length, as fwidth() takes it, the segments of an
// orange would be one brown.
float pixel_of(vec3 dx, vec3 dy)
{
    float sum = dot(dx, dx) + dot(dy, dy), area = length(cross(dx, dy));
    // The axes of a pixel's outline on the cut: singular values.
    float longer = sqrt(0.5 * (sum + sqrt(max(sum * sum - 4.0 * area * area, 0.0))));
    float shorter = area / max(longer, 1e-20);
    return min(length(abs(dx) + abs(dy)), max(1.42 * shorter, 0.5 * longer));
}

// What a point sends to the eye.
vec3 light_from(SurfacePoint point)
{
    Look look = looks[look_index];
    float pixel = is_cap ? pixel_of(point.mesh_dx, point.mesh_dy) : length(abs(point.mesh_dx) + abs(point.mesh_dy));
    vec3 v = normalize(frame.eye.xyz - point.world);
    mat3 turn = model_turn();
    Place place = Place(point.mesh, point.pattern, normalize(transpose(turn) * v), point.uv, pixel, is_cap);
    Surface s = Surface(look.colour.rgb, 0.0, vec3(0.0), look.finish.x, look.finish.y, look.finish.z,
                        look.colour.rgb, 0.0, 0.0, vec3(0.0));
    describe(look, place, s);

    vec3 flat_n = point.normal;
    vec3 n = bumped(flat_n, point, s.height * length(turn[0]), turn * s.slope / length(turn[0]));

    vec3 l = frame.to_light.xyz;
    vec3 h = normalize(l + v);
    float nl = dot(n, l), nv = max(dot(n, v), 1e-3), nh = max(dot(n, h), 0.0), vh = max(dot(v, h), 0.0);
    float lit = max(nl, 0.0);
    float arriving = lit > 0.0 ? light_at(point.world, flat_n, 1.2) : 0.0;

    // Microfacets (Trowbridge-Reitz) with the usual approximations for shadowing and Fresnel.
    float a = s.roughness * s.roughness, a2 = a * a;
    float d = a2 / max(3.14159 * pow(nh * nh * (a2 - 1.0) + 1.0, 2.0), 1e-4);
    float k = 0.5 * a + 1e-3;
    float masking = 0.25 / ((lit * (1.0 - k) + k) * (nv * (1.0 - k) + k));
    bool is_metal = s.reflectance > 0.5;
    vec3 f0 = is_metal ? s.albedo : vec3(s.reflectance);
    vec3 fresnel = f0 + (1.0 - f0) * pow(1.0 - vh, 5.0);
    vec3 diffuse = is_metal ? s.albedo * 0.12 : s.albedo * (1.0 - 0.4 * s.depth);

    vec3 up = mix(frame.ground_colour.rgb, frame.sky_colour.rgb, 0.5 + 0.5 * n.y);
    vec3 light = diffuse * up;
    // What comes through from the other side, and round the edge of the light, is as warm as the flesh.
    float round_edge = max((nl + s.depth) / (1.0 + s.depth), 0.0) - lit;
    light += s.depth * s.through * (0.35 * up + frame.light_colour.rgb * (0.08 + 0.8 * round_edge));
    if (is_cap) {
        // Flesh is full of the light that falls on its other sides, and a cut in the shade shows it: in the flesh's own
        // colours, and not where light comes straight.
        float shade = 1.0 - smoothstep(0.0, 0.45, max(dot(flat_n, l), 0.0) * arriving);
        light += shade * min(8.0 * s.depth, 1.0) * (0.14 + 0.27 * s.depth) * frame.light_colour.rgb * s.albedo;
    }
    light += frame.light_colour.rgb * arriving * lit * (diffuse + 3.14159 * d * masking * fresnel);

    // The room is mirrored as a bright ceiling over a dark floor, blurred by roughness.
    vec3 r = reflect(-v, n);
    // A cut is rough in the small: seen edge on it keeps its colour.
    float grazing = (is_cap ? 0.25 : 1.0) * pow(1.0 - nv, 5.0);
    vec3 edge = f0 + (max(vec3(1.0 - s.roughness), f0) - f0) * grazing;
    float ceiling = smoothstep(-0.2 - s.roughness, 0.5 + s.roughness, r.y);
    light += edge * mix(frame.ground_colour.rgb, 2.2 * frame.sky_colour.rgb, ceiling);

    // Juice is a second, smooth surface above the first, which evens the relief out.
    if (s.wet > 0.0) {
        vec3 film = normalize(mix(flat_n, n, 0.45));
        float film_nh = max(dot(film, h), 0.0), film_nv = max(dot(film, v), 1e-3);
        const float kFilm2 = 0.0009;  // roughness 0.17, to the fourth power
        float film_d = kFilm2 / (3.14159 * pow(film_nh * film_nh * (kFilm2 - 1.0) + 1.0, 2.0) + 1e-5);
        // A flat cut that happens to mirror the light would be a sheet of glare: juice stands on it in patches.
        float patches = smoothstep(0.50, 0.66, noise(point.pattern * 17.0));
        light += s.wet * frame.light_colour.rgb * arriving * lit * min(0.003 * film_d, 0.006 + 0.030 * patches);
        float film_edge = 0.02 + (is_cap ? 0.16 : 0.45) * pow(1.0 - film_nv, 5.0);
        float film_ceiling = smoothstep(-0.25, 0.6, reflect(-v, film).y);
        light += s.wet * film_edge * mix(frame.ground_colour.rgb, 2.2 * frame.sky_colour.rgb, film_ceiling);
    }

    // Hair and cloth shine where they are seen edge on.
    light += s.fuzz * s.albedo * pow(1.0 - nv, 3.0) * (frame.sky_colour.rgb + 0.5 * arriving * frame.light_colour.rgb);
    return light + s.glow;
}
