#version 440
// The opaque plate of a sphere: an octagon fully inside it, facing the view plane. Everything behind it is hidden by
// the sphere itself, so plates never change a pixel. Clipped plates are not drawn.
#extension GL_GOOGLE_include_directive : require
#include "common/view.glsl"

// Corner radius of the plate in sphere radii; it is sqrt(1 - rim^2) in front of the centre.
layout(constant_id = kRimId) const float kRim = 0.98516;
layout(constant_id = kPlateRoomId) const float kRoom = 0.0;  // pixels

layout(location = 0) in vec4 inSphere;
layout(location = 3) in vec3 inCorner;  // engine/passes/corners.h
invariant gl_Position;

void main() {
    precise vec3 center = toView(inSphere.xyz);
    const float kShrunk = 1.0 - 1e-3;
    float Z = view.origin - center.z - inSphere.w * (kShrunk * sqrt(1.0 - kRim * kRim));
    float magnify = kPerspective ? view.origin / Z : 1.0;
    // Shrinks the plate by the snap margin, by which the rasteriser may move a corner; or draws nothing.
    float reach = max(inSphere.w * (kShrunk * kRim) - (snapReach() * 1.5 + view.pixel * kRoom) / magnify, 0.0);
    if (kClip && (Z < view.clipNear || Z > view.clipFar)) reach = 0.0;
    gl_Position = clipPosition((center.xy + inCorner.xy * reach) * magnify, encodedDepth(Z));
}
