// Layers of translucent primitives. At a common edge the depths of two triangles agree up to rounding: hits within this
// distance of encoded depth are one layer.
const float kLayerStep = 2e-6;
