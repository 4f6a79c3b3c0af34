// THE arithmetic of visibility: the hit of a pixel on a primitive's record. Every pass and every path calls these
// functions on gl_FragCoord and flat records, so that all of them get the same bits.
#include "view.glsl"

struct Hit {
    bool inside;   // the pixel's ray meets the primitive
    float Z;       // distance as ViewConstants defines it, Å
    vec3 normal;   // view space, unit
    float along;   // cylinders: 0 at a, 1 at b
};

/// A sphere: view-space centre and radius. q: planePoint() of the pixel. Distances are taken from the point of the ray that is closest to the
/// centre, which keeps the digits that the textbook's b*b - 4ac loses.
Hit sphereHitThrough(vec4 sphere, vec2 q) {
    Hit hit;
    hit.along = 0.0;
    if (kPerspective) {
        precise vec3 ray = vec3(q, -view.origin);
        precise vec3 center = vec3(sphere.xy, sphere.z - view.origin);
        precise float a = dot(ray, ray);
        precise float t0 = dot(ray, center) / a;
        precise vec3 w = ray * t0 - center;
        precise float h = sphere.w * sphere.w - dot(w, w);
        hit.inside = h > 0.0;
        precise float s = sqrt(max(h, 0.0) / a);
        precise float t = t0 - s;
        hit.Z = t * view.origin;
        hit.normal = (w - ray * s) / sphere.w;
    } else {
        precise vec2 w = q - sphere.xy;
        precise float h = sphere.w * sphere.w - dot(w, w);
        hit.inside = h > 0.0;
        precise float s = sqrt(max(h, 0.0));
        precise float z = sphere.z + s;
        hit.Z = view.origin - z;
        hit.normal = vec3(w, s) / sphere.w;
    }
    return hit;
}

Hit sphereHit(vec4 sphere, vec2 fragment) { return sphereHitThrough(sphere, planePoint(fragment)); }

/// A cylinder with flat caps from a to b (view space), radius r.
Hit cylinderHitThrough(vec3 a, vec3 b, float r, vec2 q) {
    Hit hit;
    precise vec3 origin = kPerspective ? vec3(0.0, 0.0, view.origin) : vec3(q, 0.0);
    precise vec3 ray = kPerspective ? vec3(q, -view.origin) : vec3(0.0, 0.0, -1.0);
    precise vec3 span = b - a;
    precise float len = sqrt(dot(span, span));
    precise vec3 axis = span / len;
    precise vec3 from = origin - a;
    precise float fromAxis = dot(from, axis);
    precise float rayAxis = dot(ray, axis);
    precise vec3 fromSide = from - axis * fromAxis;
    precise vec3 raySide = ray - axis * rayAxis;
    precise float A = dot(raySide, raySide);
    precise float t0 = -dot(fromSide, raySide) / max(A, 1e-20);
    precise vec3 w = fromSide + raySide * t0;
    precise float h = r * r - dot(w, w);
    precise float t = t0 - sqrt(max(h, 0.0) / max(A, 1e-20));
    precise float s = fromAxis + rayAxis * t;
    bool side = h > 0.0 && A > 1e-12 * dot(ray, ray) && s >= 0.0 && s <= len;
    // The cap that faces the viewer: at a if the ray runs along the axis, at b otherwise.
    precise float capAt = rayAxis > 0.0 ? 0.0 : len;
    precise float tCap = (capAt - fromAxis) / (abs(rayAxis) > 1e-12 ? rayAxis : 1e-12);
    precise vec3 wCap = fromSide + raySide * tCap;
    bool cap = !side && abs(rayAxis) > 1e-12 && dot(wCap, wCap) < r * r;
    precise float tHit = side ? t : tCap;
    hit.inside = side || cap;
    hit.Z = kPerspective ? tHit * view.origin : view.origin + tHit;
    hit.normal = side ? (fromSide + raySide * t) / r : (rayAxis > 0.0 ? -axis : axis);
    hit.along = clamp((fromAxis + rayAxis * tHit) / len, 0.0, 1.0);
    return hit;
}
Hit cylinderHit(vec3 a, vec3 b, float r, vec2 fragment) { return cylinderHitThrough(a, b, r, planePoint(fragment)); }
