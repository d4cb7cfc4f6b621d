// How the object is turned and scaled that a pixel shows: one_model.glsl for the fragments of a swarm.
flat in mat3 member_turn;

mat3 model_turn()
{
    return member_turn;
}
