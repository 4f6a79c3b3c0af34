#version 440
#extension GL_GOOGLE_include_directive : require
#include "batch_map.glsl"
#ifdef MULTIVIEW
#extension GL_EXT_multiview : require
#define VIEW gl_ViewIndex
#else
#define VIEW 0
#endif

layout(set = 0, binding = 0) uniform Directions { mat4 directions[12]; };  // columns: the rows of a rotation
layout(location = 0) in vec4 shape;         // centre and radius, Å
layout(location = 0) flat out vec4 sphere;  // in the map: x, y pixels; z, radius Å

void main() {
    precise vec3 center = shape.xyz * mat3(directions[direction + VIEW]);
    sphere = vec4(vec2(center.x, -center.y) * scale + 0.5 * pixels, center.z, shape.w);
    // A quarter of a pixel more, so that no rounding of the corners loses a pixel that lies inside.
    vec2 corner = vec2(gl_VertexIndex & 1, gl_VertexIndex >> 1) * 2.0 - 1.0;
    vec2 at = sphere.xy + corner * (shape.w * scale + 0.25);
    gl_Position = vec4(at / pixels * 2.0 - 1.0, 0.5, 1.0);
}
