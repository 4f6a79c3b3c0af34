// Pixels of a tile that show one kind of primitive, for common/tile_kind.glsl.

uint findKind(uint number) {
    uint index = number - 1u;
    if (kCopies) index = divided(index, view.primitives).y;
#ifdef TRIANGLES
    if (isTriangle(index)) return kFacets;
#endif
    return index < view.spheres ? kBalls : kSticks;
}

/// Position of the n-th set bit of a word, from 0: by bytes, half bytes, then bits.
uint placeOfBit(uint word, uint n) {
    uint pairs = word - (word >> 1 & 0x55555555u);
    uint fours = (pairs & 0x33333333u) + (pairs >> 2 & 0x33333333u);
    uint upTo = (fours + (fours >> 4) & 0x0f0f0f0fu) * 0x01010101u;
    uint at = 8u * (uint(n >= (upTo & 63u)) + uint(n >= (upTo >> 8 & 63u)) + uint(n >= (upTo >> 16 & 63u)));
    n -= upTo << 8 >> at & 63u;
    uint here = fours >> at & 7u;
    at += n >= here ? 4u : 0u;
    n -= n >= here ? here : 0u;
    here = pairs >> at & 3u;
    at += n >= here ? 2u : 0u;
    n -= n >= here ? here : 0u;
    return at + uint(n >= (word >> at & 1u));
}

/// Pixels carried over to the next tile, one per lane.
struct Left {
    uint number, on, rim;  // of the lane's pixel; its position in the picture is x | y << 16
    uint count;
};
Left leftBalls, leftSticks, leftFacets;

/// The n-th pixel with a set bit. @param bits  of all lanes in turn
Left findPixel(uvec2 bits, uint n, uvec2 corner) {
    uint first = uint(bitCount(bits.x));
    bool second = n >= first;
    uint at = placeOfBit(second ? bits.y : bits.x, n - (second ? first : 0u)) + (second ? 32u : 0u);
    at &= uint(kTile * kTile - 1);  // keeps idle lanes in range
    uint from = at / uint(kPixels), row = at % uint(kPixels);
    Left pixel = Left(0u, 0u, 0u, 0u);
    for (int i = 0; i < kPixels; ++i) {
        uint there = subgroupShuffle(number[i], from);
        pixel.number = row == uint(i) ? there : pixel.number;
#ifdef RIMS
        uint rimThere = subgroupShuffle(rimWords[i], from);
        pixel.rim = row == uint(i) ? rimThere : pixel.rim;
#endif
    }
    uint pixelOfTile = row * uint(kLanes) + from;
    uvec2 on = corner + uvec2(pixelOfTile % uint(kTile), pixelOfTile / uint(kTile));
    pixel.on = on.x | on.y << 16;
    return pixel;
}
