// Flags of a sight (sight.glsl) that do not meet otherwise, contour and cut face: it changes inside its pixel.
const uint kChanges = 0x60000000u;
