// Layouts shared by C++ and GLSL. Included by both: use the common subset only.
#ifndef NACRE_LAYOUT_H
#define NACRE_LAYOUT_H
#ifdef __cplusplus
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
namespace nacre::layout {
using glm::vec2;
using glm::vec4;
using uint = std::uint32_t;
#else
#define constexpr const
#endif

// Specialization constants: each number has one meaning in all stages. View, and parts of the scene.
const int kPerspectiveId = 0;   // bool
const int kQuarterTurnsId = 1;  // clockwise, from the upright picture to the image
const int kWholeImageId = 2;    // bool: the viewport is the whole image; false: it is centred on the view axis
const int kClipId = 3;          // bool: two planes clip the scene
const int kCutId = 4;           // bool: clipped parts cast no shadow
const int kContoursId = 5;      // bool: primitives have outlines or rims
const int kCopiesId = 6;        // bool: primitives have the transforms of copies
const int kSpheresId = 7;       // bool: the scene has spheres
const int kCylindersId = 8;     // bool: the scene has cylinders
const int kTrianglesId = 9;     // bool: the scene has triangles
const int kWiresId = 14;        // bool: there are wires among the cylinders
const int kEllipsoidsId = 18;   // int: whether some spheres are ellipsoids (shaders/common/view.glsl)
const int kFrontsOnlyId = 17;   // bool: triangles are invisible from behind, hidden by fronts of their meshes
// Polygons, and depth.
const int kCornersId = 10;        // of a primitive's polygon
const int kRimId = 11;            // float: of a plate, in radii of its sphere
const int kPlateRoomId = 15;      // float: margin between a plate and its sphere's rim, pixels
const int kSnapId = 16;           // float: largest shift of a vertex by the rasteriser, pixels
const int kDepthChannelsId = 12;  // of encoded depth
const int kDepthStepsId = 13;     // per channel of encoded depth, less one; 0: the channel is the depth
// Shading.
const int kLightingId = 20;     // bool: false: base colour times occlusion
const int kAmbientId = 21;      // float: weights of light, 1 as in common/shading.glsl
const int kDirectId = 22;       // float
const int kHighlightId = 23;    // float
const int kGlossId = 24;        // float: exponent of the highlight
const int kPowersId = 25;       // bool: the device computes powers in a few instructions
const int kOcclusionId = 26;    // bool: read the atlas
const int kDeepeningId = 27;    // float: strength of occlusion, 0..1
const int kCellsId = 28;        // bool: shaders interpolate occlusion themselves
const int kBounceId = 36;       // bool: texels of the atlas hold the light of their surroundings as well
const int kCapId = 29;          // style of clipped surfaces: 0 plain, 1 dark, 2 hatched
const int kFogId = 30;          // bool
const int kShadowId = 31;       // bool: sample the light's depth map
const int kBlendColorsId = 33;  // bool: triangles blend the colours of their corners
const int kMaterialId = 34;     // of colours without their own
const int kOwnMaterialId = 35;  // bool: some colours have their own material
const int kCopyColorsId = 32;   // colours that copies of an assembly take in turn; 0: they look the same
// Pictures.
const int kCodedId = 40;      // bool: the target takes sRGB-coded colour unchanged
const int kSamplesId = 41;    // n x n texels of a picture per pixel; 0: bilinear
const int kTileId = 42;       // tile width of debug views, pixels
const int kClearId = 43;      // float, four of them: clear colour of a picture, linear and premultiplied
const int kDebugViewId = 47;  // number of a DebugView (engine/debug_view.h), some of which are:
const int kDebugEncoded = 2, kDebugPlates = 3, kDebugOverdraw = 4, kDebugPatches = 6, kDebugId = 7, kDebugNormals = 8;
// Drawing by tiles.
const int kLanesId = 50;       // lanes of the subgroup that draws a tile
const int kTilesInBinId = 51;  // per side, of tiles that share a list
const int kSeededId = 52;      // bool: pixels start with the nearest triangle or sphere that the host found
const int kNumberedId = 53;    // bool: the frame has edges: numbers are sights, which shading also writes
const int kEverywhereId = 54;  // bool: draw every pixel as an edge, where a bin may show a small primitive
const int kListedId =
    55;  // bool: lists are searched; false: samples of an edge look at neighbours, and a tile has only seeds
const int kRowsId = 56;    // bool: edges are coded words among the other pixels
const int kLayerId = 57;   // of translucent primitives: 0 the nearest, kOrderedLayers the rest
const int kMaskedId = 72;  // bool: only pixels of a mask are replaced
const int kClearsId = 58;  // bool: compute also writes pixels that show nothing
const int kWritesId = 59;  // bool: entries of bins are written; false: counted
// Density maps between translucent layers.
const int kBehindLayerId = 70;  // bool: only parts behind a layer
const int kBeforeLayerId = 71;  // bool: only parts in front of a layer
const int kDistancesId = 73;    // bool: numbers of primitives come with their Z
// The occlusion bake.
const int kBatchId = 60;        // depth maps per batch
const int kMapsAcrossId = 61;   // maps per row of the image
const int kTapsId = 62;         // pixels sampled per texel of a depth map: 1, 2 or 4
const int kSpreadId = 63;       // float: distance of the taps, pixels
const int kOrderedBitsId = 64;  // bool: heights are words that have the order of their floats

/// Translucent layers in order; and the words of a pixel for their colours and that of the rest, as halves.
const int kOrderedLayers = 2, kLayerWords = 2 * (kOrderedLayers + 1);

/// Z of a far plane that clips nothing; for a near plane -kNoPlane.
constexpr float kNoPlane = 1e30f;
/// Steps of encoded depth: the resolution of the order in the lists of tiles.
const uint kListSteps = 2048u;
const uint kOtherRoundBit = 1u << 28;  // of a tile in a list: another round draws it
/// Rows of the samples of an edge pixel, 0..15, four bits each; sample i is in column i. Found by search: the order
/// with the least error of a straight edge's coverage.
const uint kSampleRowsLow = 0x04BF851Cu;
const uint kSampleRowsHigh = 0x92E63DA7u;
/// Bits of an atom's group for its residue; the rest is its chain. Residues this far apart are in different groups.
const int kResidueBits = 12;
const int kGroupResidues = 6;
/// Caps lie in one plane. For comparison their depth is moved forward by up to this much, Å, more the deeper a point is
/// inside its atom. So every path shows the atom that contains the point deepest, and nothing behind the plane.
const float kCapDepth = 0.02f;
// Å behind the near clipping plane within which a triangle is a cap of a mesh.
const float kCapRise = 0.004f;
/// Replaces the colour of a pixel that is not an edge, and fills up the list of edge pixels.
const uint kNoEdge = 0xffffffffu;
/// Words before that list: number of full subgroups, and rows of pixels of the bins.
const uint kEdgeHeader = 4u;

/// Materials: engine/effects.h says what they are.
const int kMatte = 0, kPlastic = 1, kMetal = 2, kGlow = 3;
const uint kMaterials = 4u;
/// Maximum of colours that copies cycle through.
const int kMostCopyColors = 16;

/// Push constants of every geometry pass. Lengths in Å, view space as in engine/scene/view/camera.h. Z is the distance
/// in layers: origin - z (orthographic: origin = R, perspective: origin = eye).
struct ViewConstants {
    vec4 row0;  // of the current copy, xyz: a row of its rotation into view space, w: of its shift
    vec4 row1;
    vec4 row2;
    uint extent;         // of the upright view: width, from bit 16 on height, pixels
    uint cylinders;      // number per copy; they follow the spheres and precede the triangles
    float origin;        // of Z
    uint numberBefore;   // before the copy's first primitive: primitives are counted from 1 over all copies
    vec2 axisPixel;      // view axis in the framebuffer, pixels
    float pixel;         // width, at z = 0
    float wirePixel;     // of the requested picture, at z = 0: the unit of a wire's width
    float depthStart;    // Z at encoded depth 0
    float perRange;      // 1 / (range of Z)
    uint primitives;     // per copy
    uint spheres;        // per copy
    vec2 atlasTexel;     // 1 / texels of the atlas
    uint patchTexels;    // bytes, lowest first: width of a sphere's patch, around and along a cylinder's; minimum of
                         // occlusion, in 255ths
    uint patchesInRow;   // of the atlas: of spheres, from bit 16 on of cylinders
    float clipNear;      // Z below this is clipped
    float clipFar;       // Z from this on is clipped
    float contourWidth;  // of outlines, at z = 0; of two views, which have none: the other's row0.w
    float contourDepth;  // minimum depth jump of an outline, Å; of two views: the other's axisPixel, along the rows
};

/// A light's view neither clips nor draws outlines. If the viewer's near plane clips (kCutId), these members hold that
/// plane: its normal, and the distance along it beyond which nothing casts a shadow. Else the viewer: the eye and 1, or
/// the direction to a distant one and 0.
#ifdef __cplusplus
inline void setCutPlane(ViewConstants& c, const vec4& plane) {
    c.clipNear = plane.x, c.clipFar = plane.y, c.contourWidth = plane.z, c.contourDepth = plane.w;
}
#else
#define CUT_PLANE(view) vec4(view.clipNear, view.clipFar, view.contourWidth, view.contourDepth)
#endif

/// Push constants of the tile passes. Members of ViewConstants have the same meaning.
struct TileConstants {
    vec4 row0;
    vec4 row1;
    vec4 row2;
    float origin;
    uint primitives;
    vec2 axisPixel;
    float pixel;
    float depthStart;
    float perRange;
    uint spheres;
    uint across;   // bins per row
    uint offsets;  // begin of the bins' offsets
    float wirePixel;
    float clipNear;
    vec2 atlasTexel;
    uint patchTexels;
    uint patchesInRow;
    float clipFar;
    float contourWidth;
    float contourDepth;
    uint cylinders;
};

/// Parameters of the shading effects: a uniform buffer.
struct EffectConstants {
    vec4 contour;                      // linear colour
    vec4 fog;                          // linear colour, and its share at the fog's end
    float fogStart;                    // Z
    float perFog;                      // 1 / (distance from start to end, Å)
    float hatch;                       // distance of hatching strokes on the plane z = 0, Å
    float shadow;                      // fraction of light removed, 0..1
    vec4 shadowU, shadowV, shadowW;    // (x, y, z, 1) of view space -> position (0..1) and depth in the light's map
    float shadowSpread;                // of a shadow's soft edge, in map widths
    float shadowBias;                  // offset of a point from its surface, Å
    float shadowSlope;                 // depth change of a surface of slope 1 within the soft edge
    uint firstGroup;                   // begin of the atoms' groups in the looks
    vec4 halo;                         // linear colour, and its maximum density
    float haloWidth;                   // at z = 0
    float perHaloDepth;                // 1 / (distance behind a primitive at which its halo is densest, Å)
    float lineWidth;                   // of outlines by group, at z = 0; 0: none
    float lineDepth;                   // depth jump of the thinnest outline, Å
    uint bakedCylinders;               // cylinders with patches in the atlas; wires follow them
    uint subsamples;                   // 1: pixels are samples of a picture's pixels, at the positions of edge samples
    uint capColor;                     // of caps, packed as in looks; 0: those of the atoms
    float layersPerLength;             // translucent ones on a way through the scene, on average, 1/Å
    vec4 copyColors[kMostCopyColors];  // linear
};

/// A brick of a density map that is drawn as a volume: a uniform buffer. Nodes count from its first texel.
const int kMostLevels = 8;
struct BrickConstants {
    vec4 nodeX, nodeY, nodeZ;  // (position, 1) of the scene, Å -> node
    vec4 first;                // node of the box's corner; w: number of levels
    vec4 last;                 // node of the opposite corner; w: 1 if a second channel marks known nodes
    vec4 perSize;              // 1 / nodes; w: longest step of a ray, Å
    vec4 levels[kMostLevels];  // ascending: value, 1 / (difference to the next)
    vec4 colors[kMostLevels];  // linear; a: share of light that 1 Å hides
};

// Direction to the light, view space: over the viewer's left shoulder. Not normalised.
const float kLightX = -0.35f, kLightY = 0.55f, kLightZ = 0.76f;
// Fraction of light that reaches fully occluded points.
const float kLeastLight = 0.08f;

/// Push constants of the occlusion passes. A batch of depth maps is side by side in one image, kMapsAcross per row.
struct OcclusionConstants {
    int mapPixels;            // width of one depth map
    int apart;                // pixels from one map of a row to the next
    int pitch;                // for maps in a buffer: pixels per row
    float pixelsPerAngstrom;  // of a map
    float pixel;              // Å
    float depthAt0;           // encoded depth of height 0
    float depthPerPixel;      // of height
    uint sphereEdge;
    uint around;
    uint along;
    uint spheres;
    uint firstEntry;  // of the list of texels
    uint entries;
    uint firstDirection;    // of the copies' own directions
    uint firstVertex;       // in the shapes
    uint firstVertexTexel;  // two per vertex: outer and inner side
    float step;             // of the vertex positions
};
/// Push constants of depth maps by tiles. Members of TileConstants have the same meaning.
struct MapConstants {
    float origin;
    uint primitives;
    vec2 axisPixel;  // of the first map
    float pixel;
    float perRange;
    uint spheres;
    uint cylinders;
    uint across;
    uint offsets;
    uint binsOfMap;  // in its row
    uint copies;     // per map
    uint unused0, unused1;
};
/// One direction of a batch: position p of the streams maps to (dot(u, p), dot(v, p), dot(w, p)) with p.w = 1, in
/// pixels of its depth map from the top left; w points to the light.
struct Direction {
    vec4 u, v, w;
};
/// A batch for drivers that load uniforms in every invocation: three quarters of the words. A rotation's third row
/// follows from the others.
const int kMostDirections = 16;
struct NarrowDirections {
    vec4 rows[2 * kMostDirections];     // u and v
    vec4 heights[kMostDirections / 4];  // w.w of four directions
};

#ifdef __cplusplus
static_assert(sizeof(ViewConstants) == 128, "push constants: 128 bytes at most");
static_assert(offsetof(ViewConstants, extent) == 48 && offsetof(ViewConstants, axisPixel) == 64 &&
              offsetof(ViewConstants, depthStart) == 80 && offsetof(ViewConstants, atlasTexel) == 96 &&
              offsetof(ViewConstants, clipNear) == 112);
static_assert(sizeof(TileConstants) == 128 && offsetof(TileConstants, axisPixel) == 56 &&
              offsetof(TileConstants, atlasTexel) == 96);
static_assert(sizeof(EffectConstants) == 160 + 16 * kMostCopyColors && offsetof(EffectConstants, fogStart) == 32 &&
              offsetof(EffectConstants, shadowSpread) == 96 && offsetof(EffectConstants, halo) == 112);
static_assert(sizeof(BrickConstants) == 96 + 32 * kMostLevels);
static_assert(sizeof(OcclusionConstants) == 68 && sizeof(MapConstants) == 56);
static_assert(sizeof(Direction) == 48 && sizeof(NarrowDirections) == 36 * kMostDirections);
}  // namespace nacre::layout
#endif
#endif
