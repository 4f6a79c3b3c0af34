// Tiles, and entries of their lists: which primitives may be visible in a rectangle.

const int kTile = 8;

/// Corner of a tile, pixels. @param tile  x | unwanted quarters << 12 | y << 16 | small primitives << 31, from a list
uvec2 tileCorner(uint tile) { return uvec2(tile & 0xfffu, tile >> 16 & 0xfffu) * uint(kTile); }
bool wantsQuarter(uint tile, uint quarter) { return (tile >> 12 >> quarter & 1u) == 0u; }
/// Whether a pixel of a tile, counted row by row, is in a wanted quarter.
bool isWanted(uint tile, uint pixel) {
    return wantsQuarter(tile, pixel / uint(kTile * kTile / 2) * 2u + pixel % uint(kTile) / uint(kTile / 2));
}

#include "bounding_disc.glsl"

#ifdef CYLINDERS
/// Whether the hull of two discs on the plane z = 0 may meet a rectangle there: false if a line separates them along
/// one of its sides, along the axis, or across it. @param from, to  centres of the discs
bool spanMeets(vec2 from, vec2 to, float radius, vec2 middle, vec2 reach) {
    vec2 room = reach + radius, half_ = 0.5 * abs(to - from), off = abs(middle - 0.5 * (from + to));
    vec2 way = to - from, away = middle - from;
    float beside = abs(way.x * away.y - way.y * away.x);
    float length_ = sqrt(dot(way, way));
    return all(lessThanEqual(off, half_ + room)) && beside <= dot(abs(way.yx), reach) + length_ * radius;
}
#endif

#ifdef TRIANGLES
#include "tile_facets.glsl"
#endif

/// An entry of a list.
struct Entry {
    uint number;
    bool cylinder, facet;
    bool meets;  // overlaps the rectangle
    vec4 a;      // view space: centre and radius
    vec3 b, c;   // with a, a triangle's corners, as they are projected
    uint division;  // of a triangle among its corners
#ifdef CYLINDERS
    Stick stick;
#endif
#ifdef RIMS
    float front;  // encoded depth of the polygon in which the other paths draw its rim
#endif
    float next;  // encoded depth at which the next chunk begins; valid in the chunk's last lane
};

/// @param middle, reach  centre and half size of the rectangle, on the plane z = 0
Entry entryAt(uint number, vec2 middle, vec2 reach) {
    Entry e;
    e.number = number;
    uint index = place(number);
    e.cylinder = e.facet = false;
    e.b = e.c = vec3(0.0);
    e.division = 0u;
#ifdef TRIANGLES
    e.facet = isTriangle(index);
    Facet f = loadFacet(e.facet ? index : view.spheres + view.cylinders);
    index = e.facet ? 0u : index;
#endif
#ifdef CYLINDERS
    e.cylinder = !e.facet && index >= view.spheres;
    index = e.cylinder ? 2u * index - view.spheres : index;
#endif
    vec4 shape = shapeAt(index);
    e.a = vec4(toView(shape.xyz), shape.w);
#ifdef CYLINDERS
    vec4 end = endToView(shapeAt(e.cylinder ? index + 1u : index));
    float radius = stickRadius(shape.w, e.a.z, end.z);
    e.a.w = abs(radius);
#endif
    vec3 disc = boundingDisc(e.a.xyz, outlinedRadius(e.a.z, e.a.w));
    float front = e.a.z;
    vec2 away = middle - disc.xy;
    vec2 outside = max(abs(away) - reach, 0.0);
    e.meets = dot(outside, outside) <= disc.z * disc.z;
#ifdef CYLINDERS
    vec3 other = boundingDisc(end.xyz, outlinedRadius(end.z, e.a.w));
    e.meets = e.cylinder ? spanMeets(disc.xy, other.xy, max(disc.z, other.z), middle, reach) : e.meets;
    e.stick = makeStick(e.a.xyz, end, radius);
    front = e.cylinder ? max(e.a.z, end.z) : front;
#endif
    float begins = view.origin - front - e.a.w * 1.001;
#ifdef RIMS
    const float capRoom = kClip ? kCapDepth : 0.0;
    float frontZ = view.origin - e.a.z - (e.a.w + capRoom);  // as in the vertex stages
#ifdef CYLINDERS
    vec3 ahead = normalize(end.xyz - e.a.xyz);
    float stickFront = front + e.a.w * sqrt(max(1.0 - ahead.z * ahead.z, 0.0));
    frontZ = e.cylinder ? view.origin - stickFront - e.a.w * 1e-3 - capRoom : frontZ;
#endif
#endif
#ifdef TRIANGLES
    if (e.facet) {
        e.a = vec4(projectVertex(f.a, f.step), 0.0);
        e.b = projectVertex(f.b, f.step);
        e.c = projectVertex(f.c, f.step);
        e.division = f.division;
        e.meets = facetMeets(e.a.xyz, e.b, e.c, middle, reach);
        begins = facetBegins(e.a.xyz, e.b, e.c);
#ifdef RIMS
        frontZ = facetFront(e.a.xyz, e.b, e.c) - 1e-4 * (1.0 + abs(view.origin));
#endif
    }
#endif
#ifdef RIMS
    e.front = clamp(encodedDepth(frontZ), 0.0, 1.0);
#endif
    // The next entries begin after the chunk's last one, up to a step of the order.
    float step = 2.0 / float(kListSteps) + (kClip ? kCapDepth * view.perRange : 0.0);
    e.next = encodedDepth(begins) - step;
    return e;
}
