// Data of a pixel's primitive by its number, for the tile shaders.
//   CYLINDERS, TRIANGLES   the scene has some
#include "color.glsl"
#include "streams.glsl"

struct Seen {
    Hit hit;
    uint look;  // index of the atom's colour in the looks
    uint atom;  // index of the atom's number in the looks
#ifdef TRIANGLES
    uvec3 corners;  // triangles: indices of the corners' colours; otherwise all equal `look`
#endif
    Baked baked;  // patchTexel()
};

#ifdef TRIANGLES
/// @param index  of the primitive in its copy (also below) @param q  planePoint() of the pixel
Seen seenFacet(uint index, vec2 q) {
    Seen seen;
    Facet f = loadFacet(index);
    seen.hit = facetHitThrough(f, q);
    smoothNormal(seen.hit, uvec3(f.a.z, f.b.z, f.c.z));
    seen.look = seen.hit.corner == 0u ? f.a.w : seen.hit.corner == 1u ? f.b.w : f.c.w;
    seen.atom = seen.look + 1u;
    seen.corners = uvec3(f.a.w, f.b.w, f.c.w);
    seen.baked = meshOcclusion(seen.hit, f.vertices);
    return seen;
}
#endif
#ifdef CYLINDERS
/// @param sideKnown  the pixel certainly shows the cylinder's side
Seen seenStick(uint index, vec2 q, const bool sideKnown) {
    Seen seen;
    index -= view.spheres;
    vec4 shapeA = shapeAt(view.spheres + 2u * index);
    vec4 shapeB = shapeAt(view.spheres + 2u * index + 1u);
    precise vec3 a = toView(shapeA.xyz);
    precise vec4 b = endToView(shapeB);
    seen.hit = stickHitThrough(makeStick(a, b, stickRadius(shapeA.w, a.z, b.z)), q, sideKnown);
    seen.look = 2u * view.spheres + 4u * index + (seen.hit.along < 0.5 ? 0u : 1u);
    seen.atom = seen.look + 2u;
#ifdef TRIANGLES
    seen.corners = uvec3(seen.look);
#endif
    vec3 axis = (shapeB.xyz - shapeA.xyz) * shapeB.w;
    bool shaded = shapeA.w >= 0.0 && shadesOcclusion(seen.hit);  // a wire has no patch
    seen.baked = shaded ? cylinderTexel(index, cylinderCoordinate(seen.hit, axis)) : kOpen;
    return seen;
}
Seen seenStick(uint index, vec2 q) { return seenStick(index, q, false); }
#endif
Seen seenBall(uint index, vec2 q) {
    Seen seen;
    vec4 shape = shapeAt(index);
    precise vec3 center = toView(shape.xyz);
    seen.hit = ballHitThrough(index, vec4(center, shape.w), q);
    seen.look = 2u * index;
    seen.atom = seen.look + 1u;
#ifdef TRIANGLES
    seen.corners = uvec3(seen.look);
#endif
    seen.baked = shadesOcclusion(seen.hit) ? sphereTexel(index, sphereCoordinate(seen.hit)) : kOpen;
    return seen;
}

/// @param number  of a primitive, from 1 @param q  planePoint() of the pixel
Seen findSeen(uint number, vec2 q) {
    uint index = place(number);
#ifdef TRIANGLES
    if (isTriangle(index)) return seenFacet(index, q);
#endif
#ifdef CYLINDERS
    if (index >= view.spheres) return seenStick(index, q);
#endif
    return seenBall(index, q);
}

#ifdef LOOKS
/// The stored colour.
uint storedColor(Seen seen) {
#ifdef TRIANGLES
    if (kBlendColors && any(notEqual(seen.corners, uvec3(seen.look))))
        return cornerColor(uvec3(lookAt(seen.corners.x), lookAt(seen.corners.y), lookAt(seen.corners.z)),
                           seen.hit.corner, seen.hit.shares);
#endif
    return lookAt(seen.look);
}
#endif
