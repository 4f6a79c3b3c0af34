// The lists of the `tiles` path (engine/scene/tile_lists.h) as its compute stages go through them: one subgroup a tile,
// a chunk of as many entries as it has lanes at a time.

layout(constant_id = kLanesId) const int kLanes = 8;
layout(constant_id = kTilesInBinId) const int kTilesInBin = 2;
layout(local_size_x_id = 14) in;  // kLanes
const int kTile = 8;

/// A disc on the plane z = 0 that holds a sphere's picture: about the ellipse of common/outline.glsl in perspective.
vec3 discOf(vec3 center, float radius) {
    float room = 0.05 * view.pixel;
    if (!kPerspective) return vec3(center.xy, radius * 1.005 + room);
    float D = view.origin - center.z;
    float rho = length(center.xy);
    float under = D * D - radius * radius;
    float reach = view.origin * radius * sqrt(under + rho * rho) / under;
    return vec3(center.xy * (view.origin * D / under), reach * 1.005 + room);
}

/// The lowest bit that is set; 0 if none is.
uint lowestOf(uint bits) { return bits == 0u ? 0u : (floatBitsToUint(float(bits & (0u - bits))) >> 23) - 127u; }
vec4 handed(vec4 v, uint from) {
    return vec4(subgroupShuffle(v.x, from), subgroupShuffle(v.y, from), subgroupShuffle(v.z, from),
                subgroupShuffle(v.w, from));
}

#ifdef TRIANGLES
#include "tile_facets.glsl"
#endif

/// A primitive of a list.
struct Entry {
    uint number;
    bool cylinder, facet;
    bool meets;  // a rectangle
    vec4 a, b;   // view space: centre and radius; a cylinder's ends; a triangle's corners, as they are projected
    vec3 c;
    uint joins;  // of a triangle's corners
    float next;  // encoded depth before which nothing of the following chunk begins, as the chunk's last lane has it
};

/// @param middle, reach  of the rectangle, on the plane z = 0
Entry entryAt(uint number, vec2 middle, vec2 reach) {
    Entry e;
    e.number = number;
    uint index = place(number);
    e.cylinder = e.facet = false;
    e.c = vec3(0.0);
    e.joins = 0u;
#ifdef TRIANGLES
    e.facet = isTriangle(index);
    Facet f = facetOf(e.facet ? index : view.spheres + view.cylinders);
    index = e.facet ? 0u : index;
#endif
#ifdef CYLINDERS
    e.cylinder = !e.facet && index >= view.spheres;
    index = e.cylinder ? 2u * index - view.spheres : index;
#endif
    vec4 shape = shapeAt(index);
    e.a = vec4(toView(shape.xyz), shape.w);
    vec3 disc = discOf(e.a.xyz, reachOf(e.a.z, e.a.w));
    float front = e.a.z;
    vec2 away = middle - disc.xy;
    vec2 outside = max(abs(away) - reach, 0.0);
    e.meets = dot(outside, outside) <= disc.z * disc.z;
#ifdef CYLINDERS
    e.b = vec4(toView(shapeAt(e.cylinder ? index + 1u : index).xyz), 0.0);
    vec3 other = discOf(e.b.xyz, reachOf(e.b.z, e.a.w));
    vec2 along = other.xy - disc.xy;
    float t = clamp(dot(away, along) / max(dot(along, along), 1e-12), 0.0, 1.0);
    away -= along * t;
    float room = max(disc.z, other.z) + length(reach) * 1.0001;
    e.meets = e.cylinder ? dot(away, away) <= room * room : e.meets;
    front = e.cylinder ? max(e.a.z, e.b.z) : front;
#else
    e.b = vec4(0.0);
#endif
    float begins = view.origin - front - e.a.w * 1.001;
#ifdef TRIANGLES
    if (e.facet) {
        e.a = vec4(cornerOf(f.a, f.step), 0.0);
        e.b = vec4(cornerOf(f.b, f.step), 0.0);
        e.c = cornerOf(f.c, f.step);
        e.joins = joinsOf(f.a.w, f.b.w, f.c.w);
        e.meets = facetMeets(e.a.xyz, e.b.xyz, e.c, middle, reach);
        begins = facetBegins(e.a.xyz, e.b.xyz, e.c);
    }
#endif
    // What follows begins behind the chunk's last entry, up to a step of the order.
    e.next = encodedDepth(begins) - view.depthStep;
    return e;
}
