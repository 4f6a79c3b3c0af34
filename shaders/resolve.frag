#version 440
// Writes a frame into its picture: a pixel is the mean of n x n samples in linear light.
//   WORDS    the frame's colours are words of a buffer, row by row
// MASKED   replaces only the pixels for which a mask has n, or any number if n is 1
#extension GL_GOOGLE_include_directive : require
#include "common/layout.h"
#include "common/srgb.glsl"

layout(push_constant) uniform Push {
    ivec2 place;  // of the first pixel in the picture
    ivec2 from;  // position of that pixel in the frame
    int pitch;    // words in a row
    int samples;  // n
};
layout(location = 0) out vec4 color;                            // premultiplied
layout(constant_id = kSamplesId) const bool kSeveral = false;  // n > 1
layout(constant_id = kCodedId) const bool kCoded = false;  // frame and picture are sRGB-coded

#ifdef WORDS
layout(set = 0, binding = 0) uniform usamplerBuffer words;
vec4 sampleAt(ivec2 at) { return unpackUnorm4x8(texelFetch(words, at.y * pitch + at.x).x); }
#else
layout(set = 0, binding = 0) uniform sampler2D drawn;
vec4 sampleAt(ivec2 at) { return texelFetch(drawn, at, 0); }
#endif
#ifdef MASKED
layout(set = 0, binding = 1) uniform sampler2D wanted;
#endif

void main() {
    ivec2 here = ivec2(gl_FragCoord.xy);
    int count = samples * samples;
#ifdef MASKED
    int more = int(255.0 * texelFetch(wanted, here, 0).r + 0.5);
    if (samples == 1 ? more == 0 : more != samples - 1) {
        count = 0;
        discard;
    }
#endif
    ivec2 first = (here - place + from) * samples;
    if (!kSeveral && kCoded) {
        color = sampleAt(first);
        return;
    }
    // Idle lanes of a software device run one iteration.
    vec4 sum = vec4(0.0);
    ivec2 at = ivec2(0);
    int taken = 0;
    do {
        vec4 one = sampleAt(first + at);
        // Highlights clamp to white, as in 8 bits.
        sum += vec4(kCoded ? linearFromSrgb(one.rgb) : min(one.rgb, one.a), one.a);
        at = at.x + 1 < samples ? ivec2(at.x + 1, at.y) : ivec2(0, at.y + 1);
        ++taken;
    } while (taken < count);
    sum /= float(taken);
    color = vec4(kCoded ? srgbFromLinear(sum.rgb) : sum.rgb, sum.a);
}
