#version 440
// Shading of the `tiles` path: each covered pixel once, by its number from tile_nearest.comp.
//   TEXELS               as in common/streams.glsl
//   CYLINDERS, TRIANGLES   the scene has some
//   SURFACE / IDENTITY   layers instead of colour
//   DEPTH                writes the hit's depth to the depth buffer, for later draws
#extension GL_GOOGLE_include_directive : require
#define TILES
#define COPY_OF_PIXEL
#define STREAMS 4
#define LOOKS 6
#include "common/numbered.glsl"
#include "common/surface.glsl"
#include "common/count.glsl"
#include "common/sight.glsl"
#include "common/tile_place.glsl"

#ifdef TEXELS
layout(set = 0, binding = 3) uniform usamplerBuffer numberTexels;
uint numberAt(uint i) { return texelFetch(numberTexels, int(i)).x; }
#else
layout(set = 0, binding = 3, std430) readonly buffer Numbers { uint pixelNumbers[]; };
uint numberAt(uint i) { return pixelNumbers[i]; }
#endif
#ifdef DEPTH
layout(push_constant) uniform Push { TileConstants push; };
void fetchView() { view = push; }
#else
#include "common/span_view.glsl"
#endif

uint numberHere() { return numberAt(placeHere()); }

void main() {
    fetchView();
    uint number = numberHere() & kNumber;
    if (number == 0u) discard;
    countFragment();
    Seen seen = findSeen(number, planePoint(gl_FragCoord.xy));
#ifdef DEPTH
    gl_FragDepth = encodedDepth(seen.hit.order);
#endif
    writeSurface(seen.hit, storedColor(seen), lookAt(seen.atom), seen.baked);
}
