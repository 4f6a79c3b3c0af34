// Where the numbers of a pixel's tile stand: tile by tile along a row of bins, in a bin column by column.
layout(location = 6) flat in uvec2 numbers;  // as tile_span.vert has them
layout(constant_id = kTilesInBinId) const int kTilesInBin = 2;
const uint kTile = 8u;

uint placeHere() {
    uvec2 pixel = uvec2(gl_FragCoord.xy) - uvec2(numbers.x, 0u);
    uvec2 tile = pixel / kTile, inTile = pixel % kTile;
    uint slot = tile.x * uint(kTilesInBin) + tile.y % uint(kTilesInBin);
    return numbers.y + (slot * kTile + inTile.y) * kTile + inTile.x;
}
