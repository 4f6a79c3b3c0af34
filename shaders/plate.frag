#version 440
// A plate writes depth only.
#extension GL_GOOGLE_include_directive : require
#include "common/count.glsl"

layout(early_fragment_tests) in;

void main() { countFragment(); }
