#version 440
// Application triangles over the picture, in pixels of the upright window.
#extension GL_GOOGLE_include_directive : require
#include "common/srgb.glsl"
#include "common/turn.glsl"

layout(location = 0) in vec2 inPosition;
layout(location = 1) in vec2 inGlyph;
layout(location = 2) in vec4 inColor;  // sRGB-coded, straight alpha
layout(location = 0) out vec2 glyph;
layout(location = 1) out vec4 color;

layout(push_constant) uniform Push { vec4 scale; };  // xy: 2 / pixels of the picture
layout(constant_id = kCodedId) const bool kCoded = false;  // the target takes sRGB-coded colour

void main() {
    gl_Position = vec4(turned(inPosition * scale.xy - 1.0), 0.0, 1.0);
    vec3 c = inColor.rgb;
    color = vec4(kCoded ? c : linearFromSrgb(c), inColor.a);
    glyph = inGlyph;
}
