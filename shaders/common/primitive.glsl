// The primitive of a fragment, as passed by the vertex stage of its kind, flat.
//   CYLINDER, TRIANGLE   its kind; otherwise a sphere
//   FETCHED   the vertex stage passes its number alone; bindings as in fetch.glsl
#include "hit.glsl"

#if defined(CYLINDER)
layout(location = 0) flat in vec4 endA;  // view space, radius
layout(location = 1) flat in vec4 endB;  // view space, 1 / length
Hit primitiveHitAt(vec2 fragment) { return cylinderHit(endA.xyz, endB, endA.w, fragment); }
#elif defined(TRIANGLE) && defined(FETCHED)
#include "facet.glsl"
layout(location = 0) flat in uint number;
Facet facet = facetOf(number);
Hit primitiveHitAt(vec2 fragment) { return facetHitThrough(facet, planePoint(fragment)); }
#elif defined(TRIANGLE)
layout(location = 0) flat in vec3 cornerA;  // projected()
layout(location = 1) flat in vec3 cornerB;
layout(location = 2) flat in vec3 cornerC;
layout(location = 3) flat in uint joins;
Hit primitiveHitAt(vec2 fragment) {
    return triangleHitThrough(cornerA, cornerB, cornerC, joins, planePoint(fragment));
}
#else
#ifdef FETCHED
#include "fetch.glsl"
layout(location = 0) flat in uint number;
vec4 fetchedSphere() {
    vec4 stored = uintBitsToFloat(shapes[number]);
    precise vec3 center = toView(stored.xyz);
    return vec4(center, stored.w);
}
vec4 sphere = fetchedSphere();
#else
layout(location = 0) flat in vec4 sphere;  // view space, radius
#endif
Hit primitiveHitAt(vec2 fragment) { return sphereHit(sphere, fragment); }
#endif
Hit primitiveHit() { return primitiveHitAt(gl_FragCoord.xy); }
