// Colours by copy of an assembly: a primitive is stored once for all its copies, so that only the shader knows which one
// a pixel shows. Copies take the colours of a list in turn.
#include "effects.glsl"
#include "srgb.glsl"
#include "usual.glsl"
USUALLY(kCopyColorsId) const int kCopyColors = 0;

uint copyHere() {
#ifdef COPY_OF_PIXEL
    return copyIndex;
#else
    return view.numberBefore / view.primitives;
#endif
}

vec3 copyColor() { return effects.copyColors[copyHere() % uint(kCopyColors)].rgb; }
/// @param color  linear; @param bits  as they are stored: the alpha's lowest bit, if it is 0, makes the colour a tint of
/// the copy's; the others are its opacity (engine/scene/color/colors.h)
vec3 colorInCopy(vec3 color, uint bits) {
    if (kCopyColors == 0 || (bits >> 24 & 1u) == 1u) return color;
    return color * copyColor();
}

/// Linear colour of a stored one.
vec3 linearColor(uint srgb) { return colorInCopy(linearFromSrgb(unpackUnorm4x8(srgb).rgb), srgb); }

/// The colour of a triangle's place, as it is stored: that of the nearest corner, or in between. @param bits  of corners
USUALLY(kBlendColorsId) const bool kBlendColors = false;
uint cornerColor(uvec3 bits, uint corner, vec3 shares) {
    uint nearest = corner == 0u ? bits.x : corner == 1u ? bits.y : bits.z;
    if (!kBlendColors) return nearest;
    vec3 mixed = unpackUnorm4x8(bits.x).rgb * shares.x + unpackUnorm4x8(bits.y).rgb * shares.y +
                 unpackUnorm4x8(bits.z).rgb * shares.z;
    return (packUnorm4x8(vec4(mixed, 0.0)) & 0xffffffu) | (nearest & 0xff000000u);
}

/// Opacity of a mesh's colour: 1 hides what is behind it.
float opacityOf(uint bits) { return float((bits >> 25) + 1u) / 128.0; }
