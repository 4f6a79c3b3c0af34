// The visible part of a primitive at a pixel or sample, together with its number: an edge is where this changes.
#ifndef NACRE_SIGHT_GLSL
#define NACRE_SIGHT_GLSL
#include "hit.glsl"

const uint kSecondHalf = 0x80000000u;
const uint kContour = 0x40000000u;
const uint kCutFace = 0x20000000u;
const uint kThirdCorner = 0x10000000u;
const uint kNumber = 0x0fffffffu;
// A sphere has only one part.
const bool kPlain = !kClip && !kContours && kEllipsoids == 0;

uint packSight(Hit hit, uint number) {
    return number | (hit.along >= 0.5 || (hit.corner & 1u) != 0u ? kSecondHalf : 0u) |
           ((hit.corner & 2u) != 0u ? kThirdCorner : 0u) | (kContours && hit.contour ? kContour : 0u) |
           (kClip && hit.cap ? kCutFace : 0u);
}
#endif
