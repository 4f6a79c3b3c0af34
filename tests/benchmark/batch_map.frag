#version 440
#extension GL_GOOGLE_include_directive : require
#include "batch_map.glsl"

layout(location = 0) flat in vec4 sphere;

void main() {
    precise vec2 from = (gl_FragCoord.xy - corner - sphere.xy) / scale;
    precise float height = sphere.w * sphere.w - dot(from, from);
    precise float z = sphere.z + sqrt(max(height, 0.0));
    gl_FragDepth = height > 0.0 ? (near - z) / range : 1.0;
}
