#version 440
//   INPUT / SAMPLED   an input read, on the tile or as a texture
//   OUTPUTS           colours written, 0 to 2
#extension GL_GOOGLE_include_directive : require
#include "random.glsl"
#ifdef INPUT
layout(input_attachment_index = 0, set = 0, binding = 3) uniform usubpassInput here;
uint inputHere() { return subpassLoad(here).x; }
#elif defined(SAMPLED)
layout(set = 0, binding = 3) uniform usampler2D here;
uint inputHere() { return texelFetch(here, ivec2(gl_FragCoord.xy), 0).x; }
#else
uint inputHere() { return 0u; }
#endif
#if OUTPUTS > 0
layout(location = 0) out uvec4 first;
#endif
#if OUTPUTS > 1
layout(location = 1) out uvec4 second;
#endif
void main() {
    uint h = mixIn(valueAt(ivec2(gl_FragCoord.xy)), inputHere());
#if OUTPUTS > 0
    first = uvec4(h, mixIn(h, 5u), 0u, 0u);
#endif
#if OUTPUTS > 1
    second = uvec4(mixIn(h, 7u), mixIn(h, 11u), 0u, 0u);
#endif
}
