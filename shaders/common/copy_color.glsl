// Colours by copy of an assembly: a primitive is stored once for all its copies, so that only the shader knows which one
// a pixel shows. Copies take the colours of a list in turn.
layout(constant_id = kCopyColorsId) const int kCopyColors = 0;

uint copyHere() {
#ifdef COPY_OF_PIXEL
    return copyIndex;
#else
    return view.numberBefore / view.primitives;
#endif
}

/// @param color  linear; @param bits  as they are stored: an alpha below 255 makes the colour a tint of the copy's
vec3 colorInCopy(vec3 color, uint bits) {
    if (kCopyColors == 0 || bits >> 24 == 255u) return color;
    return color * effects.copyColors[copyHere() % uint(kCopyColors)].rgb;
}
