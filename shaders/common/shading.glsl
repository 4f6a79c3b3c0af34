// Light. All in linear light; directions in view space, so that it stays with the viewer. `precise`, as what a compiler
// makes of sums and products differs from shader to shader.

const vec3 kLight = normalize(vec3(kLightX, kLightY, kLightZ));

layout(constant_id = kLightingId) const bool kLighting = true;
layout(constant_id = kAmbientId) const float kAmbient = 1.0;
layout(constant_id = kDirectId) const float kDirect = 1.0;
layout(constant_id = kHighlightId) const float kHighlight = 1.0;
layout(constant_id = kGlossId) const float kGloss = 42.0;
layout(constant_id = kPowersId) const bool kPowers = false;
layout(constant_id = kDeepeningId) const float kDeepening = 1.0;

/// x to the power of kGloss, times a strength. Where pow() is no matter of a few instructions, the usual one is
/// multiplied out, as few products as can be behind each other.
float glossy(float x, float strength) {
    if (kPowers || kGloss != 42.0) return pow(x, kGloss) * strength;
    precise float x2 = x * x, x4 = x2 * x2, x8 = x4 * x4, x16 = x8 * x8;
    precise float x42 = x16 * x16 * (x8 * (x2 * strength));
    return x42;
}

/// @param base       linear base colour
/// @param occlusion  0 closed to 1 open, scales all light that arrives
/// @param sun        share of the direct light that arrives
vec3 shade(vec3 base, vec3 normal, float occlusion, float sun) {
    if (!kLighting) return base * mix(1.0, occlusion, kDeepening);
    vec3 light = kLight;
    // The sky's share is wrapped a little upwards: what looks up is brighter than what looks down.
    const vec3 down = vec3(0.54, 0.52, 0.52), up = vec3(0.70, 0.73, 0.77);
    const vec3 level = 0.5 * (down + up), slope = 0.5 * (up - down);
    precise float direct = max(dot(normal, light * (0.74 * kDirect)), 0.0) * sun;
    precise vec3 arriving = fma(vec3(normal.y), slope * kAmbient, level * kAmbient + direct);
    vec3 half_ = normalize(light + vec3(0.0, 0.0, 1.0));
    precise float highlight = kHighlight == 0.0 ? 0.0 : glossy(max(dot(normal, half_), 0.0), 0.16 * kHighlight) * sun;
    // Clefts darken a little faster than light falls off in them, as the eye expects of depth.
    precise vec3 lit = fma(base, arriving, vec3(highlight));
    // Occlusion comes late, from a texture: little waits for it.
    precise float clefts = fma(occlusion, 0.45, 0.55);
    precise vec3 deepened = lit * occlusion * clefts;
    return kDeepening == 1.0 ? deepened : mix(lit, deepened, kDeepening);
}
