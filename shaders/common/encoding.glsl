// The ladder of encoded depth. One float channel holds d itself; n channels hold the paper's staircase,
// channel i = clamp(n d - i, 0, 1), which a per-channel MIN keeps exact.
layout(constant_id = 1) const int kDepthChannels = 1;
layout(constant_id = 2) const float kDepthBias = 0.0;

vec4 encodeDepth(float d) {
    if (kDepthChannels == 1) return vec4(d, 1.0, 1.0, 1.0);
    return clamp(vec4(float(kDepthChannels) * d) - vec4(0.0, 1.0, 2.0, 3.0), 0.0, 1.0);
}
float decodeDepth(vec4 e) {
    if (kDepthChannels == 1) return e.x;
    float sum = e.x + e.y;
    if (kDepthChannels > 2) sum += e.z;
    if (kDepthChannels > 3) sum += e.w;
    return sum / float(kDepthChannels);
}
/// Whether a fragment at depth d is the front-most one of its pixel.
bool isFrontmost(float d, vec4 encoded) { return d <= decodeDepth(encoded) + kDepthBias; }
