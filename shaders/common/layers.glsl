// Layers of translucent triangles. On the common edge of two triangles their depths are equal except for rounding:
// within this much of encoded depth they are one layer.
const float kLayerStep = 2e-6;
