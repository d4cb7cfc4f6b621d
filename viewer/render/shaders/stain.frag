in vec2 from_middle;
in vec2 on_wall;
flat in vec4 base;
flat in float wet;
flat in float run;
flat in float layer;
flat in vec2 turn;
flat in float mirror;
flat in vec4 drip_x;
flat in vec4 drip_width;
flat in vec4 drip_length;

uniform sampler2DArray splats;
uniform float reach;
uniform float edge;         // the height at which juice begins
uniform float most_slope;
uniform float light_radius;

// The wall's light goes through the juice twice: it is multiplied, and what the juice itself sends is added.
layout(location = 0, index = 0) out vec4 added;
layout(location = 0, index = 1) out vec4 left;

// Drips run down from the thick middle; their heads are drops. The same kernels as the splat shapes.
float drips(vec2 p)
{
    vec4 bottom = -0.22 - drip_length * run;
    vec4 top = vec4(-0.10);
    vec4 down = clamp((top - p.y) / (top - bottom), 0.0, 1.0);
    vec4 wander = 0.012 * sin(9.0 * p.y + 40.0 * drip_x);
    vec4 dx = p.x - drip_x - wander;
    vec4 beyond = p.y - clamp(vec4(p.y), bottom, top);
    vec4 width = drip_width * mix(vec4(2.4), vec4(1.35), down);
    vec4 trail = max(1.0 - (dx * dx + beyond * beyond) / (width * width), 0.0);
    vec4 dy = (p.y - bottom) * mix(vec4(1.0), vec4(0.55), step(bottom, vec4(p.y)));
    vec4 head_size = 2.5 * drip_width;
    vec4 head = max(1.0 - (dx * dx + dy * dy) / (head_size * head_size), 0.0);
    return dot(0.5 * trail * trail + 0.7 * head * head, vec4(1.0));
}

void main()
{
    vec2 p = from_middle;
    vec2 q = vec2(dot(p, turn), dot(p, vec2(-turn.y, turn.x)) * mirror);
    vec3 splat = texture(splats, vec3(0.5 + 0.5 * q / reach, layer)).xyz;
    float running = drips(p);
    float height = min(splat.x + running, 1.0);
    vec2 slope = (splat.yz - 128.0 / 255.0) * 2.0 * most_slope * vec2(1.0, mirror);
    slope = vec2(dot(slope, vec2(turn.x, -turn.y)), dot(slope, turn.yx));
    vec2 texel = vec2(dFdx(p.x), dFdy(p.y));
    slope += vec2(dFdx(running) / texel.x, dFdy(running) / texel.y);

    // Edges are a pixel soft, and a little more.
    float soft = max(0.75 * fwidth(height), 0.03);
    float covered = smoothstep(edge - soft, edge + soft, height);
    if (covered <= 0.0 || base.a <= 0.0) discard;
    float thick = clamp((height - edge) / (1.0 - edge), 0.0, 1.0);
    // Juice dries from the edge, where its colour gathers.
    float rim = exp(-9.0 * thick);
    float density = base.a * covered * (mix(0.55, 1.35, thick) + mix(0.15, 0.75, 1.0 - wet) * rim);

    vec3 absorbed = -log(clamp(base.rgb, 0.03, 0.97));
    // Pulp hides what is behind it as much as it sends itself: stains upon stains do not begin to glow.
    const float kPulp = 0.55;
    left = vec4(exp(-density * (0.55 * absorbed + kPulp)), 1.0);

    float from_lamp = length((on_wall - vec2(-0.12, 0.16) * light_radius) / light_radius);
    float pool = 0.24 + 0.76 * exp(-1.05 * from_lamp * from_lamp);
    vec3 n = normalize(vec3(-0.16 * slope, 1.0));
    vec3 l = frame.to_light.xyz;
    float lamp = pool;
    vec3 arriving = lamp * l.z * frame.light_colour.rgb + pool * frame.sky_colour.rgb;
    // Pulp sends light back; where juice is thicker the colour is deeper.
    vec3 pulp = base.rgb * mix(vec3(1.0), base.rgb, 0.45 * thick + 0.35 * rim);
    vec3 light = 0.70 * (1.0 - exp(-kPulp * density)) * pulp * arriving;
    // While it is wet the lamp and the ceiling are mirrored in its curved edges.
    float shine = pow(max(dot(n, normalize(l + vec3(0.0, 0.0, 1.0))), 0.0), 110.0);
    float ceiling = smoothstep(0.10, 0.55, n.y) * 0.10;
    float gloss = wet * base.a * covered * smoothstep(0.0, 0.12, thick);
    light += gloss * (0.55 * lamp * shine * frame.light_colour.rgb + pool * ceiling * frame.sky_colour.rgb);
    added = vec4(toned(light), 0.0);
}
