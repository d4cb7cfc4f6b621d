in vec3 pattern_position;
in vec2 pattern_uv;

uniform uint object_id;
uniform uint kind;

layout(location = 0) out uvec2 id;
layout(location = 1) out vec4 place;
layout(location = 2) out vec2 uv;

void main()
{
    id = uvec2(object_id, kind);
    place = vec4(pattern_position, gl_FragCoord.z);
    uv = pattern_uv;
}
