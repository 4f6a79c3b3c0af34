// Light. All in linear light; directions in view space, so that it stays with the viewer. `precise`, as what a compiler
// makes of sums and products differs from shader to shader.

const vec3 kLight = normalize(vec3(kLightX, kLightY, kLightZ));

layout(constant_id = kLightingId) const bool kLighting = true;
layout(constant_id = kAmbientId) const float kAmbient = 1.0;
layout(constant_id = kDirectId) const float kDirect = 1.0;
layout(constant_id = kHighlightId) const float kHighlight = 1.0;
layout(constant_id = kGlossId) const float kGloss = 42.0;
layout(constant_id = kDeepeningId) const float kDeepening = 1.0;

/// x to the power of kGloss, multiplied out for the usual one.
float glossy(float x) {
    if (kGloss != 42.0) return pow(x, kGloss);
    precise float x2 = x * x, x4 = x2 * x2, x8 = x4 * x4, x16 = x8 * x8;
    precise float x42 = x16 * x16 * (x8 * x2);
    return x42;
}

/// @param base       linear base colour
/// @param occlusion  0 closed to 1 open, scales all light that arrives
/// @param sun        share of the direct light that arrives
vec3 shade(vec3 base, vec3 normal, float occlusion, float sun) {
    if (!kLighting) return base * mix(1.0, occlusion, kDeepening);
    vec3 light = kLight;
    precise float facing = max(dot(normal, light), 0.0) * sun;
    // The sky's share is wrapped a little upwards: what looks up is brighter than what looks down.
    const vec3 down = vec3(0.54, 0.52, 0.52), up = vec3(0.70, 0.73, 0.77);
    precise vec3 ambient = (0.5 * (down + up) + 0.5 * (up - down) * normal.y) * kAmbient;
    vec3 half_ = normalize(light + vec3(0.0, 0.0, 1.0));
    precise float highlight = kHighlight == 0.0 ? 0.0 : glossy(max(dot(normal, half_), 0.0)) * 0.16 * kHighlight * sun;
    // Clefts darken a little faster than light falls off in them, as the eye expects of depth.
    precise float open = mix(1.0, occlusion * (0.45 * occlusion + 0.55), kDeepening);
    precise vec3 lit = open * (base * (ambient + facing * (0.74 * kDirect)) + vec3(highlight));
    return lit;
}
