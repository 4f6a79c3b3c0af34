#version 440
// One triangle over the whole screen; or a strip of four corners, of which nothing is clipped.
#extension GL_GOOGLE_include_directive : require
#include "common/layout.h"

layout(constant_id = kCornersId) const int kCorners = 3;

void main() {
    vec2 p = vec2(gl_VertexIndex == 1 ? 3.0 : -1.0, gl_VertexIndex == 2 ? 3.0 : -1.0);
    if (kCorners == 4) p = vec2((gl_VertexIndex & 1) == 1 ? 1.0 : -1.0, gl_VertexIndex > 1 ? 1.0 : -1.0);
    gl_Position = vec4(p, 0.0, 1.0);
}
