// Triangles in the lists of the `tiles` path, as corners from projected().

#ifdef RIMS
/// Z of a facet's nearest corner.
float facetFront(vec3 a, vec3 b, vec3 c) {
    return kPerspective ? 1.0 / max(a.z, max(b.z, c.z)) : min(a.z, min(b.z, c.z));
}
#endif
/// A lower bound of a facet's Z.
float facetBegins(vec3 a, vec3 b, vec3 c) {
    if (!kPerspective) return min(a.z, min(b.z, c.z)) - 1e-3;
    return 0.99999 / max(a.z, max(b.z, c.z)) - 1e-3;
}

/// Whether a facet may be visible in a rectangle on the plane z = 0: false outside its box, or outside an edge.
bool facetMeets(vec3 a, vec3 b, vec3 c, vec2 middle, vec2 reach) {
    vec2 room = reach + 0.05 * view.pixel + (kContours ? contourReach() : 0.0);
    vec2 low = min(a.xy, min(b.xy, c.xy)) - room, high = max(a.xy, max(b.xy, c.xy)) + room;
    bool meets = all(lessThanEqual(low, middle)) && all(greaterThanEqual(high, middle));
    vec2 pa = a.xy - middle, pb = b.xy - middle, pc = c.xy - middle;
    vec3 sides = vec3(edgeSide(pb, pc), edgeSide(pc, pa), edgeSide(pa, pb));
    vec3 spans = vec3(dot(abs(pc - pb).yx, room), dot(abs(pa - pc).yx, room), dot(abs(pb - pa).yx, room));
    sides *= sides.x + sides.y + sides.z < 0.0 ? -1.0 : 1.0;
    return meets && all(greaterThanEqual(sides, -spans));
}
