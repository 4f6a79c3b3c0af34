// Where a sphere lies in the picture, for stages that list primitives.

/// A disc on the plane z = 0 that contains the image of a sphere; in perspective, around the ellipse of
/// common/outline.glsl.
vec3 boundingDisc(vec3 center, float radius) {
    float room = 0.05 * view.pixel;
    if (!kPerspective) return vec3(center.xy, radius * 1.005 + room);
    float D = view.origin - center.z;
    float rho = length(center.xy);
    float under = D * D - radius * radius;
    float reach = view.origin * radius * sqrt(under + rho * rho) / under;
    return vec3(center.xy * (view.origin * D / under), reach * 1.005 + room);
}
