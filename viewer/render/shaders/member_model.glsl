// Many objects are drawn at once; each vertex knows whose it is (swarm.h).
layout(location = 3) in uint member;

layout(std140) uniform Swarm
{
    mat4 models[256];  // Swarm::kMostMembers; mesh coordinates to world
};

flat out mat3 member_turn;  // for the fragment shader

mat4 model_matrix()
{
    mat4 model = models[member];
    member_turn = mat3(model);
    return model;
}
