// The view of a geometry pass, and what follows from a pixel alone.
#extension GL_GOOGLE_include_directive : require
#include "layout.h"

#ifdef VIEWS
// Several views at once; VIEWS says which one an invocation draws.
layout(set = 0, binding = 1, std140) uniform Views { ViewConstants views[16]; };
#define view views[VIEWS]
#else
layout(push_constant) uniform Push { ViewConstants view; };
#endif
layout(constant_id = 0) const bool kPerspective = false;
// Quarter turns clockwise by which the image is the upright picture turned: a display's pre-rotation.
layout(constant_id = 7) const int kQuarterTurns = 0;

vec2 turned(vec2 p) {
    return kQuarterTurns == 1 ? vec2(-p.y, p.x) : kQuarterTurns == 2 ? -p : kQuarterTurns == 3 ? vec2(p.y, -p.x) : p;
}
vec2 upright(vec2 p) {
    return kQuarterTurns == 1 ? vec2(p.y, -p.x) : kQuarterTurns == 2 ? -p : kQuarterTurns == 3 ? vec2(-p.y, p.x) : p;
}

vec3 toView(vec3 p) {
    precise vec3 v = vec3(dot(view.row0.xyz, p), dot(view.row1.xyz, p), dot(view.row2.xyz, p));
    return v;
}
vec3 toObject(vec3 v) { return view.row0.xyz * v.x + view.row1.xyz * v.y + view.row2.xyz * v.z; }

/// The point of the plane z = 0 that this pixel looks through, Å.
vec2 planePoint(vec2 fragment) {
    precise vec2 q = upright(fragment - view.screen.xy) * view.screen.z;
    return vec2(q.x, -q.y);
}
/// Encoded depth, 0 near to 1 far, of a distance Z.
float encodedDepth(float Z) {
    precise float d = (Z - view.depth.x) * view.depth.y;
    return d;
}
/// Clip position of a point of the plane z = 0 at encoded depth d. w = 1: depth is constant over a polygon.
vec4 clipPosition(vec2 q, float d) {
    return vec4(turned(q * vec2(view.row0.w, view.row1.w) + view.depth.zw), clamp(d, 0.0, 1.0), 1.0);
}
