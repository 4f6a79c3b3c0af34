// Colours by copy of an assembly: a primitive is stored once for all its copies, so that only the shader knows which one
// a pixel shows. Copies take the colours of a list in turn.
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

/// @param color  linear; @param bits  as they are stored: the alpha's lowest bit, if it is 0, makes the colour a tint of
/// the copy's; the others are its opacity (engine/scene/colors.h)
vec3 colorInCopy(vec3 color, uint bits) {
    if (kCopyColors == 0 || (bits >> 24 & 1u) == 1u) return color;
    return color * effects.copyColors[copyHere() % uint(kCopyColors)].rgb;
}

/// Of a stored colour.
vec3 linearColor(uint srgb) { return colorInCopy(linearFromSrgb(unpackUnorm4x8(srgb).rgb), srgb); }

/// Of a mesh's colour: 1 hides what is behind it.
float opacityOf(uint bits) { return float((bits >> 25) + 1u) / 128.0; }
