// Encoded depth: how depth is stored in a colour attachment with MIN blending. One float channel holds d itself.
// Otherwise depth is an integer code and n channels hold the paper's staircase, channel i = clamp(code - i M, 0, M),
// which a per-channel minimum keeps exact:
//   UNORM channels   M = 255 or 1023
//   half floats      M = 61,439: the steps are the normal halves in order, negative ones first. Every step is
//                    exactly representable, so nothing is rounded and four channels distinguish 245,756 depths.
#include "layout.h"

layout(constant_id = kDepthChannelsId) const int kDepthChannels = 1;
layout(constant_id = kDepthStepsId) const int kDepthSteps = 0;  // M; 0: one float channel

const int kHalfSteps = 61439;

float toChannel(int step) {
    if (kDepthSteps != kHalfSteps) return float(step) / float(kDepthSteps);
    int rank = step - 30720;
    uint bits = rank >= 0 ? uint(0x0400 + rank) : uint(0x8000 + 0x0400 - 1 - rank);
    return unpackHalf2x16(bits).x;
}
int toStep(float channel) {
    if (kDepthSteps != kHalfSteps) return int(channel * float(kDepthSteps) + 0.5);
    int bits = int(packHalf2x16(vec2(channel, 0.0)) & 0xffffu);
    return bits < 0x8000 ? bits - 0x0400 + 30720 : 30719 - (bits - 0x8000 - 0x0400);
}

int depthCode(float d) {
    int last = kDepthChannels * kDepthSteps;
    return clamp(int(d * float(last)), 0, last);
}
int decodeCode(vec4 e) {
    int code = toStep(e.x);
    if (kDepthChannels > 1) code += toStep(e.y);
    if (kDepthChannels > 2) code += toStep(e.z);
    if (kDepthChannels > 3) code += toStep(e.w);
    return code;
}

vec4 encodeDepth(float d) {
    if (kDepthSteps == 0) return vec4(d, 1.0, 1.0, 1.0);
    int code = depthCode(d);
    vec4 e = vec4(1.0);
    for (int i = 0; i < kDepthChannels; ++i) e[i] = toChannel(clamp(code - i * kDepthSteps, 0, kDepthSteps));
    return e;
}
/// Neutral for MIN: written by fragments that miss, and the clear value.
vec4 farthestDepth() { return vec4(kDepthSteps == kHalfSteps ? 65504.0 : 1.0); }

/// The largest depth that has this encoding.
float decodeDepth(vec4 e) {
    if (kDepthSteps == 0) return e.x;
    return float(decodeCode(e) + 1) / float(kDepthChannels * kDepthSteps);
}
/// Whether a fragment at depth d is the front-most one of its pixel, up to the ladder's step.
bool isFrontmost(float d, vec4 encoded) {
    if (kDepthSteps == 0) return d <= encoded.x;
    return depthCode(d) <= decodeCode(encoded);
}
