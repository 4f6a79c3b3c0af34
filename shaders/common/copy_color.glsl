// Colours by copy of an assembly. A primitive is stored once for all copies, so only the shader knows the copy. Copies
// cycle through a list of colours.
#include "effects.glsl"
#include "srgb.glsl"
layout(constant_id = kCopyColorsId) const int kCopyColors = 0;

uint copyHere() {
#ifdef COPY_OF_PIXEL
    return copyIndex;
#else
    return view.numberBefore / view.primitives;
#endif
}

vec3 copyColor() { return effects.copyColors[copyHere() % uint(kCopyColors)].rgb; }
/// @param color  linear @param bits  as stored: if the lowest bit of the alpha is 0, the colour tints the copy's
/// colour; the other bits are the opacity (engine/scene/color/colors.h)
vec3 colorInCopy(vec3 color, uint bits) {
    if (kCopyColors == 0 || (bits >> 24 & 1u) == 1u) return color;
    return color * copyColor();
}

/// Linear colour from a stored one.
vec3 linearColor(uint srgb) { return colorInCopy(linearFromSrgb(unpackUnorm4x8(srgb).rgb), srgb); }

/// Stored colour at a point of a triangle: of the nearest corner, or blended. @param bits  of the corners
layout(constant_id = kBlendColorsId) const bool kBlendColors = false;
uint cornerColor(uvec3 bits, uint corner, vec3 shares) {
    uint nearest = corner == 0u ? bits.x : corner == 1u ? bits.y : bits.z;
    if (!kBlendColors) return nearest;
    vec3 mixed = unpackUnorm4x8(bits.x).rgb * shares.x + unpackUnorm4x8(bits.y).rgb * shares.y +
                 unpackUnorm4x8(bits.z).rgb * shares.z;
    return (packUnorm4x8(vec4(mixed, 0.0)) & 0xffffffu) | (nearest & 0xff000000u);
}

/// Opacity from a stored colour; 1 is opaque.
float opacityOf(uint bits) { return float((bits >> 25) + 1u) / 128.0; }
