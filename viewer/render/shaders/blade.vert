layout(location = 0) in vec3 place;   // screen x, y (-1 to 1); across the ribbon, -1 to 1
layout(location = 1) in float life;   // 1: just drawn, 0: gone

out float across;
out float strength;

void main()
{
    across = place.z;
    strength = life;
    gl_Position = vec4(place.xy, 0.0, 1.0);
}
