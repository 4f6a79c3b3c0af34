// The primitive of a fragment: flat varyings from its vertex stage.
//   CYLINDER, TRIANGLE   its kind; otherwise a sphere
// FETCHED   varyings hold a number, and for spheres the centre; bindings as in fetch.glsl
#include "hit.glsl"

#if defined(CYLINDER)
layout(location = 0) flat in vec4 endA;  // view space, radius
layout(location = 1) flat in vec4 endB;  // view space, 1 / length
Hit primitiveHitAt(vec2 fragment) { return cylinderHit(endA.xyz, endB, endA.w, fragment); }
#elif defined(TRIANGLE) && defined(FETCHED)
#include "facet.glsl"
layout(location = 0) flat in uint number;
Facet facet = loadFacet(number);
Hit primitiveHitAt(vec2 fragment) { return facetHitThrough(facet, planePoint(fragment)); }
#elif defined(TRIANGLE)
layout(location = 0) flat in vec3 cornerA;  // projected()
layout(location = 1) flat in vec3 cornerB;
layout(location = 2) flat in vec3 cornerC;
layout(location = 3) flat in uint division;
Hit primitiveHitAt(vec2 fragment) {
    return triangleHitThrough(cornerA, cornerB, cornerC, division, planePoint(fragment));
}
#else
#ifdef FETCHED
#include "atlas.glsl"
layout(set = 0, binding = 4, std430) readonly buffer Balls { vec4 balls[]; };  // linear colour; radius, below 0 for a tint
layout(location = 0) flat in uvec4 passed;  // centre in view space, sphereCell()
vec4 ball = balls[sphereOfCell(passed.w)];
vec4 sphere = vec4(uintBitsToFloat(passed.xyz), abs(ball.w));
#else
layout(location = 0) flat in vec4 sphere;  // view space, radius
#endif
layout(location = 5) flat in vec4 rowA;  // of an ellipsoid, as in ellipsoidHitThrough()
layout(location = 6) flat in vec4 rowB;
Hit primitiveHitAt(vec2 fragment) {
    Hit hit;
    if (kEllipsoids == 0)
        hit = sphereHit(sphere, fragment);
    else
        hit = ellipsoidHitThrough(sphere, rowA, rowB, planePoint(fragment));
    return hit;
}
#endif
Hit primitiveHit() { return primitiveHitAt(gl_FragCoord.xy); }
