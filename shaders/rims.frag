#version 450
// Lines and halos: what shows about a primitive depends on what stands behind it there, which by now is known. Whatever
// draws a rim at a pixel, the densest of all is kept, by a MAX blend.
//   CYLINDER, TRIANGLE   as in common/primitive.glsl
//   INPUT / SAMPLED      where numbers and distances are
#extension GL_GOOGLE_include_directive : require
#include "common/primitive.glsl"
#include "common/effects.glsl"
#include "common/count.glsl"

layout(early_fragment_tests) in;
layout(location = 4) flat in uint primitive;  // as in identify.frag
layout(location = 0) out vec4 rim;            // how clear of fog its line is, whether there is one, density of its halo
#ifdef INPUT
layout(input_attachment_index = 0, set = 0, binding = 3) uniform usubpassInput nearest;
uvec2 nearestHere() { return subpassLoad(nearest).xy; }
#else
layout(set = 0, binding = 3) uniform usampler2D nearest;
uvec2 nearestHere() { return texelFetch(nearest, ivec2(gl_FragCoord.xy), 0).xy; }
#endif
layout(set = 0, binding = 4, std430) readonly buffer Shapes { uvec4 shapes[]; };
layout(set = 0, binding = 5, std430) readonly buffer Looks { uint looks[]; };

// Chains that touch part where one sphere's silhouette hardly stands before the other sphere, or even behind: the line
// between them is drawn there, too.
const float kTouching = 0.5;  // Å

/// Of the atom of a primitive: chain and residue, as engine/scene/atom_groups.h packs them.
uint groupOf(uint index, bool secondHalf) {
    if (index < view.spheres) return looks[effects.firstGroup + index];
    index -= view.spheres;
    if (index < view.cylinders)
        return looks[effects.firstGroup + view.spheres + 2u * index + uint(secondHalf)];
    uvec4 record = shapes[view.spheres + view.cylinders + index];
    return looks[effects.firstGroup + shapes[record.x].w / 2u];
}

/// The share of the widest line's width that a line has to what stands behind. @param Z  of that @returns 0: none
float lineShare(Hit hit, uint behind, float Z) {
    if (behind == 0u) return 1.0;
    if (Z < hit.Z - kTouching) return 0.0;
    uvec2 there = uvec2((behind - 1u) / view.primitives, (behind - 1u) % view.primitives);
    uvec2 here = uvec2((primitive - 1u) / view.primitives, (primitive - 1u) % view.primitives);
    if (there.x != here.x) return 1.0;
    uint a = groupOf(here.y, hit.along >= 0.5), b = groupOf(there.y, false);
    if (a >> kResidueBits != b >> kResidueBits) return 1.0;
    int residues = 1 << kResidueBits, apart = abs(int(a & uint(residues - 1)) - int(b & uint(residues - 1)));
    if (min(apart, residues - apart) > kGroupResidues) return 0.67;
    return Z > hit.Z + effects.lineDepth ? 0.34 : 0.0;
}

void main() {
    countFragment();
    Hit hit = primitiveHit();
    if (!hit.contour) discard;
    uvec2 behind = nearestHere();
    float Z = behind.x == 0u ? 1e30 : uintBitsToFloat(behind.y);
    float away = hit.away * view.contourWidth;
    float clear = kFog ? 1.0 - fogAt(hit.Z) : 1.0;
    float line = effects.lineWidth > 0.0 && away <= effects.lineWidth * lineShare(hit, behind.x, Z) ? 1.0 : 0.0;
    float inward = clamp(1.0 - away / max(effects.haloWidth, 1e-6), 0.0, 1.0);
    float halo = inward * inward * (3.0 - 2.0 * inward) * clamp((Z - hit.Z) * effects.perHaloDepth, 0.0, 1.0);
    rim = vec4(clear * line, line, clear * halo, 0.0);
}
