// Flat outlines on the plane z = 0 that cover a primitive's picture.
#include "layout.h"

layout(constant_id = kCornersId) const int kCorners = 8;  // 8: octagon, 4: square, 9: pyramid

// The comparison depth of a cap may be in front of the whole primitive, so its polygon must be in front as well.
const float kCapRoom = kClip ? kCapDepth : 0.0;

struct Outline {
    vec2 center, axisU, axisV;  // an ellipse, Å on the plane z = 0, grown by the snap margin
};

/// Silhouette of a sphere. Perspective: the image of its tangent cone, an ellipse whose long axis points away from
/// the view axis. With D = distance of the centre along -z and K = D^2 + rho^2 - r^2: centre rho E D / (D^2 - r^2),
/// half-axes E r sqrt(K) / (D^2 - r^2) and E r / sqrt(D^2 - r^2).
Outline sphereOutline(vec3 center, float radius) {
    Outline o;
    float margin = snapReach();
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
    // The values above have a relative error of about 1e-6 of the whole picture.
    float slack = margin + 4e-6 * (rho + a) * E / D;
    o.axisU = u * (a + slack);
    o.axisV = vec2(-u.y, u.x) * (b + slack);
    return o;
}
