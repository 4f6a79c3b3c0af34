// Where the words of a pixel stand: row by row of all bins.
layout(location = 6) flat in uint pitch;  // as tile_span.vert has it

uint placeHere() { return uint(gl_FragCoord.y) * pitch + uint(gl_FragCoord.x); }
