#version 450
// What is drawn over the picture: triangles in window pixels of the upright picture.
layout(location = 0) in vec2 inPosition;
layout(location = 1) in vec2 inGlyph;
layout(location = 2) in vec4 inColor;  // sRGB-coded, straight alpha
layout(location = 0) out vec2 glyph;
layout(location = 1) out vec4 color;

layout(push_constant) uniform Push { vec4 scale; };  // xy: 2 / pixels of the picture
layout(constant_id = 0) const int kQuarterTurns = 0;
layout(constant_id = 1) const bool kCoded = false;  // the target takes sRGB-coded colour as it is

void main() {
    vec2 p = inPosition * scale.xy - 1.0;
    p = kQuarterTurns == 1 ? vec2(-p.y, p.x) : kQuarterTurns == 2 ? -p : kQuarterTurns == 3 ? vec2(p.y, -p.x) : p;
    gl_Position = vec4(p, 0.0, 1.0);
    vec3 c = inColor.rgb;
    vec3 linear = mix(c / 12.92, pow((c + 0.055) / 1.055, vec3(2.4)), greaterThan(c, vec3(0.04045)));
    color = vec4(kCoded ? c : linear, inColor.a);
    glyph = inGlyph;
}
