#version 440
// Adds one, by blending, for each fragment that passes the early depth test, inside the outline or not.
#extension GL_GOOGLE_include_directive : require
#include "common/count.glsl"

layout(early_fragment_tests) in;
#if defined(CYLINDER)
layout(location = 0) flat in vec4 endA;
layout(location = 1) flat in vec4 endB;
float radius() { return max(endA.w, endB.w); }
#elif defined(TRIANGLE)
layout(location = 0) flat in vec3 cornerA;
layout(location = 1) flat in vec3 cornerB;
layout(location = 2) flat in vec3 cornerC;
layout(location = 3) flat in uint division;
float radius() { return cornerA.z + cornerB.z + cornerC.z == 0.125 && division == 0xffffffffu ? 0.0 : 1.0; }
#else
layout(location = 0) flat in vec4 sphere;
float radius() { return sphere.w; }
#endif
layout(location = 0) out vec4 count;

void main() {
    countFragment();
    // Reads the radius to use the record that the vertex stage passes; every primitive has a radius.
    count = vec4(radius() > 0.0 ? 1.0 / 255.0 : 0.0);
}
