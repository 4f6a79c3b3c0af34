// Position of a pixel's word: row by row over all bins.
layout(location = 6) flat in uint pitch;  // from tile_span.vert

uint placeHere() { return uint(gl_FragCoord.y) * pitch + uint(gl_FragCoord.x); }
