// What the fruit share. Their patterns live in mesh coordinates, metres, and know the outlines of
// data/maker/fruit/shape.cpp: y is the axis, the origin the middle of the flesh.
const float kPi = 3.14159265;

vec3 srgb(float red, float green, float blue)
{
    return pow(vec3(red, green, blue) / 255.0, vec3(2.2));
}

// The angle about the axis that the meshes are turned by.
float turn_of(vec3 p)
{
    return atan(-p.z, p.x);
}

// A dent or a tip: 1 in the middle.
float bell(float x, float width)
{
    return exp(-x * x / (width * width));
}

// 0 below `at`, 1 above, over a few pixels at least.
float above(float at, float x, float soft)
{
    return smoothstep(at - soft, at + soft, x);
}

float superellipse(float polar, float a, float b, float n)
{
    return pow(pow(sin(polar) / a, n) + pow(abs(cos(polar)) / b, n), -1.0 / n);
}

float polar_of(vec3 p)
{
    return acos(clamp(p.y / max(length(p), 1e-6), -1.0, 1.0));
}

// Where in a stalk of the fruit's axis: wood under bark.
void woody(vec3 p, inout Surface s)
{
    float grain = noise(p * vec3(90.0, 9.0, 90.0));
    s.albedo = mix(srgb(150.0, 112.0, 62.0), srgb(92.0, 62.0, 30.0), grain);
    s.roughness = 0.8;
    s.height = 0.002 * grain;
    s.depth = 0.0;
    s.wet = 0.0;
}
