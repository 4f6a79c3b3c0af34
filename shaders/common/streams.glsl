// Streams for shaders that select primitives by number. TEXELS: texel buffers, which software devices gather vector by
// vector, but storage buffers lane by lane. Otherwise storage buffers, which have no element limit.
//   STREAMS   binding of the first: shapes, then rows of the copies
//   LOOKS     binding of the looks, if read: two words per sphere, four per cylinder
#include "divide.glsl"

// Whether the scene has copies; if not, everything has the transform of the push constants.
layout(constant_id = kCopiesId) const bool kCopies = false;

#ifdef TEXELS
layout(set = 0, binding = STREAMS) uniform usamplerBuffer shapeTexels;
layout(set = 0, binding = STREAMS + 1) uniform samplerBuffer rowTexels;
uvec4 shapeBits(uint i) { return texelFetch(shapeTexels, int(i)); }
uint countShapes() { return uint(textureSize(shapeTexels)); }
vec4 rowAt(uint i) { return texelFetch(rowTexels, int(i)); }
#ifdef LOOKS
layout(set = 0, binding = LOOKS) uniform usamplerBuffer lookTexels;
uint lookAt(uint i) { return texelFetch(lookTexels, int(i)).x; }
#endif
#else
layout(set = 0, binding = STREAMS, std430) readonly buffer Shapes { uvec4 shapes[]; };
layout(set = 0, binding = STREAMS + 1, std430) readonly buffer Rows { vec4 rows[]; };
uvec4 shapeBits(uint i) { return shapes[i]; }
uint countShapes() { return uint(shapes.length()); }
vec4 rowAt(uint i) { return rows[i]; }
#ifdef LOOKS
layout(set = 0, binding = LOOKS, std430) readonly buffer Looks { uint looks[]; };
uint lookAt(uint i) { return looks[i]; }
#endif
#endif

vec4 shapeAt(uint i) { return uintBitsToFloat(shapeBits(i)); }

#ifdef TRIANGLES
#include "mesh.glsl"

/// @param index  of the primitive in its copy: after the cylinders' records, two each, records are consecutive
Facet loadFacet(uint index) {
    uvec4 record = shapeBits(index + view.cylinders);
    return facetFrom(shapeBits(record.x), shapeBits(record.y), shapeBits(record.z), record,
                     view.primitives + view.cylinders);
}
bool isTriangle(uint index) { return index >= view.spheres + view.cylinders; }
#endif

/// Splits a number into copy and primitive. @returns the primitive: spheres first, then cylinders
uint place(uint number) {
    if (!kCopies) {
        copyRow0 = view.row0;
        copyRow1 = view.row1;
        copyRow2 = view.row2;
        return number - 1u;
    }
    uvec2 at = divided(number - 1u, view.primitives);
    copyIndex = at.x;
    copyRow0 = rowAt(3u * at.x);
    copyRow1 = rowAt(3u * at.x + 1u);
    copyRow2 = rowAt(3u * at.x + 2u);
    return at.y;
}

#include "balls.glsl"
/// @param number  of a sphere, counted as above
Hit numberedBallHit(uint number, vec4 sphere, vec2 q) {
    Hit hit;
    if (kEllipsoids == 0)
        hit = sphereHitThrough(sphere, q);
    else
        hit = ballHitThrough(place(max(number, 1u)), sphere, q);
    return hit;
}
