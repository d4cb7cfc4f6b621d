in vec3 world_position;
in vec3 world_normal;
in vec3 pattern_position;
in vec3 pattern_normal;
in vec2 pattern_uv;

uniform mat4 model;
uniform float pattern_scale;
uniform bool is_cap;

out vec4 colour;

// The marks that a saw leaves, in the cap's own uv: they stay where the blade went while the object tumbles.
float saw_marks(vec2 uv)
{
    float across = uv.y * pattern_scale;
    float wave = across + 0.02 * sin(7.0 * uv.x * pattern_scale);
    return noise(vec3(wave * 52.0, uv.x * pattern_scale * 2.0, 3.0));
}

// A bump's slope from the differences to the neighbouring pixels (Mikkelsen, "Bump mapping unparametrized surfaces on
// the GPU", 2010).
vec3 bumped(vec3 n, float height)
{
    vec3 dx = dFdx(world_position), dy = dFdy(world_position);
    vec3 r1 = cross(dy, n), r2 = cross(n, dx);
    float det = dot(dx, r1);
    vec3 slope = sign(det) * (dFdx(height) * r1 + dFdy(height) * r2);
    vec3 result = abs(det) * n - slope;
    return dot(result, result) > 1e-20 ? normalize(result) : n;
}

void main()
{
    Look look = looks[look_index];
    float height;
    vec3 albedo = colour_of(look, pattern_position, height);
    if (is_cap) {
        float mark = saw_marks(pattern_uv);
        albedo *= 0.92 + 0.14 * mark;
        height += 0.5 * mark;
    }

    vec3 n = normalize(gl_FrontFacing ? world_normal : -world_normal);
    vec3 flat_n = n;
    // Bumps are as deep as `finish.w` pattern units.
    n = bumped(n, height * look.finish.w / pattern_scale * length(model[0].xyz));

    vec3 v = normalize(frame.eye.xyz - world_position);
    vec3 l = frame.to_light.xyz;
    vec3 h = normalize(l + v);
    float nl = dot(n, l), nv = max(dot(n, v), 1e-3), nh = max(dot(n, h), 0.0), vh = max(dot(v, h), 0.0);
    float lit = max(nl, 0.0);
    float arriving = lit > 0.0 ? light_at(world_position, flat_n, 1.2) : 0.0;

    // Microfacets (Trowbridge-Reitz) with the usual approximations for shadowing and Fresnel.
    float a = look.finish.x * look.finish.x, a2 = a * a;
    float d = a2 / max(3.14159 * pow(nh * nh * (a2 - 1.0) + 1.0, 2.0), 1e-4);
    float k = 0.5 * a + 1e-3;
    float masking = 0.25 / ((lit * (1.0 - k) + k) * (nv * (1.0 - k) + k));
    bool is_metal = look.finish.y > 0.5;
    vec3 f0 = is_metal ? albedo : vec3(look.finish.y);
    vec3 fresnel = f0 + (1.0 - f0) * pow(1.0 - vh, 5.0);
    vec3 diffuse = is_metal ? albedo * 0.12 : albedo;

    vec3 up = mix(frame.ground_colour.rgb, frame.sky_colour.rgb, 0.5 + 0.5 * n.y);
    vec3 light = diffuse * up;
    light += frame.light_colour.rgb * arriving * lit * (diffuse + 3.14159 * d * masking * fresnel);

    // The room is mirrored as a bright ceiling over a dark floor, blurred by roughness.
    vec3 r = reflect(-v, n);
    vec3 edge = f0 + (max(vec3(1.0 - look.finish.x), f0) - f0) * pow(1.0 - nv, 5.0);
    float ceiling = smoothstep(-0.2 - look.finish.x, 0.5 + look.finish.x, r.y);
    light += edge * mix(frame.ground_colour.rgb, 2.2 * frame.sky_colour.rgb, ceiling);

    // Hair and cloth shine where they are seen edge on.
    light += look.finish.z * albedo * pow(1.0 - nv, 3.0) * (frame.sky_colour.rgb + 0.5 * arriving * frame.light_colour.rgb);
    colour = vec4(toned(light), 1.0);
}
