#version 450
// Impostor colour and the layers: the same hit, tested against the nearest depth, then written out.
//   CYLINDER      the primitive; otherwise a sphere
//   INPUT / SAMPLED / FRAGDEPTH   where the nearest depth is: an input attachment, a texture, the depth buffer
//   SURFACE / IDENTITY            layers instead of colour
#extension GL_GOOGLE_include_directive : require
#include "common/hit.glsl"
#include "common/encoding.glsl"
#include "common/patch.glsl"
#include "common/shading.glsl"

#ifdef CYLINDER
layout(location = 0) flat in vec4 endA;
layout(location = 1) flat in vec4 endB;
layout(location = 2) flat in uvec4 look;  // colour a, colour b, atom a, atom b
layout(location = 3) flat in vec4 axisPatch;
#else
layout(location = 0) flat in vec4 sphere;
layout(location = 1) flat in uvec3 look;  // colour, atom, patch
#endif

layout(set = 0, binding = 0) uniform sampler2D occlusionAtlas;
#ifdef FRAGDEPTH
layout(depth_greater) out float gl_FragDepth;
#else
layout(early_fragment_tests) in;
#ifdef INPUT
layout(input_attachment_index = 0, set = 0, binding = 1) uniform subpassInput nearest;
#else
layout(set = 0, binding = 1) uniform sampler2D nearest;
#endif
#endif

#if defined(SURFACE)
layout(location = 0) out vec4 surface;  // normal, Z
#elif defined(IDENTITY)
layout(location = 0) out uvec2 identity;  // atom, occlusion as bits
#else
layout(location = 0) out vec4 color;  // linear, opaque
#endif

vec3 linearColor(uint srgb) {
    vec3 c = unpackUnorm4x8(srgb).rgb;
    return mix(c / 12.92, pow((c + 0.055) / 1.055, vec3(2.4)), greaterThan(c, vec3(0.04045)));
}

float patchTexel(uint address, vec2 uv, vec2 texels) {
    vec2 corner = vec2(address & 0xffffu, address >> 16);
    return textureLod(occlusionAtlas, (corner + 0.5 + uv * (texels - 1.0)) * view.atlas.xy, 0.0).r;
}

float occlusionOf(Hit hit) {
    if (view.shading.y == 0.0) return 1.0;
    vec3 normal = toObject(hit.normal);
#ifdef CYLINDER
    vec2 uv = vec2(angleAbout(axisPatch.xyz, normal), hit.along);
    return patchTexel(floatBitsToUint(axisPatch.w), uv, vec2(view.atlas.w, view.shading.z));
#else
    return patchTexel(look.z, octahedralCoordinate(normal), view.atlas.zz);
#endif
}

void main() {
#ifdef CYLINDER
    Hit hit = cylinderHit(endA.xyz, endB.xyz, endA.w, gl_FragCoord.xy);
    bool first = hit.along < 0.5;
    uint colorBits = first ? look.x : look.y;
    uint atom = first ? look.z : look.w;
#else
    Hit hit = sphereHit(sphere, gl_FragCoord.xy);
    uint colorBits = look.x;
    uint atom = look.y;
#endif
    if (!hit.inside) discard;
    float d = encodedDepth(hit.Z);
#if defined(FRAGDEPTH)
    gl_FragDepth = d;
#elif defined(INPUT)
    if (!isFrontmost(d, subpassLoad(nearest))) discard;
#else
    if (!isFrontmost(d, texelFetch(nearest, ivec2(gl_FragCoord.xy), 0))) discard;
#endif

#if defined(SURFACE)
    surface = vec4(hit.normal, hit.Z);
#elif defined(IDENTITY)
    identity = uvec2(atom, floatBitsToUint(occlusionOf(hit)));
#else
    vec3 base = linearColor(colorBits);
    float occlusion = occlusionOf(hit);
    color = vec4(view.shading.x != 0.0 ? shade(base, hit.normal, occlusion) : base * occlusion, 1.0);
#endif
}
