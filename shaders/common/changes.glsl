// A combination of flags in a sight (sight.glsl) that no primitive has, contour and cut face: the sight changes inside
// its pixel.
const uint kChanges = 0x60000000u;
