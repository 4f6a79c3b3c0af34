#version 440
// One triangle over everything, at one depth.
layout(push_constant) uniform Push { float z; uint seed; uint reads; } push;
void main() {
    vec2 p = vec2(gl_VertexIndex == 1 ? 3.0 : -1.0, gl_VertexIndex == 2 ? 3.0 : -1.0);
    gl_Position = vec4(p, push.z, 1.0);
}
