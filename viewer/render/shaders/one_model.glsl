// Where the object is that is drawn. In vertex and fragment shaders.
uniform mat4 model;  // mesh coordinates to world

mat4 model_matrix()
{
    return model;
}

mat3 model_turn()
{
    return mat3(model);
}
