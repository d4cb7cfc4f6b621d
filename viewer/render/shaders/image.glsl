// The image that the model brought along, where its uv say.

uniform sampler2D image;

void describe(Look look, Place place, inout Surface surface)
{
    surface.albedo = look.colour.rgb * texture(image, place.uv).rgb;
}
