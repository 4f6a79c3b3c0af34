#version 440
#extension GL_GOOGLE_include_directive : require
#include "random.glsl"
layout(local_size_x = 64) in;
layout(set = 0, binding = 3, std430) buffer Target { uint target[]; };
void main() {
    uint i = gl_GlobalInvocationID.x;
    target[i] = mixIn(target[i], valueAt(ivec2(int(i) % 16, int(i) / 16)));
}
