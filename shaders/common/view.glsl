// The view of a geometry pass, and functions of a pixel alone.
#ifndef NACRE_VIEW_GLSL
#define NACRE_VIEW_GLSL
#extension GL_GOOGLE_include_directive : require
#include "layout.h"
#include "turn.glsl"
#include "view_index.glsl"

#ifdef TILES
// Copied once at the start of main(): lavapipe 22.3 gathers push constants lane by lane at each use.
TileConstants view;
#else
layout(push_constant) uniform Push { ViewConstants view; };
#endif
layout(constant_id = kPerspectiveId) const bool kPerspective = false;
layout(constant_id = kWholeImageId) const bool kWholeImage = true;
layout(constant_id = kClipId) const bool kClip = false;
layout(constant_id = kCutId) const bool kCut = false;
layout(constant_id = kContoursId) const bool kContours = false;

// The copy that is drawn: that of the draw call, or, with COPY_OF_PIXEL, one that the shader looks up.
#ifdef COPY_OF_PIXEL
vec4 copyRow0, copyRow1, copyRow2;
uint copyIndex = 0u;
#else
#define copyRow0 view.row0
#define copyRow1 view.row1
#define copyRow2 view.row2
#endif

// The views of a draw call differ by a shift and by their axis. The members for outlines, which frames of two views
// lack, hold those of the second view.
#if defined(TILES) || defined(COPY_OF_PIXEL)
#define copyShift copyRow0.w
#else
#define copyShift (viewIndex() == 0 ? view.row0.w : view.contourWidth)
#endif
vec2 axisPixel() {
#ifndef TILES
    if (viewIndex() > 0)
        return (kQuarterTurns & 1) == 1 ? vec2(view.axisPixel.x, view.contourDepth)
                                        : vec2(view.contourDepth, view.axisPixel.y);
#endif
    return view.axisPixel;
}

vec3 toView(vec3 p) {
    precise vec3 v = vec3(fma(copyRow0.z, p.z, copyShift), fma(copyRow1.z, p.z, copyRow1.w),
                          fma(copyRow2.z, p.z, copyRow2.w));
    precise vec3 w = vec3(fma(copyRow0.y, p.y, v.x), fma(copyRow1.y, p.y, v.y), fma(copyRow2.y, p.y, v.z));
    precise vec3 x = vec3(fma(copyRow0.x, p.x, w.x), fma(copyRow1.x, p.x, w.y), fma(copyRow2.x, p.x, w.z));
    return x;
}
/// A cylinder's second end, and 1 / length.
vec4 endToView(vec4 end) { return vec4(toView(end.xyz), end.w); }
vec3 toObject(vec3 v) { return copyRow0.xyz * v.x + copyRow1.xyz * v.y + copyRow2.xyz * v.z; }

/// Ellipsoids among the spheres: 0 none, 1 whole, 2 with the octant cut out that faces the viewer, 3 the same for a
/// light.
layout(constant_id = kEllipsoidsId) const int kEllipsoids = 0;
/// A row of an ellipsoid's map in view space.
vec3 rowToView(vec3 row) {
    precise vec3 seen = vec3(dot(copyRow0.xyz, row), dot(copyRow1.xyz, row), dot(copyRow2.xyz, row));
    return seen;
}
vec4 rowToView(vec4 row) { return vec4(rowToView(row.xyz), row.w); }

/// The point of the plane z = 0 that this pixel looks through, Å.
vec2 planePoint(vec2 fragment) {
    precise vec2 q = upright(fragment - axisPixel()) * view.pixel;
    return vec2(q.x, -q.y);
}
/// Encoded depth, 0 near to 1 far, of a distance Z.
float encodedDepth(float Z) {
    precise float start = view.depthStart * view.perRange;
    precise float d = fma(Z, view.perRange, -start);
    return d;
}
/// A wire has a constant width on screen. Its stored radius is minus half the width, in pixels of the requested
/// picture; the result is a radius in Å, still negative.
layout(constant_id = kWiresId) const bool kWires = true;
bool isWire(float radius) { return kWires && radius < 0.0; }
float stickRadius(float stored, float az, float bz) {
    if (!kWires) return stored;
    precise float middle = 0.5 * (az + bz);
    precise float atOrigin = stored * view.wirePixel;
    precise float there = kPerspective ? atOrigin * ((view.origin - middle) / view.origin) : atOrigin;
    return stored < 0.0 ? there : stored;
}
#ifndef TILES
layout(constant_id = kSnapId) const float kSnap = 0.0625;
/// Maximum shift of a vertex by the rasteriser, Å at z = 0.
float snapReach() { return kSnap * view.pixel; }
/// Whether a light's view omits a primitive: it is beyond the viewer's clipping plane.
bool isCutOff(vec3 center) {
    vec4 plane = CUT_PLANE(view);
    return kCut && dot(plane.xyz, center) > plane.w;
}
#endif
#ifdef RIMS
float contourReach() { return max(view.contourWidth, 0.0); }  // negative: no outlines
#else
float contourReach() { return view.contourWidth; }
#endif
/// Radius of a ball that contains a sphere with its outline, seen from any pixel. @param z  of the centre
float outlinedRadius(float z, float radius) {
    if (!kContours) return radius;
    if (!kPerspective) return radius + contourReach();
    // Outlines have a constant width in the picture, so farther ones are wider in space.
    return radius + contourReach() * (view.origin - z + radius) / (view.origin - contourReach());
}
#ifndef TILES
/// Clip position of a point of the plane z = 0 at encoded depth d. w = 1: depth is constant over a polygon.
vec4 clipPosition(vec2 q, float d) {
    vec2 perPixel = 2.0 / vec2(view.extent & 0xffffu, view.extent >> 16);  // NDC
    vec2 axis = axisPixel() * ((kQuarterTurns & 1) == 1 ? perPixel.yx : perPixel) - 1.0;
    vec2 perAngstrom = perPixel / view.pixel;  // constant per draw, so drivers can hoist it
    vec2 from = turned(vec2(q.x, -q.y) * perAngstrom);
    return vec4(kWholeImage ? from + axis : from, clamp(d, 0.0, 1.0), 1.0);
}
#endif
#endif
