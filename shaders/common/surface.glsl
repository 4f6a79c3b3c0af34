// From a primitive's hit to what a pass writes: colour, or one of the layers. Outputs by SURFACE or IDENTITY.
#include "atlas.glsl"
#include "hit.glsl"
#include "patch.glsl"
#include "shading.glsl"
#include "srgb.glsl"

layout(set = 0, binding = 0) uniform sampler2D occlusionAtlas;

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
    if (view.occlusion == 0.0) return 1.0;
    return patchTexel(patchAddress, octahedralCoordinate(toObject(hit.normal)), vec2(sphereEdge()));
}
float cylinderOcclusion(Hit hit, vec3 objectAxis, uint patchAddress) {
    if (view.occlusion == 0.0) return 1.0;
    vec2 uv = vec2(angleAbout(objectAxis, toObject(hit.normal)), hit.along);
    return patchTexel(patchAddress, uv, vec2(cylinderTexels()));
}

/// Writes a hit. Occlusion is passed by the caller, who knows the patch.
void writeSurface(Hit hit, uint colorBits, uint atom, float occlusion) {
#if defined(SURFACE)
    surface = vec4(hit.normal, hit.Z);
#elif defined(IDENTITY)
    identity = uvec2(atom, floatBitsToUint(occlusion));
#else
    vec3 base = linearColor(colorBits);
    color = vec4(view.lighting != 0.0 ? shade(base, hit.normal, occlusion) : base * occlusion, 1.0);
#endif
}
