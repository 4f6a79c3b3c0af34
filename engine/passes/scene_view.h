#pragma once
// The scene as one view sees it: input of every pass of a frame.

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "engine/device_options.h"
#include "engine/effects.h"
#include "engine/passes/fragment_counter.h"
#include "engine/passes/placed_copies.h"
#include "engine/passes/scene_buffers.h"
#include "shaders/common/layout.h"

namespace nacre::passes {

/// The occlusion atlas of a scene, and the arrangement of its patches in rows: first those of spheres, then those of
/// cylinders.
struct Atlas {
    const gpu::Image* image = nullptr;  ///< null: no occlusion
    std::uint32_t sphereEdge = 0;       ///< width of a sphere's patch, texels
    std::uint32_t around = 0, along = 0;
    std::uint32_t spherePatches = 1, cylinderPatches = 1;  ///< per row
    vk::BufferView cells = {};               ///< one word per four neighbouring texels; null: the device interpolates
    std::uint32_t least = 0;                 ///< minimum of all texels, in 255ths: for an atlas of earlier positions
    std::shared_ptr<const void> owner = {};  ///< keeps the image and the cells alive
    bool bounced = false;                    ///< texels hold the light of their surroundings as well
    bool interpolates = false;               ///< shaders interpolate texels, not the sampler
};

class TileFrame;
class VolumeTextures;

/// Widths, Å at z = 0; 0: none.
struct Rims {
    float line = 0, halo = 0;
    float widest() const { return std::max(line, halo); }
    bool any() const { return widest() > 0; }
};

struct SceneView {
    const SceneBuffers* buffers = nullptr;
    std::shared_ptr<const void> owner;  ///< keeps the buffers alive while a frame is in flight
    layout::ViewConstants constants{};  ///< those of a copy stay 0
    PlacedCopies copies;
    std::array<glm::vec4, 3> still{};              ///< rows of primitives that no copy moves
    std::shared_ptr<const VolumeTextures> volume;  ///< null: the scene has none
    float otherAxis = 0;                           ///< of two views: the other's axisPixel, along the picture's rows
    std::shared_ptr<const TileFrame> tiles;        ///< for the `tiles` path
    std::shared_ptr<const gpu::Buffer> copyRows;   ///< copies.rows on the device, for `deferred` shading
    bool coded = false;                            ///< write colour sRGB-coded, else linear
    bool powers = false;                           ///< the device computes powers in a few instructions
    bool perspective = false;
    bool frontsOnly = false;    ///< triangles are invisible from behind
    int octants = 1;            ///< value of kEllipsoids where octants are cut (shaders/common/view.glsl)
    std::uint32_t samples = 1;  ///< per pixel; fragments state which they cover
    int quarterTurns = 0;       ///< as in View
    float wireScale = 1;        ///< this picture's pixels per pixel of the requested picture; 0: no wires
    bool wholeImage = true;     ///< the viewport is the whole image; false: it is centred on the view axis
    bool lighting = true, occlusion = false;
    bool bounced = false, interpolates = false;  ///< as in Atlas
    vk::BufferView occlusionCells;               ///< Atlas::cells
    std::shared_ptr<const void> atlasOwner;      ///< Atlas::owner: keeps both alive while a frame is in flight
    Effects effects;
    Rims rims;                               ///< outlines by groups, and halos
    bool blendsColors = false;               ///< of the Representation
    bool ownMaterials = false;               ///< of the Representation
    int copyColors = 0;                      ///< number of colours that copies take in turn
    bool cut = false;                        ///< a light's view: its planes' numbers describe one clipping plane
    std::shared_ptr<SceneView> light;        ///< the view of the shadow map; null: there is none
    std::shared_ptr<SceneView> translucent;  ///< the view of its translucent triangles; null: it has none
    std::optional<graph::Image> shadow;      ///< the shadow map
    std::shared_ptr<const gpu::Buffer> effectConstants;  ///< layout::EffectConstants; of passes that shade
    std::shared_ptr<const gpu::Buffer> covers;  ///< rectangles over pixels that do not matter; null: all matter
    std::uint32_t coverCount = 0;
    PlateShape plates = PlateShape::automatic;
    ImpostorShape impostor = ImpostorShape::automatic;
    double radiusPixels = 0;                     ///< mean radius of the spheres in the picture
    double smallestPixels = 0;                   ///< half the width of the narrowest primitive or line in the picture
    std::shared_ptr<FragmentCounter> fragments;  ///< null: count none

    /// Whether impostors must not have tilted facets. Facets are planes of depth only in parallel projection. With
    /// several samples, a facet behind one sample may lie before the hit of another.
    bool flat() const { return perspective || samples > 1; }

    /// Releases everything except the memory of its lists.
    void clear() {
        PlacedCopies room = std::move(copies);
        room.clear();
        *this = {};
        copies = std::move(room);
    }
};

}  // namespace nacre::passes
