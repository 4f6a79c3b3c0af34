// Computes the colour of a primitive's hit.
//   ATLAS, EFFECTS, SHADOW   bindings, if not 0, 1 and 2
//   CELLS            binding of the occlusion's cells, if read
#ifndef NACRE_COLOR_GLSL
#define NACRE_COLOR_GLSL
#include "atlas.glsl"
#include "effects.glsl"
#include "hit.glsl"
#include "patch.glsl"
#include "shading.glsl"
#ifndef ATLAS
#define ATLAS 0
#endif
#ifndef SHADOW
#define SHADOW 2
#endif

layout(set = 0, binding = ATLAS) uniform sampler2D occlusionAtlas;
layout(set = 0, binding = SHADOW) uniform sampler2D shadowMap;
layout(constant_id = kOcclusionId) const bool kOcclusion = true;
Baked bakedIn(float open) { return Baked(open, vec3(0.0), 0.0); }
/// @param lower  texel of the lower half of an atlas with bounced light (engine/occlusion/bounced_light.h)
Baked bakedIn(vec4 texel, vec4 lower) {
    precise vec3 sky = (lower.rgb - 128.0 / 255.0) * (255.0 / 256.0);
    precise float lean = dot(copyRow1.xyz, sky);  // that row is the direction upwards
    return Baked(texel.r, texel.gba, lean);
}
layout(constant_id = kCapId) const int kCap = 0;
layout(constant_id = kShadowId) const bool kShadow = false;
// kCoded: the target takes sRGB-coded colour; otherwise linear light.
layout(constant_id = kCodedId) const bool kCoded = false;

#include "copy_color.glsl"

/// A cell lies between four texels of a patch.
struct Cell {
    vec2 first;  // of the texels
    vec2 share;  // weights of the right and lower texels
};
Cell findCell(vec2 uv, vec2 texels) {
    precise vec2 at = uv * (texels - 1.0);
    vec2 first = clamp(floor(at), vec2(0.0), texels - 2.0);
    return Cell(first, at - first);
}
/// @param texels  0..255: first, right, below, below right
float between(vec4 texels, vec2 share) {
    precise vec2 across = texels.xz + (texels.yw - texels.xz) * share.x;
    precise float texel = (across.x + (across.y - across.x) * share.y) * (1.0 / 255.0);
    return texel;
}

/// @param at  the first of the cell's texels
vec4 cellOfAtlas(ivec2 at, vec2 share) {
    vec4 first = texelFetch(occlusionAtlas, at, 0), right = texelFetch(occlusionAtlas, at + ivec2(1, 0), 0);
    vec4 below = texelFetch(occlusionAtlas, at + ivec2(0, 1), 0), last = texelFetch(occlusionAtlas, at + 1, 0);
    if (!kBounce) return vec4(between(floor(vec4(first.r, right.r, below.r, last.r) * 255.0 + 0.5), share));
    precise vec4 upper = first + (right - first) * share.x, lower = below + (last - below) * share.x;
    precise vec4 texel = upper + (lower - upper) * share.y;
    return texel;
}
/// @param place  position of the patch: patchPlace()
Baked patchTexel(vec2 place, vec2 uv, vec2 texels) {
    if (!kCells) {
        vec2 at = place + uv * ((texels - 1.0) * view.atlasTexel);
        vec4 texel = textureLod(occlusionAtlas, at, 0.0);
        return kBounce ? bakedIn(texel, textureLod(occlusionAtlas, at + vec2(0.0, 0.5), 0.0)) : bakedIn(texel.r);
    }
    Cell cell = findCell(uv, texels);
    ivec2 at = ivec2(place + cell.first);
    vec4 texel = cellOfAtlas(at, cell.share);
    if (!kBounce) return bakedIn(texel.r);
    return bakedIn(texel, cellOfAtlas(at + ivec2(0, textureSize(occlusionAtlas, 0).y / 2), cell.share));
}
/// On some drivers lanes without a triangle also fetch: their addresses must stay inside the atlas.
Baked vertexTexelOfAtlas(uint vertex, uint side) {
    ivec2 size = textureSize(occlusionAtlas, 0), at = vertexPlace(vertex, side, effects.bakedCylinders);
    vec4 texel = texelFetch(occlusionAtlas, clamp(at, ivec2(0), size - 1), 0);
    if (!kBounce) return bakedIn(texel.r);
    return bakedIn(texel, texelFetch(occlusionAtlas, clamp(at + ivec2(0, size.y / 2), ivec2(0), size - 1), 0));
}
#ifdef CELLS
/// Texels in words of four: software devices gather a word as fast as a texel. The last texel of each word repeats as
/// the first of the next, so that two words hold a cell. (One word per cell took three times the memory and was
/// slower.)
layout(set = 0, binding = CELLS) uniform usamplerBuffer cellTexels;
uint countWords(uint texels) { return (texels + 1u) / 3u; }
Baked cellTexel(uint firstWord, vec2 uv, vec2 texels) {
    Cell cell = findCell(uv, texels);
    float word = floor((cell.first.x + 0.5) * (1.0 / 3.0));
    uint inRow = countWords(uint(texels.x)), at = firstWord + uint(cell.first.y * float(inRow) + word);
    uint above = texelFetch(cellTexels, int(at)).x, below = texelFetch(cellTexels, int(at + inRow)).x;
    uint shift = uint((cell.first.x - 3.0 * word) * 8.0);
    above >>= shift;
    below >>= shift;
    return bakedIn(between(vec4(above & 0xffu, above >> 8 & 0xffu, below & 0xffu, below >> 8 & 0xffu), cell.share));
}
uint sphereWords() { return countWords(sphereEdge()) * sphereEdge(); }
uint cylinderWords() { return countWords(cylinderTexels().x) * cylinderTexels().y; }
Baked sphereTexel(uint index, vec2 uv) {
    vec2 texels = vec2(sphereEdge());
    if (kCells && !kBounce) return cellTexel(index * sphereWords(), uv, texels);
    return patchTexel(patchPlace(spherePatch(index)), uv, texels);
}
Baked cylinderTexel(uint index, vec2 uv) {
    uvec2 texels = cylinderTexels();
    if (kCells && !kBounce) return cellTexel(view.spheres * sphereWords() + index * cylinderWords(), uv, vec2(texels));
    return patchTexel(patchPlace(cylinderPatch(index)), uv, vec2(texels));
}
/// Vertices follow the patches, four texels per word.
Baked vertexTexel(uint vertex, uint side) {
    if (!kCells || kBounce) return vertexTexelOfAtlas(vertex, side);
    uint at = 2u * vertex + side, first = view.spheres * sphereWords() + effects.bakedCylinders * cylinderWords();
    uint four = texelFetch(cellTexels, clamp(int(first + at / 4u), 0, textureSize(cellTexels) - 1)).x;
    return bakedIn(float(four >> 8u * (at & 3u) & 0xffu) * (1.0 / 255.0));
}
#else
Baked vertexTexel(uint vertex, uint side) { return vertexTexelOfAtlas(vertex, side); }
Baked sphereTexel(uint index, vec2 uv) { return patchTexel(patchPlace(spherePatch(index)), uv, vec2(sphereEdge())); }
Baked cylinderTexel(uint index, vec2 uv) {
    return patchTexel(patchPlace(cylinderPatch(index)), uv, vec2(cylinderTexels()));
}
#endif

bool shadesOcclusion(Hit hit) { return kOcclusion && !hit.cap && !hit.contour; }
vec2 sphereCoordinate(Hit hit) { return octahedralCoordinate(toObject(hit.normal)); }
vec2 cylinderCoordinate(Hit hit, vec3 objectAxis) {
    return vec2(angleAbout(objectAxis, toObject(hit.normal)), hit.along);
}
/// @param place  position of the primitive's patch: patchPlace()
Baked sphereOcclusion(Hit hit, vec2 place) {
    return shadesOcclusion(hit) ? patchTexel(place, sphereCoordinate(hit), vec2(sphereEdge())) : kOpen;
}
Baked cylinderOcclusion(Hit hit, vec3 objectAxis, vec2 place) {
    if (!shadesOcclusion(hit)) return kOpen;
    return patchTexel(place, cylinderCoordinate(hit, objectAxis), vec2(cylinderTexels()));
}

/// @param vertices  vertex numbers of the triangle
Baked meshOcclusion(Hit hit, uvec3 vertices) {
    if (!shadesOcclusion(hit)) return kOpen;
    uint side = hit.back ? 1u : 0u;
    Baked a = vertexTexel(vertices.x, side), b = vertexTexel(vertices.y, side), c = vertexTexel(vertices.z, side);
    precise float open = a.open * hit.shares.x + b.open * hit.shares.y + c.open * hit.shares.z;
    if (!kBounce) return bakedIn(open);
    precise vec3 light = a.light * hit.shares.x + b.light * hit.shares.y + c.light * hit.shares.z;
    precise float lean = a.lean * hit.shares.x + b.lean * hit.shares.y + c.lean * hit.shares.z;
    return Baked(open, light, lean);
}

/// Occlusion is baked for the whole scene. Clipping lets in light that the bake ignores: brightens dark parts, and
/// keeps their order.
float opened(float occlusion) { return mix(sqrt(occlusion), 1.0, 0.35); }

/// Minimum for a molecule that moved since its bake, which lacks newly exposed surfaces.
float leastOcclusion() { return float(view.patchTexels >> 24) * (1.0 / 255.0); }

/// Fraction of the direct light that reaches a hit: taps on a disc, in sunflower order, sample the light's depth map.
/// Surfaces cut by the near plane are unshadowed. @param q  planePoint() of the pixel
float sunlight(Hit hit, vec2 q) {
    if (!kShadow || hit.cap) return 1.0;
    precise vec2 seen = q * (kPerspective ? hit.Z / view.origin : 1.0);
    precise vec3 p = vec3(seen, view.origin - hit.Z) + hit.normal * effects.shadowBias;
    precise float u = dot(effects.shadowU.xyz, p) + effects.shadowU.w;
    precise float v = dot(effects.shadowV.xyz, p) + effects.shadowV.w;
    precise float depth = dot(effects.shadowW.xyz, p) + effects.shadowW.w;
    // An inclined surface must not shadow itself: allows its depth change within the soft edge.
    precise float facing = clamp(dot(hit.normal, kLight), 0.01, 1.0);
    precise float slope = min(sqrt(1.0 - facing * facing) / facing, 2.5);
    precise float own = depth - slope * effects.shadowSlope;
    const int kTaps = 16;
    float taken = 0.0;
    for (int i = 0; i < kTaps; ++i) {
        float angle = float(i) * 2.39996323, reach = sqrt((float(i) + 0.5) / float(kTaps));
        precise vec2 at = vec2(u, v) + vec2(cos(angle), sin(angle)) * reach * effects.shadowSpread;
        if (own > textureLod(shadowMap, at, 0.0).r) taken += 1.0 / float(kTaps);
    }
    precise float sun = 1.0 - effects.shadow * taken;
    return sun;
}

/// Brightness of a cap relative to its atom. @param q  planePoint() of the pixel
float capShade(vec2 q) {
    if (kCap == 1) return 0.55;
    if (kCap == 0) return 1.0;
    // Hatching from lower left to upper right, as in technical drawings. The strokes are fixed to the picture.
    float stroke = fract((q.x - q.y) * 0.70710678 / effects.hatch);
    float inside = (0.15 - abs(stroke - 0.5)) * effects.hatch / view.pixel;  // distance from the stroke's edge, pixels
    return mix(1.0, 0.45, clamp(inside + 0.5, 0.0, 1.0));
}

/// The colour of bands and lines on ellipsoids, or between the lines on the faces of a cut. @param base  linear
vec3 markedColor(vec3 base, uint mark) {
    precise vec3 coded = srgbFromLinear(clamp(base, 0.0, 1.0));
    const float kDark = 3.0 * 60.0 / 255.0;
    precise vec3 band = coded.r + coded.g + coded.b < kDark ? (coded + 1.0) * 0.5 : coded * 0.3;
    precise vec3 face = (coded + 3.0) * 0.25;
    uint kind = mark - kEllipsoidMark;
    return kind == 0u ? base : linearFromSrgb((kind & kBandMark) != 0u ? band : face);
}

/// In linear light. @param base  linear colour @param q  planePoint() of the pixel
vec3 computeLight(Hit hit, vec3 base, Baked baked, vec2 q) {
    baked.open = max(baked.open, leastOcclusion());
    if (kClip && !hit.cap) baked.open = opened(baked.open);
    if (kBounce && kCopyColors != 0) baked.light *= sqrt(copyColor());  // the surroundings are of the same copy
    if (kClip && hit.cap && effects.capColor != 0u) base = linearColor(effects.capColor);
    int material = kMaterial;
    if (kOwnMaterials) {
        float own = materialIn(base);
        base.r -= own;
        if (own > 0.0) material = int(0.5 * own) - 1;
    }
    if (kEllipsoids != 0 && hit.corner >= kEllipsoidMark && !hit.cap) base = markedColor(base, hit.corner);
    vec3 lit = shade(material, base, hit.normal, baked, sunlight(hit, q));
    if (kClip && hit.cap) lit *= capShade(q);
    if (kContours && hit.contour) lit = effects.contour.rgb;
    return kFog ? mix(lit, effects.fog.rgb, fogAt(hit.Z)) : lit;
}
vec3 computeLight(Hit hit, uint colorBits, Baked baked, vec2 q) {
    return computeLight(hit, linearColor(colorBits), baked, q);
}
vec3 asTargetTakesIt(vec3 lit) { return kCoded ? srgbFromLinear(clamp(lit, 0.0, 1.0)) : lit; }
vec3 computeColor(Hit hit, uint colorBits, Baked baked, vec2 q) {
    return asTargetTakesIt(computeLight(hit, colorBits, baked, q));
}
#endif
