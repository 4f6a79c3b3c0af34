// From a primitive's hit to what a pass writes: colour, or one of the layers. Outputs by SURFACE or IDENTITY.
#include "atlas.glsl"
#include "hit.glsl"
#include "patch.glsl"
#include "shading.glsl"
#include "srgb.glsl"

layout(set = 0, binding = 0) uniform sampler2D occlusionAtlas;
layout(set = 0, binding = 1, std140) uniform Effects { EffectConstants effects; };
layout(constant_id = kOcclusionId) const bool kOcclusion = true;
layout(constant_id = kCapId) const int kCap = 0;
layout(constant_id = kFogId) const bool kFog = false;

#if defined(SURFACE)
layout(location = 0) out vec4 surface;  // normal, Z
#elif defined(IDENTITY)
layout(location = 0) out uvec2 identity;  // atom, occlusion as bits
#else
layout(location = 0) out vec4 color;  // linear, opaque
#endif

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

/// How bright a cap is beside what it cuts.
float capShade() {
    if (kCap == 1) return 0.55;
    if (kCap == 0) return 1.0;
    // Strokes from lower left to upper right, as draughtsmen hatch a section. They stay with the picture.
    vec2 q = planePoint(gl_FragCoord.xy);
    float stroke = fract((q.x - q.y) * 0.70710678 / effects.hatch);
    return abs(stroke - 0.5) < 0.15 ? 0.45 : 1.0;
}

/// Writes a hit. Occlusion is passed by the caller, who knows the patch.
void writeSurface(Hit hit, uint colorBits, uint atom, float occlusion) {
#if defined(SURFACE)
    surface = vec4(hit.normal, hit.Z);
#elif defined(IDENTITY)
    identity = uvec2(atom, floatBitsToUint(occlusion));
#else
    vec3 lit = shade(linearColor(colorBits), hit.normal, kClip && !hit.cap ? opened(occlusion) : occlusion);
    if (kClip && hit.cap) lit *= capShade();
    if (kContours > 0 && hit.contour) lit = effects.contour.rgb;
    if (kFog) {
        float share = clamp((hit.Z - effects.fogStart) * effects.perFog, 0.0, 1.0);
        lit = mix(lit, effects.fog.rgb, share * effects.fog.a);
    }
    color = vec4(lit, 1.0);
#endif
}
