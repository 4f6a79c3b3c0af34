#version 440
// Composites a layer from tile_layers.comp over the picture.
//   TEXELS   as in common/streams.glsl
#extension GL_GOOGLE_include_directive : require
#include "common/layers.glsl"
#include "common/layout.h"
#include "common/tile_place.glsl"

#ifdef TEXELS
layout(set = 0, binding = 0) uniform usamplerBuffer layerTexels;
uvec2 layerAt(uint i) { return texelFetch(layerTexels, int(i)).xy; }
#else
layout(set = 0, binding = 0, std430) readonly buffer Layers { uvec2 layers[]; };
uvec2 layerAt(uint i) { return layers[i]; }
#endif
layout(constant_id = kLayerId) const int kLayer = 0;
layout(location = 0) out vec4 color;  // straight alpha

void main() {
    color = fromHalves(layerAt(uint(kLayerWords / 2) * placeHere() + uint(kLayer)));
    if (kLayer == kOrderedLayers) color.a = 1.0 - color.a;
    if (color.a == 0.0) discard;
}
