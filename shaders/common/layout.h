// Layouts that C++ and GLSL share. Included by both: keep to the common subset.
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

// Specialization constants: a number means one thing, in every stage that has it.
// The view, and what of the scene is drawn.
const int kPerspectiveId = 0;   // bool
const int kQuarterTurnsId = 1;  // clockwise, from the upright picture to the image
const int kWholeImageId = 2;    // bool: the viewport is the whole image, else it has the view axis in its middle
const int kClipId = 3;          // bool: two planes cut the scene
const int kCutId = 4;           // bool: what a plane cuts off casts no shadow
const int kContoursId = 5;      // bool: a contour line, or a rim, goes about each primitive
const int kCopiesId = 6;        // bool: primitives stand at the places of copies
const int kSpheresId = 7;       // bool: the scene has spheres
const int kCylindersId = 8;     // bool: and cylinders
const int kTrianglesId = 9;     // bool: and triangles
const int kWireScaleId = 14;    // float: pixels across one of the picture, by which wires are wide
// Polygons, and depth.
const int kCornersId = 10;        // of the polygon that a primitive is drawn in
const int kRimId = 11;            // float: of a plate, in radii of its sphere
const int kDepthChannelsId = 12;  // of encoded depth
const int kDepthStepsId = 13;     // of a channel of encoded depth, less one; 0: the channel is the depth
// Shading.
const int kLightingId = 20;    // bool: off, base colour times occlusion
const int kAmbientId = 21;     // float: shares of light, 1 as in common/shading.glsl
const int kDirectId = 22;      // float
const int kHighlightId = 23;   // float
const int kGlossId = 24;       // float: exponent of the highlight
const int kPowersId = 25;      // bool: the device raises to powers in a few instructions
const int kOcclusionId = 26;   // bool: the atlas is read
const int kDeepeningId = 27;   // float: how much of the occlusion counts, 0..1
const int kCellsId = 28;       // bool: shaders interpolate occlusion themselves, as its cells are
const int kCapId = 29;         // what a cut shows: 0 plain, 1 dark, 2 hatched
const int kFogId = 30;         // bool
const int kShadowId = 31;      // bool: the light's depth map is asked
const int kCopyColorsId = 32;  // colours that the copies of an assembly take in turn; 0: they all look the same
// Pictures.
const int kCodedId = 40;    // bool: the target takes sRGB-coded colour as it is
const int kSamplesId = 41;  // n x n texels of a picture for a pixel; 0: bilinear
const int kTileId = 42;     // pixels across a tile of debug views
const int kClearId = 43;    // float, four of them: what a picture is cleared to, linear and premultiplied
// Drawing by tiles.
const int kLanesId = 50;       // of the subgroup that draws a tile
const int kTilesInBinId = 51;  // a side, of those that share a list
const int kSeededId = 52;      // bool: pixels of tiles begin with the triangle or sphere that the host found nearest
const int kNumberedId = 53;    // bool: numbers of a frame with edges: sights; what shades writes them, too
const int kEverywhereId = 54;  // bool: every pixel is drawn as an edge
const int kListedId = 55;      // bool: what an edge's samples see is looked for in lists, not among its neighbours
const int kRowsId = 56;        // bool: edges are coded words among the other pixels
const int kLayerId = 57;       // of translucent triangles: 0 the nearest
const int kSubsamplesId = 58;  // bool: pixels are samples of a picture's, and stand where those of an edge do
// The occlusion bake.
const int kBatchId = 60;       // depth maps of a batch
const int kMapsAcrossId = 61;  // of them in a row of the image
const int kTapsId = 62;        // pixels of a depth map that are asked for a texel: 1 or 4
const int kSpreadId = 63;      // float: of four taps, pixels

/// Z of a far plane that clips nothing; a near one's is -kNoPlane.
constexpr float kNoPlane = 1e30f;
/// Rows of the samples of an edge pixel, 0..15, four bits each: sample i stands in column i. A search for the order of
/// rows that errs least about the share of a pixel that lies on one side of a straight line.
const uint kSampleRowsLow = 0x04BF851Cu;
const uint kSampleRowsHigh = 0x92E63DA7u;
/// Of an atom's group, the bits of its residue; the others are its chain's. So many residues apart is another group.
const int kResidueBits = 12;
const int kGroupResidues = 6;
/// Caps stand in one plane: what is compared stands up to this much before it, Å, the more the deeper a point lies in
/// what is cut. So the atom that it lies deepest in shows there, on every path, and nothing that begins behind the
/// plane.
const float kCapDepth = 0.02f;
/// In place of an edge pixel's colour, or of a pixel in the list of them: it is none.
const uint kNoEdge = 0xffffffffu;
/// Words before that list: how often it fills a subgroup, and the rows of pixels that the bins have.
const uint kEdgeHeader = 4u;

/// Colours that copies take in turn, at most.
const int kMostCopyColors = 16;

/// Push constants of every geometry pass. Lengths in Å, view space as in engine/scene/camera.h.
/// Z is the distance that the layers report: origin - z (orthographic: origin = R, perspective: origin = eye).
struct ViewConstants {
    vec4 row0;  // the copy that is drawn, xyz: a row of its rotation into view space, w: of its shift
    vec4 row1;
    vec4 row2;
    uint extent;         // of the upright view: width, from bit 16 on height, pixels
    uint cylinders;      // of the primitives in a copy, after the spheres and before the triangles
    float origin;        // of Z
    uint numberBefore;   // that of the copy's first primitive: primitives are counted from 1 over all copies
    vec2 axisPixel;      // where the view axis meets the framebuffer, pixels
    float pixel;         // across, at z = 0
    float snap;          // how far the rasteriser may move a vertex, at z = 0
    float depthStart;    // Z at encoded depth 0
    float perRange;      // 1 / (range of Z)
    uint primitives;     // in a copy
    uint spheres;        // of the primitives in a copy
    vec2 atlasTexel;     // 1 / texels of the atlas
    uint patchTexels;    // from the lowest byte on: across a sphere's patch, around and along a cylinder's; what no
                         // occlusion falls below, in 255ths
    uint patchesInRow;   // of the atlas: of spheres, from bit 16 on of cylinders
    float clipNear;      // Z that is cut away, up to this
    float clipFar;       // and from this on
    float contourWidth;  // at z = 0
    float contourDepth;  // Å by which depth jumps behind a contour line
};

/// A light's view neither clips nor draws lines. Where the viewer's near plane clips (kCutId), it has that plane in
/// their place: its normal, and how far from the origin along it nothing throws a shadow any more.
#ifdef __cplusplus
inline void setCutPlane(ViewConstants& c, const vec4& plane) {
    c.clipNear = plane.x, c.clipFar = plane.y, c.contourWidth = plane.z, c.contourDepth = plane.w;
}
#else
#define CUT_PLANE(view) vec4(view.clipNear, view.clipFar, view.contourWidth, view.contourDepth)
#endif

/// Push constants of the passes that draw by tiles. What stands in ViewConstants, too, means the same.
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
    uint across;      // bins in a row
    uint offsets;     // where the offsets of the bins' lists begin
    float depthStep;  // of encoded depth, within which a list is in no order
    float clipNear;
    vec2 atlasTexel;
    uint patchTexels;
    uint patchesInRow;
    float clipFar;
    float contourWidth;
    float contourDepth;
    uint cylinders;
};

/// What the effects of shading work with: a uniform buffer.
struct EffectConstants {
    vec4 contour;                      // linear colour
    vec4 fog;                          // linear colour, and its share where it ends
    float fogStart;                    // Z
    float perFog;                      // 1 / (Å from its start to its end)
    float hatch;                       // Å on the plane z = 0 from a stroke to the next
    float shadow;                      // share of the light that it takes, 0..1
    vec4 shadowU, shadowV, shadowW;    // (x, y, z, 1) of view space -> place in the light's depth map 0..1, depth there
    float shadowSpread;                // of a shadow's soft edge, in widths of the map
    float shadowBias;                  // Å that a point is lifted from its surface
    float shadowSlope;                 // depth that a surface of slope 1 rises within the soft edge
    uint firstGroup;                   // where the groups of atoms begin in the looks
    vec4 halo;                         // linear colour, and its share where it is densest
    float haloWidth;                   // at z = 0
    float perHaloDepth;                // 1 / (Å behind a primitive at which its halo is densest)
    float lineWidth;                   // at z = 0, of lines by groups; 0: there are none
    float lineDepth;                   // Å by which depth jumps at the thinnest of them
    uint bakedCylinders;               // that the occlusion atlas has patches of: wires stand behind them
    uint unused0, unused1, unused2;
    vec4 copyColors[kMostCopyColors];  // linear
};

// Towards the light, view space: over the viewer's left shoulder. Not yet of unit length.
const float kLightX = -0.35f, kLightY = 0.55f, kLightZ = 0.76f;
// Share of the light that reaches what no direction reaches.
const float kLeastLight = 0.08f;

/// Push constants of the occlusion passes. A batch of depth maps lies side by side in one image, kMapsAcross in a row.
struct OcclusionConstants {
    int mapPixels;            // across one depth map
    int apart;                // pixels from one map of a row to the next
    int pitch;                // of maps in a buffer: pixels from a row to the next
    float pixelsPerAngstrom;  // of a map
    float pixel;              // Å
    float depthAt0;           // encoded depth of the height 0
    float depthPerPixel;      // of height
    uint sphereEdge;
    uint around;
    uint along;
    uint spheres;
    uint firstEntry;  // of the list of texels
    uint entries;
    uint firstDirection;    // of the copies' own ones, where they are texels
    uint firstVertex;       // in the shapes
    uint firstVertexTexel;  // two a vertex: of its outer side, and of its inner one
    float step;             // that the vertices are in
};
/// Push constants of depth maps by tiles. What stands in TileConstants, too, means the same.
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
    float depthStep;
    uint binsOfMap;  // in its row
    uint copies;     // on each map
    uint unused;
};
/// One direction of a batch: a position p of the streams lies at (dot(u, p), dot(v, p), dot(w, p)) with p.w = 1, in
/// pixels of its depth map from the top left; w points to the light.
struct Direction {
    vec4 u, v, w;
};
/// A batch for drivers that load uniforms for every invocation: three quarters of the words. A rotation's third row
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
static_assert(sizeof(OcclusionConstants) == 68 && sizeof(MapConstants) == 56);
static_assert(sizeof(Direction) == 48 && sizeof(NarrowDirections) == 36 * kMostDirections);
}  // namespace nacre::layout
#endif
#endif
