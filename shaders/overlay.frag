#version 440
layout(location = 0) in vec2 glyph;
layout(location = 1) in vec4 color;
layout(location = 0) out vec4 outColor;
layout(set = 0, binding = 0) uniform sampler2D glyphs;

void main() { outColor = vec4(color.rgb, color.a * textureLod(glyphs, glyph, 0.0).r); }
