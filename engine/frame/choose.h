#pragma once
// Decides how a frame is drawn, before anything is declared. Pure: the same request, scene and device give the same
// choice. The renderer executes the choice; `nacre plan`, --stats and `nacre devices` print it. No other code compares
// paths or asks what kind of device it runs on.

#include <array>
#include <cstdint>
#include <iterator>
#include <span>
#include <string>
#include <vector>

#include "engine/graph/frame_caps.h"
#include "engine/passes/vertex_costs.h"
#include "engine/results.h"
#include "engine/settings.h"

namespace nacre {

// Input of choose():

/// What a frame draws.
enum class Part : std::uint8_t {
    whole,      ///< a whole picture, or the first of its frames
    coarse,     ///< a picture with one sample per pixel; finds where more are needed
    edges,      ///< samples of listed edge pixels, added to a picture with one sample per pixel
    block,      ///< a rectangle of a picture, with 2 x 2 or 4 x 4 pixels for each of its pixels
    distances,  ///< how far away each pixel is, for depth of field
    layers,     ///< colour, surface and identity
    color,      ///< the colour of layers alone, with translucent parts
    solid,      ///< the surface and identity of layers alone
    pick,       ///< identity alone
    motion,     ///< a window's frame in motion
    sample,     ///< one sample of each pixel of a window at rest
};

/// The destination of a frame.
enum class Ending : std::uint8_t {
    left,            ///< stays on the device
    readBack,        ///< read by the host
    picture,         ///< in the image of its picture
    pictureAndHost,  ///< in the image of its picture; the host reads it to find where more samples are needed
    throughLens,     ///< in the image of its picture, blurred by depth; the host reads the result
    window,          ///< drawn into the window's image
    copiedToWindow,  ///< copied to the window
    scaledToWindow,  ///< scaled to the window
    firstSample,     ///< starts a sum of samples; the window shows it
    nextSample,      ///< adds a sample to the sum; the window shows it
    sumToWindow,     ///< shows the sum; draws no scene
};

struct FrameRequest {
    const RenderSettings& settings;
    Part part = Part::whole;
    Ending ending = Ending::left;  ///< of a picture's last frame
    int quarterTurns = 0;          ///< of the view
    bool counted = false;          ///< fragments are counted
    bool eyes = false;             ///< of both eyes of the view, if the frame can draw both (View::other)
    bool headset = false;          ///< into the image of a headset, whose edges no eye looks at
};

/// Counts that are known before a frame.
struct SceneFacts : passes::PrimitiveCounts {
    // Of the scene:
    bool hasCylinders = false, hasWires = false, hasTranslucent = false;
    bool hasTranslucentAtoms = false;  ///< spheres or cylinders among the translucent primitives
    bool hasVolume = false;            ///< a density map that rays go through
    std::uint64_t meshTriangles = 0;   ///< of the finest level
    bool leveled = false;              ///< each view has its own levels of detail
    bool boxed = false;                ///< the scene's spheres have finite bounding boxes
    /// Whether anything is blended over opaque surfaces.
    bool blends() const { return hasTranslucent || hasVolume; }
    // Of the view:
    double smallestPixels = 1e9;       ///< half the width of the narrowest primitive or line in the picture
    passes::PrimitiveCounts light{};   ///< what the light's view submits to the shadow map
    passes::PrimitiveCounts layers{};  ///< of translucent layers
};

// Output of choose():

struct Samples {
    enum class Where : std::uint8_t {
        one,         ///< one sample per pixel
        edges,       ///< several where the frame finds edges, or is given them
        everywhere,  ///< several pixels of the frame form one of the picture
        resolved,    ///< several, which the render pass averages
    };
    Where where = Where::one;
    std::uint32_t count = 1;  ///< per pixel of the picture, where it has several
    friend bool operator==(const Samples&, const Samples&) = default;
};

/// Frames that add samples to a picture's first one.
enum class Refinement : std::uint8_t {
    none,
    edges,       ///< after a coarse frame, one frame draws samples where colours change
    blocks,      ///< after a coarse frame, one frame per block draws samples where colours change
    everywhere,  ///< one frame per block draws samples in every pixel; no coarse frame
};

/// Translucent layers per pixel that are blended in their order: the nearest ones in front of opaque surfaces. The rest
/// is blended without order.
constexpr std::uint32_t kTranslucentLayers = 2;

/// An effect with passes or images of its own. Fog, clipping and plain outlines are a few instructions of the shading.
struct Effect {
    enum class Kind : std::uint8_t {
        shadow,            ///< a map of what the light sees; size: its width, pixels
        outlines,          ///< by groups of atoms
        halos,             ///< drawn by the pass of those outlines
        translucency,      ///< layers of primitives; size: their number
        tileTranslucency,  ///< the same, found and shaded by compute
        volume,            ///< a density map, in front of opaque surfaces and between translucent layers
        lens,              ///< depth of field: frames of distances, and a blur of the picture
    };
    Kind kind{};
    std::uint32_t size = 0;
    friend bool operator==(const Effect&, const Effect&) = default;
};

constexpr const char* kEffectNames[] = {"shadow", "outlines", "halos", "translucency", "translucency by tiles",
                                        "volume", "lens"};  // by kind
constexpr std::size_t kEffectKinds = std::size(kEffectNames);
static_assert(kEffectKinds == static_cast<std::size_t>(Effect::Kind::lens) + 1);

/// The effects of a frame, one of each kind at most, in the order in which they run. Frames allocate nothing.
class EffectList {
public:
    void add(Effect effect) { effects_.at(count_++) = effect; }
    std::uint32_t size(Effect::Kind kind) const;  ///< 0: it has no such effect, or one without a size
    bool has(Effect::Kind kind) const;
    void replace(Effect::Kind kind, Effect::Kind by);
    const Effect* begin() const { return effects_.data(); }
    const Effect* end() const { return effects_.data() + count_; }
    friend bool operator==(const EffectList&, const EffectList&) = default;

private:
    std::array<Effect, kEffectKinds> effects_{};
    std::uint32_t count_ = 0;
};

/// How primitives reach the device.
enum class Geometry : std::uint8_t {
    instanced,    ///< vertex streams; attributes go through varyings
    fetched,      ///< fragments fetch attributes by the primitive's number
    hostLists,    ///< the host lists the primitives of each tile
    deviceLists,  ///< compute lists the primitives of each tile
};

/// Work of the host before the device draws.
enum class HostWork : std::uint8_t {
    none,
    hiddenSpheres,  ///< spheres behind others, which are left out
    frontSpheres,   ///< the nearest sphere of each pixel, from bounding boxes
};

/// How colour is stored and coded.
enum class ColorFormat : std::uint8_t {
    srgb,    ///< 8 bits, coded by the format
    coded,   ///< the same bytes, coded by shaders
    linear,  ///< 32 bits
};

/// How pixels are shaded on the tile path.
enum class Shading : std::uint8_t {
    fragments,  ///< by numbers of primitives in a buffer
    image,      ///< by numbers in an image, like `deferred`: where no subgroup draws a tile
    compute,    ///< compute shades
    picture,    ///< the resolve of samples into the picture shades: each sphere of a pixel once
};

/// How a tile frame with samples at edges knows its edge pixels.
enum class EdgePixels : std::uint8_t {
    found,   ///< compute finds them
    listed,  ///< the host lists them
    alone,   ///< the host lists them, and only they are shaded, from primitive numbers
};

/// Passes that each draw a share of the primitives.
struct Rounds {
    std::uint32_t count = 1;
    std::array<std::uint32_t, 3> bytes{};  ///< of vertex outputs per primitive of each kind, if count > 1
    bool apart = false;                    ///< the first begins a render pass, like all others
    friend bool operator==(const Rounds&, const Rounds&) = default;

    std::vector<graph::Share> shares() const;
};

/// How a frame's vertex outputs fit the device's limit per render pass (GeometryCaps::mostVertexBytes).
struct VertexOutputs {
    // `automatic`: those of the settings.
    PlateShape plates = PlateShape::automatic;
    ImpostorShape impostor = ImpostorShape::automatic;
    // Rounds of the passes that draw primitives, in order:
    Rounds light, layers;              ///< the shadow map; each translucent layer
    Rounds plating, nearest, shading;  ///< the prepass; nearest depth or numbers; colour, layers, or outlines and halos
    friend bool operator==(const VertexOutputs&, const VertexOutputs&) = default;
};

/// How the choice changes where a tile's list is longer than the device's loops.
struct Overflow {
    std::uint32_t longestList = 0;          ///< entries of the longest list allowed; 0: the frame has no lists
    std::uint32_t longestListOfLayers = 0;  ///< longer lists change only how translucent layers are drawn
    Visibility path{};
    Refinement refinement{};  ///< unless none: these frames are drawn instead of this one
    HostWork host{};
    bool prepass = false;
    VertexOutputs vertices{};
    friend bool operator==(const Overflow&, const Overflow&) = default;
};

/// How a frame is drawn. Equal choices declare the same passes.
struct FrameChoice {
    Part part{};
    Visibility path = Visibility::encoded;  ///< not automatic
    Samples samples;
    Refinement refinement{};
    EffectList effects;
    Ending ending{};
    std::uint32_t views = 1;  ///< per draw call
    bool fineSums = false;    ///< of further translucent layers: 32 bits per channel, not 16
    bool foveated = false;    ///< fewer fragments far from the eyes' axes, by a fragment density map
    DebugView debug = DebugView::none;
    ColorFormat color{};
    Geometry geometry{};
    HostWork host{};
    Shading shading{};
    EdgePixels edgePixels{};
    bool prepass = true;             ///< false: plates would reject nothing
    graph::EncodedFormat encoded{};  ///< for `encoded`
    VertexOutputs vertices{};
    Overflow overflow{};
    friend bool operator==(const FrameChoice&, const FrameChoice&) = default;

    /// Whether the frames of `refinement` are drawn instead of this one.
    bool givesWay() const { return refinement != Refinement::none && part != Part::coarse; }
    bool has(Effect::Kind kind) const { return effects.has(kind); }
    /// Whether shaders find copies by the numbers of primitives.
    bool readsCopyRows() const;
    /// Outlines by groups or halos: one pass draws both.
    bool rims() const { return has(Effect::Kind::outlines) || has(Effect::Kind::halos); }
    std::uint32_t layers() const;
    bool drawsEdges() const { return samples.where == Samples::Where::edges; }
    bool drawnByTiles() const { return geometry == Geometry::hostLists || geometry == Geometry::deviceLists; }
    bool shadedByCompute() const { return shading == Shading::compute; }
    bool shadedInPicture() const { return shading == Shading::picture; }
    bool shadedByImage() const { return shading == Shading::image; }
    /// Samples per pixel of the frame's attachments.
    std::uint32_t attachmentSamples() const { return samples.where == Samples::Where::resolved ? samples.count : 1; }

    /// The choice itself, or its replacement where lists are too long.
    /// @param longest  entries of the frame's longest list @param longestOfLayers  of the translucent layers' lists
    FrameChoice within(std::uint32_t longest, std::uint32_t longestOfLayers = 0) const;
};

/// @throws Error if the device cannot do what its options or the settings ask for
/// @param reasons  if not null, receives why each decision was taken
FrameChoice choose(const FrameRequest& request, const SceneFacts& scene, const graph::FrameCaps& device,
                   std::vector<Decision>* reasons = nullptr);
/// Render passes of a path's primitives. @param v  of a choice with this path
std::uint32_t countRenderPasses(const FrameChoice& choice, const VertexOutputs& v);

// In describe_choice.cpp:

/// The decisions of a choice, for people; without reasons.
std::vector<Decision> describe(const FrameChoice& choice);
/// The decisions of choose(), each with its reason.
std::vector<Decision> explain(const FrameRequest& request, const SceneFacts& scene, const graph::FrameCaps& device);
/// As above, of a frame that was drawn. @param drawn  differs from choose() where a tile's list was too long
std::vector<Decision> explain(const FrameRequest& request, const SceneFacts& scene, const graph::FrameCaps& device,
                              const FrameChoice& drawn);

// Steps of choose() that need no counts of a view:

/// The settings without effects that the frame omits: layers have no outlines, for example.
RenderSettings drawnSettings(const FrameRequest& request);
/// Samples of a frame before its view is known.
Samples chooseSamples(const FrameRequest& request, const SceneFacts& scene, const graph::FrameCaps& device);
/// Whether pictures with these settings take several samples per pixel at edges, and one elsewhere.
bool wantsEdges(const RenderSettings& settings);
/// Whether the frame draws translucent layers.
bool drawsLayers(const FrameRequest& request, const SceneFacts& scene);
/// Whether the frame draws a volume.
bool drawsVolume(const FrameRequest& request, const SceneFacts& scene);

// Choices that hold for all frames of a device:

/// Samples per pixel of multisampled frames: a fragment states which of them it covers.
constexpr std::uint32_t kMultisamples = 4;

/// The path of a device's plain frames. @throws Error if the device lacks the path that its options ask for
graph::TestedPath choosePath(const graph::FrameCaps& device);

struct MotionSamples {
    std::uint32_t count = 1;
    std::string why;
};
/// Samples per pixel of a window's frames in motion: several where they cost neither memory traffic nor a second
/// fragment. @throws Error if the options ask for more than the path can draw
MotionSamples chooseMotionSamples(const graph::FrameCaps& device);

/// How a bake's depth maps are drawn.
OcclusionMaps chooseOcclusionMaps(const graph::FrameCaps& device);

/// The path with the lowest demands on a driver: one subpass, and no reads from the tile.
graph::TestedPath plainestPath(const char* why);

/// Whether a device has a path at all. @param rasterOrder  it reads its own attachments in order
bool hasPath(Visibility path, bool rasterOrder);

/// Whether a path draws by compute, instead of by triangles.
bool drawsByCompute(Visibility path);

/// Whether plates in the hardware depth buffer reject fragments on a path. Where impostors write depth themselves, that
/// needs a depth test before the fragment shader.
bool platesReject(Visibility path, const graph::PlanCaps& caps);

/// Why a path cannot draw kMultisamples per pixel in one render pass without storing them. Empty: it can.
std::string lacksMultisampling(Visibility path, const graph::PlanCaps& caps);

/// Why a picture with these settings has one sample per pixel, on any device. Empty: it can have more.
std::string lacksSamples(const RenderSettings& settings, bool blends);

}  // namespace nacre
