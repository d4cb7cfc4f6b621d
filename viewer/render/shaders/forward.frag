out vec4 colour;

void main()
{
    colour = vec4(toned(light_from(surface_point())), 1.0);
}
