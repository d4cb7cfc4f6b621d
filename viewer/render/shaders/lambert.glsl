// The report's own shading: a colour, a light, the cosine between.
vec3 light_from(SurfacePoint point)
{
    float cosine = max(dot(point.normal, frame.to_light.xyz), 0.0);
    vec3 ambient = 0.5 * (frame.sky_colour.rgb + frame.ground_colour.rgb);
    vec3 light = ambient + frame.light_colour.rgb * cosine * light_at(point.world, point.normal, 1.2);
    return looks[look_index].colour.rgb * light;
}
