// THE arithmetic of visibility: the hit of a pixel on a primitive's record. Every pass and every path calls these
// functions on gl_FragCoord and flat records, so that all of them get the same bits.
#ifndef NACRE_HIT_GLSL
#define NACRE_HIT_GLSL
#include "view.glsl"

struct Hit {
    bool inside;   // the pixel's ray meets the primitive
    float Z;       // distance as ViewConstants defines it, Å
    float order;  // sort key of hits: Z; less for a cap, more for an outline
    vec3 normal;   // view space, unit
    float along;   // cylinders: 0 at a, 1 at b
    bool cap;  // on the near clipping plane, inside the clipped primitive
    bool contour;  // beside the primitive, on its outline or rim
    vec3 shares;  // triangles: weights of the corners, sum 1
    uint corner;  // triangles: the first corner of the equally coloured group with the largest total weight; ellipsoids:
                  // marks (ellipsoid.glsl)
    bool back;     // triangles: seen from behind
    float away;  // in the rim: distance from the silhouette as a fraction of the rim's width
};

Hit noHit() {
    return Hit(false, 0.0, 0.0, vec3(0.0, 0.0, 1.0), 0.0, false, false, vec3(0.0), 0u, false, 0.0);
}

/// Where a plane clips: moves a hit from the surface to the cap, or removes it. @param deep  depth of the pixel's point
/// of the near plane inside the primitive: 1 innermost, 0 on its surface
void cut(inout Hit hit, float deep) {
    if (deep > 0.0) {
        hit.inside = hit.cap = true;
        hit.Z = view.clipNear;
        precise float order = view.clipNear - kCapDepth * deep;
        hit.order = order;
        hit.normal = vec3(0.0, 0.0, 1.0);
    } else if (hit.Z < view.clipNear) {
        hit.inside = false;
    }
    if (hit.Z > view.clipFar) hit.inside = hit.cap = false;
}

/// A pixel beside a primitive is on its outline if near enough. The outline lies behind the silhouette, by the depth
/// jump at which it appears. A rim (rims.frag) needs the distance alone.
/// @param outside  distance from the silhouette @param width  of the outline there @param Z  of the silhouette
void drawContour(inout Hit hit, float outside, float width, float Z) {
    if (hit.inside || !(outside <= width)) return;
    hit.inside = hit.contour = true;
    hit.Z = Z;
    hit.away = outside / width;
    // Keeps the outline in front of the background, at the end of the depth range.
    precise float behind = Z + view.contourDepth;
    hit.order = min(behind, view.depthStart + 0.99999 / view.perRange);
    hit.normal = vec3(0.0, 0.0, 1.0);
}

/// A sphere: view-space centre and radius. q: planePoint() of the pixel. Distances are measured from the ray's point
/// closest to the centre, which keeps digits that the textbook's b*b - 4ac loses.
Hit sphereHitThrough(vec4 sphere, vec2 q) {
    Hit hit = noHit();
    float r = sphere.w;
    precise float outside = 0.0, silhouetteZ = 0.0, scale = 1.0;
    if (kPerspective) {
        precise vec3 ray = vec3(q, -view.origin);
        precise vec3 center = vec3(sphere.xy, sphere.z - view.origin);
        precise float a = dot(ray, ray);
        precise float t0 = dot(ray, center) / a;
        precise vec3 w = ray * t0 - center;
        precise float h = r * r - dot(w, w);
        hit.inside = h > 0.0;
        precise float s = sqrt(max(h, 0.0) / a);
        precise float t = t0 - s;
        hit.Z = t * view.origin;
        hit.normal = (w - ray * s) * (1.0 / r);
        if (kContours) {
            outside = sqrt(dot(w, w)) - r;
            silhouetteZ = t0 * view.origin;
            scale = t0;
        }
    } else {
        precise vec2 w = q - sphere.xy;
        precise float h = r * r - dot(w, w);
        hit.inside = h > 0.0;
        // Outside, the value does not matter, and |h| avoids a branch. Independent work goes before the root.
        precise float s = sqrt(abs(h));
        precise float middle = view.origin - sphere.z;
        precise float Z = middle - s;
        hit.Z = Z;
        hit.normal = vec3(w, s) * (1.0 / r);
        if (kContours) {
            outside = sqrt(dot(w, w)) - r;
            silhouetteZ = middle;
        }
    }
    hit.order = hit.Z;
    if (kClip) {
        precise float Z = view.origin - sphere.z;
        precise float behind = clamp(Z, view.clipNear, view.clipFar) - Z;
        precise vec2 p = q * (kPerspective ? view.clipNear / view.origin : 1.0) - sphere.xy;
        precise float above = view.clipNear - Z;
        precise float deep = 1.0 - (dot(p, p) + above * above) / (r * r);
        cut(hit, deep);
        if (kContours && behind != 0.0) {  // the silhouette is the rim of the cut
            silhouetteZ = Z + behind;
            scale = kPerspective ? silhouetteZ / view.origin : 1.0;
            precise vec2 e = q * scale - sphere.xy;
            precise float rim = r * r - behind * behind;
            outside = rim > 0.0 ? sqrt(dot(e, e)) - sqrt(rim) : 1e9;
        }
    }
    if (kContours) drawContour(hit, outside, view.contourWidth * scale, silhouetteZ);
    return hit;
}

Hit sphereHit(vec4 sphere, vec2 fragment) { return sphereHitThrough(sphere, planePoint(fragment)); }

#include "ellipsoid.glsl"

/// A cylinder with flat caps and everything that is the same for all pixels.
struct Stick {
    vec3 a;  // centre of the first end, view space
    float radius;
    vec3 axis;  // unit, towards the other end
    float len;
    vec2 ahead;    // unit: the axis in the picture
    float sine;  // of the angle between axis and view direction; also the divisor
    float perSine;
    float perFall; // 1 / axis.z
    float perLen;
};
/// @param b  the other end, and 1 / length, stored to avoid a root and a division per pixel
Stick makeStick(vec3 a, vec4 b, float radius) {
    precise vec3 span = b.xyz - a;
    precise vec3 axis = span * b.w;
    precise float len = dot(span, axis);
    precise float flat_ = sqrt(dot(axis.xy, axis.xy));
    precise float sine = max(flat_, 1e-6);
    precise float perSine = 1.0 / sine;
    precise vec2 ahead = flat_ > 1e-6 ? axis.xy * perSine : vec2(1.0, 0.0);
    precise float perFall = 1.0 / (abs(axis.z) > 1e-12 ? axis.z : 1e-12);
    return Stick(a, radius, axis, len, ahead, sine, perSine, perFall, b.w);
}

/// @param a, b  as stored
Stick stickAt(vec4 a, vec4 b) {
    precise vec3 from = toView(a.xyz);
    precise vec4 to = endToView(b);
    return makeStick(from, to, stickRadius(a.w, from.z, to.z));
}

/// A cylinder's hit before clipping, with data for clipping and outlines.
struct StickHit {
    Hit hit;
    float on;         // Å from a along the axis
    float away2;  // squared distance between axis and ray
    float inside;  // squared radius minus away2
    vec2 silhouette;  // the ray's point nearest to the axis: its Z, and its position along the axis
    vec2 cut;  // the same for the near clipping plane: its depth inside as in cut(), and its position along the axis
};

/// Orthographic: the position across and along the projected axis is enough.
/// @param sideKnown  the hit is known to be on the side
StickHit parallelStickHit(Stick c, vec2 q, const bool sideKnown) {
    StickHit found;
    Hit hit = noHit();
    float r = c.radius;
    precise vec2 p = q - c.a.xy;
    precise float beside = c.ahead.x * p.y - c.ahead.y * p.x;
    precise float ahead = (c.ahead.x * p.x + c.ahead.y * p.y) * c.perSine;
    precise float h = r * r - beside * beside;
    precise float root = sqrt(abs(h));
    precise float steep = c.axis.z * c.perSine;
    precise float s = ahead + steep * root;
    bool side = sideKnown || (h > 0.0 && s >= 0.0 && s <= c.len);
    // The cap that faces the viewer.
    float capAt = c.axis.z < 0.0 ? 0.0 : c.len;
    precise float across = (capAt - ahead) * (c.sine * c.perFall);
    bool cap = !side && abs(c.axis.z) > 1e-12 && across * across < h;
    precise float middle = view.origin - c.a.z;
    precise float onSide = c.axis.z * ahead + root * c.perSine;
    precise float onCap = c.axis.z * capAt + across * c.sine;
    hit.inside = side || cap;
    precise float Z = middle - (side ? onSide : onCap);
    hit.Z = Z;
    // The projected axis rotated to the left, plus the component towards the viewer.
    precise vec3 outwards = vec3(vec2(-c.ahead.y, c.ahead.x) * beside - c.ahead * (c.axis.z * root), c.sine * root) * (1.0 / r);
    hit.normal = side ? outwards : c.axis.z < 0.0 ? -c.axis : c.axis;
    if (isWire(r)) hit.normal = vec3(0.0, 0.0, 1.0);  // wires look the same from all sides
    found.hit = hit;
    found.on = side ? s : capAt;
    found.away2 = beside * beside;
    found.inside = h;
    precise float silhouetteZ = middle - c.axis.z * ahead;
    found.silhouette = vec2(silhouetteZ, ahead);
    precise float height = middle - view.clipNear;
    precise float lean = c.sine * (height - c.axis.z * ahead);
    precise float deep = 1.0 - (beside * beside + lean * lean) / (r * r);
    precise float onCut = c.sine * (c.sine * ahead) + c.axis.z * height;
    found.cut = vec2(deep, onCut);
    return found;
}

/// Perspective.
StickHit pointStickHit(Stick c, vec2 q) {
    StickHit found;
    Hit hit = noHit();
    float r = c.radius;
    precise vec3 ray = vec3(q, -view.origin);
    precise vec3 from = vec3(0.0, 0.0, view.origin) - c.a;
    precise float fromAxis = dot(from, c.axis);
    precise float rayAxis = dot(ray, c.axis);
    precise vec3 fromSide = from - c.axis * fromAxis;
    precise vec3 raySide = ray - c.axis * rayAxis;
    precise float A = dot(raySide, raySide);
    precise float perA = 1.0 / max(A, 1e-20);
    precise float t0 = -dot(fromSide, raySide) * perA;
    precise vec3 w = fromSide + raySide * t0;
    precise float away2 = dot(w, w);
    precise float h = r * r - away2;
    precise float t = t0 - sqrt(max(h, 0.0) * perA);
    precise float s = fromAxis + rayAxis * t;
    bool side = h > 0.0 && A > 1e-12 * dot(ray, ray) && s >= 0.0 && s <= c.len;
    // The cap that faces the viewer: at a if the ray runs along the axis, at b otherwise.
    precise float capAt = rayAxis > 0.0 ? 0.0 : c.len;
    precise float tCap = (capAt - fromAxis) / (abs(rayAxis) > 1e-12 ? rayAxis : 1e-12);
    precise vec3 wCap = fromSide + raySide * tCap;
    bool cap = !side && abs(rayAxis) > 1e-12 && dot(wCap, wCap) < r * r;
    precise float tHit = side ? t : tCap;
    hit.inside = side || cap;
    hit.Z = tHit * view.origin;
    hit.normal = side ? (fromSide + raySide * t) / r : (rayAxis > 0.0 ? -c.axis : c.axis);
    if (isWire(r)) hit.normal = vec3(0.0, 0.0, 1.0);
    found.hit = hit;
    found.on = side ? s : capAt;
    found.away2 = away2;
    found.inside = h;
    precise float s0 = fromAxis + rayAxis * t0;
    found.silhouette = vec2(t0 * view.origin, A > 1e-12 * dot(ray, ray) ? s0 : -1.0);
    precise float tCut = view.clipNear / view.origin;
    precise vec3 wCut = fromSide + raySide * tCut;
    precise float deep = 1.0 - dot(wCut, wCut) / (r * r);
    precise float onCut = fromAxis + rayAxis * tCut;
    found.cut = vec2(deep, onCut);
    return found;
}

Hit stickHitThrough(Stick c, vec2 q, const bool sideKnown) {
    StickHit found;
    if (kPerspective)
        found = pointStickHit(c, q);
    else
        found = parallelStickHit(c, q, sideKnown);
    Hit hit = found.hit;
    hit.order = hit.Z;
    float on = found.on;
    if (kClip) {
        cut(hit, found.cut.y >= 0.0 && found.cut.y <= c.len ? found.cut.x : 0.0);
        if (hit.cap) on = found.cut.y;
    }
    if (kContours) {
        float Z = found.silhouette.x, along = found.silhouette.y;
        bool kept = along >= 0.0 && along <= c.len && (!kClip || (Z >= view.clipNear && Z <= view.clipFar));
        // Inside the silhouette without a hit: everything was clipped.
        precise float outside = kept && found.inside <= 0.0 ? sqrt(found.away2) - abs(c.radius) : 1e9;
        drawContour(hit, outside, view.contourWidth * (kPerspective ? Z / view.origin : 1.0), Z);
        if (hit.contour) on = along;
    }
    hit.along = clamp(on * c.perLen, 0.0, 1.0);
    return hit;
}
Hit stickHitThrough(Stick c, vec2 q) { return stickHitThrough(c, q, false); }
Hit cylinderHitThrough(vec3 a, vec4 b, float r, vec2 q) { return stickHitThrough(makeStick(a, b, r), q); }
Hit cylinderHit(vec3 a, vec4 b, float r, vec2 fragment) { return cylinderHitThrough(a, b, r, planePoint(fragment)); }

/// A projected corner of a triangle: position on the plane z = 0, and its Z or, in perspective, 1 / Z, which is linear
/// there.
vec3 projected(vec3 p) {
    precise float Z = view.origin - p.z;
    if (!kPerspective) return vec3(p.xy, Z);
    precise float nearness = 1.0 / Z;
    precise vec2 at = p.xy * (view.origin * nearness);
    return vec3(at, nearness);
}
/// Twice the area between the pixel and an edge, from two corners relative to the pixel. Both triangles at an edge get
/// the same number with opposite sign, whatever the rounding, so each pixel on it belongs to at least one.
float edgeSide(vec2 from, vec2 to) {
    precise float side = from.x * to.y - from.y * to.x;
    return side;
}
/// The point of an edge nearest to the pixel: its distance, and the weight of the second corner.
vec2 nearestOnEdge(vec2 from, vec2 to) {
    precise vec2 way = to - from;
    precise float share = clamp(-dot(from, way) / max(dot(way, way), 1e-20), 0.0, 1.0);
    precise vec2 at = from + way * share;
    precise float distance = sqrt(dot(at, at));
    return vec2(distance, share);
}

/// Each corner's claim to a point of a triangle; the point has the look of the largest. Linear in the shares: borders are
/// straight, and meet at the edges of neighbours.
/// @param division  which corners have equal looks: bits 0 a and b, 1 b and c, 2 c and a; then 7 bits for
/// each corner: what its weight lacks to 1, in 128ths
vec3 computeClaims(vec3 shares, uint division) {
    vec3 weights = 1.0 - vec3(division >> 3 & 0x7fu, division >> 10 & 0x7fu, division >> 17 & 0x7fu) * (1.0 / 128.0);
    vec3 joined = vec3(division & 1u, division >> 1 & 1u, division >> 2 & 1u);
    precise vec3 own = shares * weights;
    precise vec3 claims = own + joined * own.yzx + joined.zxy * own.zxy;
    return claims;
}

layout(constant_id = kFrontsOnlyId) const bool kFrontsOnly = false;
const uint kMirrored = 0x80000000u;  // the triangle's copy is a mirror image, which turns it the other way round
/// A triangle from projected() corners. Depth is interpolated as a weighted mean of the corners', so a hit is never in
/// front of or behind all of them. Triangles within kCapRise behind the near plane are its caps (mesh_caps.h). The inner
/// side of a mesh without caps looks like one, at its own depth. This excludes TRANSLUCENT meshes.
/// @param division  as in computeClaims(), with kMirrored; 0 where neither looks nor sides matter
Hit triangleHitThrough(vec3 a, vec3 b, vec3 c, uint division, vec2 q) {
    Hit hit = noHit();
    precise vec2 pa = a.xy - q, pb = b.xy - q, pc = c.xy - q;
    precise float ofA = edgeSide(pb, pc), ofB = edgeSide(pc, pa), ofC = edgeSide(pa, pb);
    precise float sum = ofA + ofB + ofC;
    hit.inside = (min(ofA, min(ofB, ofC)) >= 0.0 || max(ofA, max(ofB, ofC)) <= 0.0) && sum != 0.0;
    hit.back = (sum < 0.0) != ((division & kMirrored) != 0u);
    if (kFrontsOnly) hit.inside = hit.inside && !hit.back;
    precise float unit = 1.0 / (sum == 0.0 ? 1.0 : sum);
    precise vec3 shares = vec3(ofA, ofB, ofC) * unit;
    precise float along = shares.x * a.z + shares.y * b.z + shares.z * c.z;
    if (kPerspective) {
        precise float Z = 1.0 / along;
        precise vec3 inSpace = vec3(shares.x * a.z, shares.y * b.z, shares.z * c.z) * Z;
        hit.Z = Z;
        hit.shares = inSpace;
    } else {
        hit.Z = along;
        hit.shares = shares;
    }
    bool within = hit.inside;
    if (kClip) {
        hit.inside = hit.inside && hit.Z >= view.clipNear && hit.Z <= view.clipFar;
#ifndef TRANSLUCENT
        vec3 behind = (kPerspective ? vec3(1.0) / vec3(a.z, b.z, c.z) : vec3(a.z, b.z, c.z)) - view.clipNear;
        bool onPlane = min(behind.x, min(behind.y, behind.z)) >= 0.0 && max(behind.x, max(behind.y, behind.z)) < kCapRise;
        hit.cap = hit.inside && (hit.back || onPlane) && view.clipNear > -kNoPlane;
#endif
    }
    hit.order = hit.Z;
    if (kContours && !within) {
        vec2 ab = nearestOnEdge(pa, pb), bc = nearestOnEdge(pb, pc), ca = nearestOnEdge(pc, pa);
        bool first = ab.x <= bc.x && ab.x <= ca.x, second = !first && bc.x <= ca.x;
        float share = first ? ab.y : second ? bc.y : ca.y;
        hit.shares = first    ? vec3(1.0 - share, share, 0.0)
                     : second ? vec3(0.0, 1.0 - share, share)
                              : vec3(share, 0.0, 1.0 - share);
        precise float on = hit.shares.x * a.z + hit.shares.y * b.z + hit.shares.z * c.z;
        precise float Z = kPerspective ? 1.0 / on : on;
        bool kept = !kClip || (Z >= view.clipNear && Z <= view.clipFar);
        drawContour(hit, kept ? min(ab.x, min(bc.x, ca.x)) : 1e9, view.contourWidth, Z);
    }
    precise vec3 alike = computeClaims(hit.shares, division);
    hit.corner = alike.x >= max(alike.y, alike.z) ? 0u : alike.y >= alike.z ? 1u : 2u;
    return hit;
}
#endif
