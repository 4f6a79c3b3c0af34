// One sphere a square, into depth maps of several directions: the stages share this. MULTIVIEW: the render pass says
// which direction; else the draw call does.
layout(push_constant) uniform Push {
    float pixels;  // across a map
    float scale;   // pixels per Å
    float near;    // Å: view-space z at depth 0
    float range;   // Å: depth 0 to 1
    vec2 corner;   // pixel of the map in its image
    int direction;  // of the first view
};
