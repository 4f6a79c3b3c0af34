// Outlines and halos of a tile's pixels, once their nearest primitives are known: a second pass over the list. It ends
// where the first one did: a primitive behind the farthest pixel has no rim in front of it.
#include "rims.glsl"

float behindZ[kPixels];  // Z of the visible surface; far away if there is none
Owner owners[kPixels];  // owner of the visible surface
vec3 rims[kPixels];  // from shadeRim()
uint rimWords[kPixels];  // the same with eight bits per value, as on every path

/// @param front  encoded depth of the polygon in which the other paths draw a rim
void addRim(int i, Hit hit, Owner here, float front, bool live) {
    vec3 rim = shadeRim(hit, here, number[i] != 0u, owners[i], behindZ[i]);
    bool shows = live && hit.contour && front <= nearest[i];
    rims[i] = shows ? max(rims[i], rim) : rims[i];
}

Owner findOwner(uint number, bool secondHalf) {
    uint index = place(number);
    return Owner(kCopies ? copyIndex : 0u, lookGroup(index, secondHalf));
}
Owner handed(Owner owner, uint from) {
    return Owner(kCopies ? subgroupShuffle(owner.copy, from) : 0u, subgroupShuffle(owner.group, from));
}

/// @param at, end  of the list; not empty
void findRims(uint at, uint end, uint lane, vec2 middle, vec2 reach) {
    for (int i = 0; i < kPixels; ++i) {
        rims[i] = vec3(0.0);
        owners[i] = findOwner(max(number[i], 1u), false);
    }
    view.contourWidth = max(effects.lineWidth, effects.haloWidth);
    bool more = true;
    do {
        bool mine = at + lane < end;
        Entry e = entryAt(listAt(min(at + lane, end - 1u)), middle, reach);
        Owner first = findOwner(e.number, false);
        uint balls = ballotLanes(mine && e.meets && !e.cylinder && !e.facet);
        at += uint(kLanes);
        do {
            uint from = lowestBit(balls);
            vec4 sphere = handed(e.a, from);
            Owner here = handed(first, from);
            uint candidate = subgroupShuffle(e.number, from);
            float front = subgroupShuffle(e.front, from);
            bool live = balls != 0u;
            for (int i = 0; i < kPixels; ++i)
                addRim(i, numberedBallHit(candidate, sphere, through[i]), here, front, live);
            balls &= balls - 1u;
        } while (balls != 0u);
#ifdef CYLINDERS
        uint sticks = ballotLanes(mine && e.meets && e.cylinder);
        Owner second = findOwner(e.number, e.cylinder);
        do {
            uint from = lowestBit(sticks);
            Stick stick = handed(e.stick, from);
            Owner here = handed(first, from);
            uint other = subgroupShuffle(second.group, from);
            float front = subgroupShuffle(e.front, from);
            bool live = sticks != 0u;
            for (int i = 0; i < kPixels; ++i) {
                Hit hit = stickHitThrough(stick, through[i]);
                addRim(i, hit, Owner(here.copy, hit.along >= 0.5 ? other : here.group), front, live);
            }
            sticks &= sticks - 1u;
        } while (sticks != 0u);
#endif
#ifdef TRIANGLES
        uint facets = ballotLanes(mine && e.meets && e.facet);
        do {
            uint from = lowestBit(facets);
            vec3 a = handedCorner(e.a.xyz, from), b = handedCorner(e.b, from), c = handedCorner(e.c, from);
            Owner here = handed(first, from);
            float front = subgroupShuffle(e.front, from);
            bool live = facets != 0u;
            for (int i = 0; i < kPixels; ++i)
                addRim(i, triangleHitThrough(a, b, c, 0u, through[i]), here, front, live);
            facets &= facets - 1u;
        } while (facets != 0u);
#endif
        more = goesOn(at, end, e.next);
    } while (more);
    for (int i = 0; i < kPixels; ++i) rimWords[i] = packUnorm4x8(vec4(rims[i], 0.0));
}
