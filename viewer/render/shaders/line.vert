layout(location = 0) in vec3 position;
layout(location = 1) in vec4 line_colour;

out vec4 vertex_colour;

void main()
{
    vertex_colour = line_colour;
    gl_Position = frame.view_projection * vec4(position, 1.0);
}
