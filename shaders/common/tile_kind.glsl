// Colours of the pixels of a tile that show one kind of primitive. Included once per kind, because drivers inline
// functions before they know the kind, and would optimise all of it each time.
//   KIND             of findKind()
// FIRST            index of the first primitive of the kind, read by idle lanes
//   SEEN, HIT        what a ray sees of a primitive, by its index; its hit, by the same
//   SIGHT_AT, MARKED, COLOR_AT, SHADE   names of the functions

uint SIGHT_AT(uint number, vec2 q) {
    uint index = max(place(max(number, 1u)), FIRST);
    return number == 0u ? 0u : packSight(HIT(index, q), number);
}

/// Marks a sight that changes between corners of its pixel: the tip of an outline.
uint MARKED(uint sight, vec2 pixel, float width, float depth) {
    if (!kContours || !kNumbered) return sight;
    view.contourWidth = width;
    view.contourDepth = depth;
    uint first = 0u;
    bool changes = false;
    for (int i = 0; i < 4; ++i) {
        uint there = SIGHT_AT(sight & kNumber, planePoint(pixel + vec2(i & 1, i >> 1) - 0.5));
        changes = changes || (i > 0 && there != first);
        first = i == 0 ? there : first;
    }
    view.contourWidth = 1e9;
    view.contourDepth = 0.0;
    return changes ? sight | kChanges : sight;
}

/// @param seenNumber  receives a sight @param rim  from rimWords
uint COLOR_AT(inout uint seenNumber, vec2 pixel, uint rim) {
    vec2 q = planePoint(sampledAt(pixel));
    uint number = max(seenNumber, 1u);
    Seen seen = SEEN(max(place(number), FIRST), q);
#ifdef RIMS
    vec3 lit = computeLight(seen.hit, storedColor(seen), seen.baked, q);
    return rimmed(vec4(seenNumber == 0u ? vec3(0.0) : lit, seenNumber == 0u ? 0.0 : 1.0), rim);
#else
    vec3 color = computeColor(seen.hit, storedColor(seen), seen.baked, q);
    if (kNumbered) seenNumber = seenNumber == 0u ? 0u : packSight(seen.hit, number);
    return seenNumber == 0u ? 0u : packUnorm4x8(vec4(color, 1.0));
#endif
}

#ifdef CYLINDERS
/// Shades a tile's pixels of one kind, as many at once as there are lanes: mixing kinds in a subgroup would execute
/// both branches. Pixels that do not fill all lanes carry over to the next tile of the group.
/// @param left  carried over from the previous tile, then for the next one @param last  no tile follows
void SHADE(inout Left left, bool last, uvec2 corner, uint pitch, uint lane, float width, float depth) {
    uint mine = 0u;  // a bit per pixel, for this lane and for all lanes in turn
    for (int i = 0; i < kPixels; ++i) mine |= number[i] != 0u && findKind(number[i]) == KIND ? 1u << i : 0u;
    uvec2 bits = uvec2(0u);
    for (int i = 0; i < kLanes; ++i) bits[i * kPixels / 32] |= subgroupShuffle(mine, uint(i)) << (i * kPixels % 32);
    uint before = left.count, count = before + uint(bitCount(bits.x) + bitCount(bits.y)), done = 0u;
    do {
        uint slot = done + lane;
        Left own = findPixel(bits, slot - before, corner);
        bool older = slot < before, live = slot < count;
        uint seen = live ? older ? left.number : own.number : 0u, on = older ? left.on : own.on;
        uint rim = older ? left.rim : own.rim;
        uvec2 at = uvec2(on & 0xffffu, on >> 16);
        vec2 pixel = vec2(at) + 0.5;
        uint color = COLOR_AT(seen, pixel, rim);
        uint sight = kNumbered ? MARKED(seen, pixel, width, depth) : 0u;
        if (live) {
            numbers[at.y * pitch + at.x] = color;
            if (kNumbered) pixelNumbers[at.y * pitch + at.x] = sight;
        }
        done += uint(kLanes);
    } while (last ? done < count : done + uint(kLanes) <= count);
    left = findPixel(bits, done + lane - before, corner);
    left.count = max(count, done) - done;
}
#endif

#undef KIND
#undef FIRST
#undef SEEN
#undef HIT
#undef SIGHT_AT
#undef MARKED
#undef COLOR_AT
#undef SHADE
