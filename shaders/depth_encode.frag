#version 440
// Depth encoding: the hit's depth as a colour, for MIN blending. A fragment that misses writes the neutral value
// instead of discarding, so that early depth tests stay possible.
#extension GL_GOOGLE_include_directive : require
#include "common/primitive.glsl"
#include "common/count.glsl"
#include "common/encoding.glsl"

layout(early_fragment_tests) in;
layout(location = 0) out vec4 encoded;
#ifdef ORDERED
// No blending: the attachment's own value is read in raster order.
layout(input_attachment_index = 0, set = 0, binding = 3) uniform subpassInput nearest;
#endif

void main() {
    countFragment();
    Hit hit = primitiveHit();
#ifdef ORDERED
    float kept = subpassLoad(nearest).x;
    encoded = vec4(hit.inside ? min(kept, encodedDepth(hit.order)) : kept, 0.0, 0.0, 0.0);
#else
    encoded = hit.inside ? encodeDepth(encodedDepth(hit.order)) : farthestDepth();
#endif
}
