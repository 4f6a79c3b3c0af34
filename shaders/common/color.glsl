// From a primitive's hit to what shows there.
//   ATLAS, EFFECTS   bindings, unless they are 0 and 1
#ifndef NACRE_COLOR_GLSL
#define NACRE_COLOR_GLSL
#include "atlas.glsl"
#include "hit.glsl"
#include "patch.glsl"
#include "shading.glsl"
#include "srgb.glsl"
#ifndef ATLAS
#define ATLAS 0
#define EFFECTS 1
#endif

layout(set = 0, binding = ATLAS) uniform sampler2D occlusionAtlas;
layout(set = 0, binding = EFFECTS, std140) uniform Effects { EffectConstants effects; };
layout(constant_id = kOcclusionId) const bool kOcclusion = true;
layout(constant_id = kCapId) const int kCap = 0;
layout(constant_id = kFogId) const bool kFog = false;
// The target takes sRGB-coded colour as it is; otherwise linear light.
layout(constant_id = kCodedId) const bool kCoded = false;

vec3 linearColor(uint srgb) { return linearFromSrgb(unpackUnorm4x8(srgb).rgb); }

float patchTexel(uint address, vec2 uv, vec2 texels) {
    vec2 corner = vec2(address & 0xffffu, address >> 16);
    return textureLod(occlusionAtlas, (corner + 0.5 + uv * (texels - 1.0)) * view.atlasTexel, 0.0).r;
}
float sphereOcclusion(Hit hit, uint patchAddress) {
    if (!kOcclusion || hit.cap || hit.contour) return 1.0;
    return patchTexel(patchAddress, octahedralCoordinate(toObject(hit.normal)), vec2(sphereEdge()));
}
float cylinderOcclusion(Hit hit, vec3 objectAxis, uint patchAddress) {
    if (!kOcclusion || hit.cap || hit.contour) return 1.0;
    vec2 uv = vec2(angleAbout(objectAxis, toObject(hit.normal)), hit.along);
    return patchTexel(patchAddress, uv, vec2(cylinderTexels()));
}

/// Occlusion is baked for the whole scene. Where a plane cuts it, light falls in that the bake knows nothing of: what lay
/// in the dark is lifted, and stays darker than what lay less so.
float opened(float occlusion) { return mix(sqrt(occlusion), 1.0, 0.2); }

/// How bright a cap is beside what it cuts. @param q  planePoint() of the pixel
float capShade(vec2 q) {
    if (kCap == 1) return 0.55;
    if (kCap == 0) return 1.0;
    // Strokes from lower left to upper right, as draughtsmen hatch a section. They stay with the picture.
    float stroke = fract((q.x - q.y) * 0.70710678 / effects.hatch);
    return abs(stroke - 0.5) < 0.15 ? 0.45 : 1.0;
}

/// As the target takes it. @param q  planePoint() of the pixel
vec3 colorOf(Hit hit, uint colorBits, float occlusion, vec2 q) {
    vec3 lit = shade(linearColor(colorBits), hit.normal, kClip && !hit.cap ? opened(occlusion) : occlusion);
    if (kClip && hit.cap) lit *= capShade(q);
    if (kContours > 0 && hit.contour) lit = effects.contour.rgb;
    if (kFog) {
        float share = clamp((hit.Z - effects.fogStart) * effects.perFog, 0.0, 1.0);
        lit = mix(lit, effects.fog.rgb, share * effects.fog.a);
    }
    return kCoded ? srgbFromLinear(clamp(lit, 0.0, 1.0)) : lit;
}
#endif
