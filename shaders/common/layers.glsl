// Layers of translucent triangles. Two triangles meet a pixel on their common edge at depths that are the same but for
// what is rounded: within this much of encoded depth they are one layer.
const float kLayerStep = 2e-6;
