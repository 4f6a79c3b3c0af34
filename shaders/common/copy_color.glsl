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
/// colour; the other bits are the opacity or material (engine/scene/color/colors.h)
vec3 colorInCopy(vec3 color, uint bits) {
    if (kCopyColors == 0 || (bits >> 24 & 1u) == 1u) return color;
    return color * copyColor();
}

/// A colour's own material travels in its red: twice the material's number, counted from 1, is added to that.
layout(constant_id = kOwnMaterialId) const bool kOwnMaterials = false;
bool hasMaterial(uint bits) { return kOwnMaterials && bits >> 25 < kMaterials; }
float materialIn(vec3 color) { return kOwnMaterials ? 2.0 * floor(0.5 * color.r) : 0.0; }

/// Linear colour from a stored one.
vec3 linearColor(uint srgb) {
    vec3 color = colorInCopy(linearFromSrgb(unpackUnorm4x8(srgb).rgb), srgb);
    if (hasMaterial(srgb)) color.r += float(2u * ((srgb >> 25) + 1u));
    return color;
}

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
float unpackOpacity(uint bits) { return hasMaterial(bits) ? 1.0 : float((bits >> 25) + 1u) / 128.0; }
