// Light. All in linear light; directions in view space, so that it stays with the viewer.

const vec3 kLight = normalize(vec3(-0.35, 0.55, 0.76));  // over the viewer's left shoulder

layout(constant_id = kLightingId) const bool kLighting = true;
layout(constant_id = kAmbientId) const float kAmbient = 1.0;
layout(constant_id = kDirectId) const float kDirect = 1.0;
layout(constant_id = kHighlightId) const float kHighlight = 1.0;
layout(constant_id = kGlossId) const float kGloss = 42.0;
layout(constant_id = kDeepeningId) const float kDeepening = 1.0;

/// @param base       linear base colour
/// @param occlusion  0 closed to 1 open, scales all light that arrives
vec3 shade(vec3 base, vec3 normal, float occlusion) {
    if (!kLighting) return base * mix(1.0, occlusion, kDeepening);
    vec3 light = kLight;
    float facing = max(dot(normal, light), 0.0);
    // The sky's share is wrapped a little upwards: what looks up is brighter than what looks down.
    float sky = 0.5 + 0.5 * normal.y;
    vec3 ambient = mix(vec3(0.54, 0.52, 0.52), vec3(0.70, 0.73, 0.77), sky) * kAmbient;
    vec3 half_ = normalize(light + vec3(0.0, 0.0, 1.0));
    float highlight = kHighlight == 0.0 ? 0.0 : pow(max(dot(normal, half_), 0.0), kGloss) * 0.16 * kHighlight;
    // Clefts darken a little faster than light falls off in them, as the eye expects of depth.
    float open = mix(1.0, occlusion * mix(occlusion, 1.0, 0.55), kDeepening);
    return open * (base * (ambient + facing * 0.74 * kDirect) + vec3(highlight));
}
