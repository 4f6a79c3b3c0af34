// Flat outlines on the plane z = 0 that cover a primitive's picture.
#include "layout.h"

layout(constant_id = kCornersId) const int kCorners = 8;  // 8: octagon, 4: square, 9: pyramid

/// Corner of a triangle strip over the polygon circumscribed about the unit circle, no buffers needed.
vec2 corner(int index) {
    if (kCorners == 4) return vec2((index & 1) == 0 ? -1.0 : 1.0, (index & 2) == 0 ? -1.0 : 1.0);
    const float t = 0.41421356;  // tan 22.5 degrees
    // Strip order: left pair, then pairs of rising x. Odd indices have the positive y.
    int pair = index >> 1;
    float x = pair == 0 ? -1.0 : pair == 1 ? -t : pair == 2 ? t : 1.0;
    float y = pair == 0 || pair == 3 ? t : 1.0;
    return vec2(x, (index & 1) == 0 ? -y : y);
}

/// Point of the pyramid: the apex over the origin, then eight corners, which indices join to facets.
vec2 pyramidCorner(int index, out bool apex) {
    apex = index == 0;
    if (apex) return vec2(0.0);
    float angle = (float(index - 1) + 0.5) * 0.78539816;
    return vec2(cos(angle), sin(angle)) * 1.0823922;  // 1 / cos 22.5 degrees
}
// The facets lean against the sphere where it is kLean radii from its axis: at radius rho of the sphere they stand
// (1 - rho kLean) / sqrt(1 - kLean^2) radii in front of the centre, never behind the surface.
const float kLean = 0.6;
float pyramidHeight(bool apex) { return apex ? 1.25 : 0.8 - 0.75 * (1.0 - kLean); }

struct Outline {
    vec2 center, axisU, axisV;  // an ellipse, Å on the plane z = 0, grown by the snap margin
};

/// Silhouette of a sphere. Perspective: the image of its tangent cone, an ellipse whose long axis points away from
/// the view axis. With D = distance of the centre along -z and K = D^2 + rho^2 - r^2: centre rho E D / (D^2 - r^2),
/// half-axes E r sqrt(K) / (D^2 - r^2) and E r / sqrt(D^2 - r^2).
Outline sphereOutline(vec3 center, float radius) {
    Outline o;
    float margin = view.snap;
    if (!kPerspective) {
        o.center = center.xy;
        o.axisU = vec2(radius + margin, 0.0);
        o.axisV = vec2(0.0, radius + margin);
        return o;
    }
    float E = view.origin;
    float D = E - center.z;
    float rho = length(center.xy);
    float under = D * D - radius * radius;
    vec2 u = rho > 1e-6 ? center.xy / rho : vec2(1.0, 0.0);
    float a = E * radius * sqrt(under + rho * rho) / under;
    float b = E * radius * inversesqrt(under);
    o.center = u * (rho * E * D / under);
    // The floats above carry a relative error of some 1e-6 of the whole picture.
    float slack = margin + 4e-6 * (rho + a) * E / D;
    o.axisU = u * (a + slack);
    o.axisV = vec2(-u.y, u.x) * (b + slack);
    return o;
}
