// Layers of translucent primitives. At a common edge the depths of two triangles agree up to rounding: hits closer than
// this in encoded depth are one layer.
const float kLayerStep = 2e-6;
