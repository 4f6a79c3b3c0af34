// The view constants of fragments in a row of bins, from tile_span.vert.
layout(location = 0) flat in vec4 row0;  // from tile_span.vert
layout(location = 1) flat in vec4 row1;
layout(location = 2) flat in vec4 row2;
layout(location = 3) flat in vec4 pixels;
layout(location = 4) flat in vec4 shading;
layout(location = 5) flat in uvec4 atlas;
layout(location = 7) flat in uvec2 sticks;

void fetchView() {
    view.row0 = row0;
    view.row1 = row1;
    view.row2 = row2;
    view.axisPixel = pixels.xy;
    view.pixel = pixels.z;
    view.origin = pixels.w;
    view.atlasTexel = shading.xy;
    view.clipNear = shading.z;
    view.clipFar = shading.w;
    view.contourWidth = 1e9;  // a candidate that is not inside is on the outline
    view.contourDepth = 0.0;
    view.patchTexels = atlas.x;
    view.patchesInRow = atlas.y;
    view.spheres = atlas.z;
    view.primitives = atlas.w;
    view.cylinders = sticks.x;
    view.wirePixel = uintBitsToFloat(sticks.y);
}
