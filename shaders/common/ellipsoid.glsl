// Ellipsoids among the spheres of a scene. Included by hit.glsl. Records are in scene/build/representation.h: rows of
// the map to the unit sphere whose axes are the ellipsoid's.

/// A ray under the map: its point nearest to the centre, and the height of that above the centre.
/// @param off  the ray's point in the plane of the centre, from that
vec4 nearestOnRay(vec3 g0, vec3 g1, vec3 g2, vec2 off, vec3 along) {
    precise vec3 from = vec3(dot(g0.xy, off), dot(g1.xy, off), dot(g2.xy, off));
    precise float t0 = -dot(from, along) / dot(along, along);
    precise vec3 w = from + along * t0;
    return vec4(w, t0);
}

// Hit::corner of an ellipsoid is the sum of those that hold; triangles have 0 to 2.
const uint kEllipsoidMark = 4u;  // every ellipsoid
const uint kBandMark = 1u;       // band along a principal ellipse, or line on a face of the cut
const uint kFaceMark = 2u;       // face of the cut

/// An axis's part in a vector.
float partOf(vec3 v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

/// An ellipsoid, as the sphere that contains it and two rows of its map in view space.
/// @param rowA  w: the factor of both rows' cross product that is the third row
/// @param rowB  w: half the width of a band, Å; 0: a plain sphere
Hit ellipsoidHitThrough(vec4 sphere, vec4 rowA, vec4 rowB, vec2 q) {
    Hit hit = noHit();
    vec3 center = sphere.xyz;
    precise vec3 g0 = rowA.xyz, g1 = rowB.xyz, g2 = cross(g0, g1) * rowA.w;
    precise float middle = view.origin - center.z;
    precise float at = kPerspective ? middle / view.origin : 1.0;
    precise vec3 way = kPerspective ? vec3(q * (-1.0 / view.origin), 1.0) : vec3(0.0, 0.0, 1.0);
    precise vec3 along = vec3(dot(g0, way), dot(g1, way), dot(g2, way));  // towards the viewer
    precise vec2 off = q * at - center.xy;
    vec4 closest = nearestOnRay(g0, g1, g2, off, along);
    vec3 w = closest.xyz;
    precise float square = dot(w, w);
    precise float s = sqrt(max(1.0 - square, 0.0) / dot(along, along));
    precise vec3 p = w + along * s;
    precise float Z = middle - (closest.w + s);
    hit.inside = square < 1.0;
    precise vec3 gradient = g0 * p.x + g1 * p.y + g2 * p.z;
    hit.normal = gradient * inversesqrt(max(dot(gradient, gradient), 1e-30));
    vec3 lengths = vec3(sqrt(dot(g0, g0)), sqrt(dot(g1, g1)), sqrt(dot(g2, g2)));  // 1 / half axes
    vec3 band = min(lengths * rowB.w, 0.2);
    uint mark = rowB.w > 0.0 && any(lessThan(abs(p), band)) ? kBandMark : 0u;
    vec3 signs = vec3(1.0);  // of the octant
    if (kEllipsoids >= 2) {
        precise vec3 eye = kPerspective ? vec3(-center.xy, middle) : vec3(0.0, 0.0, 1.0);
        vec4 viewer = CUT_PLANE(view);
        if (kEllipsoids == 3) eye = kCut ? viewer.xyz : viewer.xyz - center * viewer.w;
        precise vec3 seen = vec3(dot(g0, eye), dot(g1, eye), dot(g2, eye));
        signs = vec3(seen.x < 0.0 ? -1.0 : 1.0, seen.y < 0.0 ? -1.0 : 1.0, seen.z < 0.0 ? -1.0 : 1.0);
        precise vec3 inside = p * signs, falls = along * signs;
        // Behind the octant's surface the ray goes on to the first of its faces.
        precise vec3 steps = vec3(falls.x > 1e-12 ? inside.x / falls.x : 1e30, falls.y > 1e-12 ? inside.y / falls.y : 1e30,
                                  falls.z > 1e-12 ? inside.z / falls.z : 1e30);
        int face = steps.x <= min(steps.y, steps.z) ? 0 : steps.y <= steps.z ? 1 : 2;
        precise float deeper = min(steps.x, min(steps.y, steps.z));
        if (rowB.w > 0.0 && min(inside.x, min(inside.y, inside.z)) > 0.0) {
            precise float faceZ = Z + deeper;
            Z = faceZ;
            hit.inside = hit.inside && deeper <= 2.0 * s;
            vec3 row = face == 0 ? g0 : face == 1 ? g1 : g2;
            hit.normal = row * (partOf(signs, face) / partOf(lengths, face));
            // Lines across an axis of the face, beside the one at its edge.
            const float kLines = 4.0, kLine = 2.0 / 3.0;  // number; width of a band's
            int across = signs.x * signs.y * signs.z > 0.0 ? (face + 1) % 3 : (face + 2) % 3;
            float share = partOf(inside - falls * deeper, across) * (kLines + 1.0);
            float halfLine = min(kLine * rowB.w * partOf(lengths, across) * (kLines + 1.0), 0.2);
            float line = min(max(floor(share + 0.5), 1.0), kLines);
            mark = kFaceMark + (share < 2.0 * halfLine || abs(share - line) < halfLine ? kBandMark : 0u);
        }
    }
    hit.corner = kEllipsoidMark + mark;
    hit.Z = hit.order = Z;
    precise float silhouetteZ = middle - closest.w;
    bool clipped = false;  // at the silhouette
    if (kClip) {
        precise float plane = clamp(silhouetteZ, view.clipNear, view.clipFar);
        clipped = silhouetteZ != plane;
        float planeScale = kPerspective ? view.clipNear / view.origin : 1.0;
        precise vec3 x = vec3(q * planeScale - center.xy, middle - view.clipNear);
        precise vec3 P = vec3(dot(g0, x), dot(g1, x), dot(g2, x));
        vec3 there = P * signs;
        bool gone = kEllipsoids >= 2 && rowB.w > 0.0 && min(there.x, min(there.y, there.z)) > 0.0;
        precise float deep = gone ? 0.0 : 1.0 - dot(P, P);
        cut(hit, deep);
        silhouetteZ = plane;
    }
    if (kContours) {
        // The distance from the silhouette, or from the rim of a cut: steps to the nearest point of an ellipse. None is
        // beyond the distance, nor that from the sphere, by which paths find primitives.
        precise float scale = kPerspective ? silhouetteZ / view.origin : 1.0;
        const int kSteps = 5;
        vec2 foot = q;
        float outside = -1.0;
        for (int i = 0; i < kSteps; ++i) {
            precise vec3 ray = kPerspective ? vec3(foot * (-1.0 / view.origin), 1.0) : vec3(0.0, 0.0, 1.0);
            precise vec3 heading = vec3(dot(g0, ray), dot(g1, ray), dot(g2, ray));
            precise vec3 x = vec3(foot * scale - center.xy, middle - silhouetteZ);
            precise vec3 v = vec3(dot(g0, x), dot(g1, x), dot(g2, x));
            if (!clipped) v = nearestOnRay(g0, g1, g2, foot * at - center.xy, heading).xyz;
            precise float size = sqrt(dot(v, v));
            precise vec2 steep = (g0.xy * v.x + g1.xy * v.y + g2.xy * v.z) * (scale / max(size, 1e-20));
            precise float perSteep = inversesqrt(max(dot(steep, steep), 1e-20));
            precise vec2 outward = steep * perSteep;
            outside = dot(q - foot, outward) + (size - 1.0) * perSteep;
            foot = q - outward * outside;
        }
        precise float perAlong = dot(off, way.xy) / dot(way, way);
        precise vec3 beside = vec3(off, 0.0) - way * perAlong;
        precise float fromSphere =
            (sqrt(dot(beside, beside)) - sphere.w) / (kPerspective ? (middle + perAlong) / view.origin : 1.0);
        if (clipped) {
            precise float rise = middle - silhouetteZ;
            precise vec2 there = q * scale - center.xy;
            precise vec3 heights = vec3(g0.z, g1.z, g2.z) / (lengths * lengths);  // of the axes' ends
            bool meets = rise * rise < dot(heights, heights);
            precise float rim = sqrt(max(sphere.w * sphere.w - rise * rise, 0.0));
            fromSphere = meets ? (sqrt(dot(there, there)) - rim) / scale : 1e9;
        }
        drawContour(hit, max(outside, fromSphere), view.contourWidth, silhouetteZ);
    }
    return hit;
}
