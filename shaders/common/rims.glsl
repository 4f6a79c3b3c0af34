// Rims: outlines and halos around a primitive. Their strength depends on the surface behind.
// Includers define lookAt() and shapeBits(): words of the looks and of the shapes.
#include "effects.glsl"
#include "divide.glsl"

// Touching chains separate where one sphere's silhouette is barely in front of the other sphere, or even behind it: an
// outline is drawn there as well.
const float kTouching = 0.5;  // Å

/// The surface in a pixel, or the one that a rim surrounds.
struct Owner {
    uint copy;
    uint group;  // chain and residue of its atom, as engine/scene/build/atom_groups.h packs them
};

/// @param index  of a primitive in its copy
uint lookGroup(uint index, bool secondHalf) {
    uint look = index < view.spheres ? index : view.spheres + 2u * (index - view.spheres) + uint(secondHalf);
#ifdef NO_TRIANGLES
    return lookAt(effects.firstGroup + look);
#else
    bool facet = index >= view.spheres + view.cylinders;
    uint vertex = shapeBits(facet ? index + view.cylinders : 0u).x;
    uint lookOfVertex = shapeBits(facet ? vertex : 0u).w / 2u;
    return lookAt(effects.firstGroup + (facet ? lookOfVertex : look));
#endif
}

/// Width of an outline as a fraction of the widest one's.
/// @param behind  whether there is a surface behind @param Z  of that surface @returns 0: none
float lineShare(Hit hit, Owner here, bool behind, Owner there, float Z) {
    if (!behind) return 1.0;
    if (Z < hit.Z - kTouching) return 0.0;
    if (there.copy != here.copy) return 1.0;
    if (here.group >> kResidueBits != there.group >> kResidueBits) return 1.0;
    int residues = 1 << kResidueBits, apart = abs(int(here.group & uint(residues - 1)) - int(there.group & uint(residues - 1)));
    if (min(apart, residues - apart) > kGroupResidues) return 0.67;
    return Z > hit.Z + effects.lineDepth ? 0.34 : 0.0;
}

/// Freedom of the outline from fog, whether there is an outline, density of the halo. Several rims in a pixel combine
/// by MAX.
/// @param hit  inside the rim
vec3 shadeRim(Hit hit, Owner here, bool behind, Owner there, float Z) {
    float away = hit.away * view.contourWidth;
    float clear = kFog ? 1.0 - fogAt(hit.Z) : 1.0;
    float line = effects.lineWidth > 0.0 && away <= effects.lineWidth * lineShare(hit, here, behind, there, Z) ? 1.0 : 0.0;
    float inward = clamp(1.0 - away / max(effects.haloWidth, 1e-6), 0.0, 1.0);
    float halo = inward * inward * (3.0 - 2.0 * inward) * clamp((Z - hit.Z) * effects.perHaloDepth, 0.0, 1.0);
    return vec3(clear * line, line, clear * halo);
}
