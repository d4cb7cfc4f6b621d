// Where in the hammer, whose head sits on a banana: data/maker/fruit/hammer.cpp.
struct Head
{
    vec3 place;    // along the head, sideways, above the end of the handle
    float thick;   // half its thickness there
    float depth;   // below its skin
    bool is_head;  // and no handle
};

Head in_head(vec3 p)
{
    const float kBend = 1.12, kHalfAngle = 0.98, kDrop = 0.22, kHandle = 0.64;
    const float kCollar = 0.05, kLength = 0.41, kSide = 0.20, kWaist = 0.85;
    float angle = kHalfAngle * kHandle;
    vec3 along = vec3(cos(angle), sin(angle), 0.0), inwards = vec3(-sin(angle), cos(angle), 0.0);
    vec3 from_end = p - vec3(kBend * sin(angle), kBend * (1.0 - cos(angle)) - kDrop, 0.0);
    Head h;
    h.place = vec3(dot(from_end, inwards), from_end.z, dot(from_end, along));
    h.thick = kSide * mix(kWaist, 1.0, smoothstep(0.40, 0.70, abs(h.place.x) / kLength));
    float level = abs(h.place.z - kCollar - kWaist * kSide);
    h.depth = min(h.thick - max(abs(h.place.y), level), kLength - abs(h.place.x));
    h.is_head = h.place.z > 0.0;
    return h;
}
