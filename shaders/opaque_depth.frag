#version 440
// The nearest depth of opaque shapes, from an attachment to the depth buffer: translucent passes test it there.
//   INPUT / SAMPLED   where it is
#extension GL_GOOGLE_include_directive : require
#include "common/encoding.glsl"

#ifdef INPUT
layout(input_attachment_index = 0, set = 0, binding = 0) uniform subpassInput nearest;
vec4 nearestDepth() { return subpassLoad(nearest); }
#else
layout(set = 0, binding = 0) uniform sampler2D nearest;
vec4 nearestDepth() { return texelFetch(nearest, ivec2(gl_FragCoord.xy), 0); }
#endif

void main() { gl_FragDepth = decodeDepth(nearestDepth()); }
