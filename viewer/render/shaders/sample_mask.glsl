#extension GL_ARB_sample_shading : require
