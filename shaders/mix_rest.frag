#version 440
// Composites the translucent rest over the picture, as one layer.
//   INPUT / SAMPLED   where its sums are
#extension GL_GOOGLE_include_directive : require
#include "common/layers.glsl"
#include "common/mixed_rest.glsl"

#ifdef INPUT
layout(input_attachment_index = 0, set = 0, binding = 0) uniform subpassInput sums;
layout(input_attachment_index = 1, set = 0, binding = 1) uniform subpassInput depths;
vec4 sumHere() { return subpassLoad(sums); }
float depthHere() { return subpassLoad(depths).x; }
#else
layout(set = 0, binding = 0) uniform sampler2D sums;
layout(set = 0, binding = 1) uniform sampler2D depths;
vec4 sumHere() { return texelFetch(sums, ivec2(gl_FragCoord.xy), 0); }
float depthHere() { return texelFetch(depths, ivec2(gl_FragCoord.xy), 0).x; }
#endif
layout(location = 0) out vec4 color;  // straight alpha

void main() {
    float depth = depthHere();
    if (depth == 0.0) discard;
    color = asHalves(mixedRest(sumHere(), depth));
    color.a = 1.0 - color.a;
}
