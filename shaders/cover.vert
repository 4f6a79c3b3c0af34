#version 440
// A rectangle in front of everything: pixels behind it are not drawn.

layout(location = 0) in vec4 rect;  // NDC: left, top, right, bottom

void main() {
    bool right = (gl_VertexIndex & 1) == 1, bottom = (gl_VertexIndex & 2) == 2;
    gl_Position = vec4(right ? rect.z : rect.x, bottom ? rect.w : rect.y, 0.0, 1.0);
}
