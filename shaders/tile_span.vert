#version 440
// A row of bins or tiles that are not empty. Passes the view constants for shading as flat varyings: as push constants of
// the fragment stage, lavapipe 22.3 would gather them lane by lane for every pixel.
#extension GL_GOOGLE_include_directive : require
#include "common/layout.h"

layout(location = 0) in vec4 span;    // NDC: left, top, right, bottom
layout(constant_id = kTilesInBinId) const int kTilesInBin = 2;
layout(push_constant) uniform Push { TileConstants view; };
layout(location = 0) flat out vec4 row0;
layout(location = 1) flat out vec4 row1;
layout(location = 2) flat out vec4 row2;
layout(location = 3) flat out vec4 pixels;  // axisPixel, pixel, origin
layout(location = 4) flat out vec4 shading;  // atlasTexel, clipNear, clipFar
layout(location = 5) flat out uvec4 atlas;  // patchTexels, patchesInRow, spheres, primitives
layout(location = 7) flat out uvec2 sticks;  // cylinders, bits of wirePixel
layout(location = 6) flat out uint pitch;  // pixels in a row of all bins
layout(location = 8) flat out uint origin;

void main() {
    row0 = view.row0;
    row1 = view.row1;
    row2 = view.row2;
    pixels = vec4(view.axisPixel, view.pixel, view.origin);
    shading = vec4(view.atlasTexel, view.clipNear, view.clipFar);
    atlas = uvec4(view.patchTexels, view.patchesInRow, view.spheres, view.primitives);
    sticks = uvec2(view.cylinders, floatBitsToUint(view.wirePixel));
    pitch = view.across * uint(8 * kTilesInBin);
    origin = view.offsets;
    bool right = (gl_VertexIndex & 1) == 1, bottom = (gl_VertexIndex & 2) == 2;
    gl_Position = vec4(right ? span.z : span.x, bottom ? span.w : span.y, 0.0, 1.0);
}
