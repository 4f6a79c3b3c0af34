#include "engine/frame/choose.h"

#include <algorithm>

#include "engine/error.h"
#include "engine/frame/effects/lens/choice.h"
#include "engine/frame/effects/shadow/choice.h"
#include "engine/frame/frame.h"

namespace nacre {

using graph::DeviceKind;
using graph::FrameCaps;
using passes::chooseShapes;
using passes::computeCost;
using passes::countBytes;
using passes::Handed;
using passes::PassCost;
using passes::PrimitiveCounts;
using passes::SphereShapes;
using Kind = Effect::Kind;
using Where = Samples::Where;

namespace {

constexpr const char* kAskedFor = "asked for";

bool isPicture(Part part) {
    return part != Part::distances && part != Part::layers && part != Part::solid && part != Part::pick;
}
bool hasColor(Part part) { return isPicture(part) || part == Part::layers; }

struct PathRow {
    Visibility path;
    const char* why;
};

/// The path that the device's kind suggests.
PathRow pathOfKind(DeviceKind kind, const graph::PlanCaps& caps) {
    switch (kind) {
        case DeviceKind::tiler:
            if (!caps.tileSubpasses)
                return {Visibility::fragdepth,
                        "subpasses do not stay on the tile here: one subpass, and no encoded depth in memory"};
            if (caps.rasterOrder == graph::RasterOrder::promised && caps.blendsByShader)
                return {Visibility::rasterOrder,
                        "tile-based GPU whose MIN is a shader: one pass over the impostors, in raster order"};
            return {Visibility::encoded, "tile-based GPU: depth stays fixed-function, encoded depth on the tile"};
        case DeviceKind::layered:
            return {Visibility::fragdepth, "Vulkan over Metal leaves the tile between subpasses"};
        case DeviceKind::software:
            return {Visibility::tiles,
                    "software rasteriser: compute over lists of primitives costs less than triangles"};
        case DeviceKind::immediate:
            break;
    }
    return {Visibility::fragdepth, "immediate-mode GPU: no tile memory to keep encoded depth in"};
}

/// Like choosePath(), without the reason, which would allocate.
Visibility pickPath(const FrameCaps& device) {
    if (device.visibility != Visibility::automatic) return device.visibility;
    if (device.tested.visibility != Visibility::automatic) return device.tested.visibility;
    return pathOfKind(device.kind, device.plan).path;
}

/// The path of a debug view on a device whose path is `usual`.
Visibility pickPath(DebugView view, Visibility usual) {
    switch (view) {
        case DebugView::encoded:
            return Visibility::encoded;
        case DebugView::overdraw:
        case DebugView::tiles:
        case DebugView::patches:
            return Visibility::fragdepth;  // the prepass alone
        default:
            // A float picture in addition to the nearest depth would not fit the tile.
            return usual == Visibility::rasterOrder ? Visibility::fragdepth : usual;
    }
}

enum class Lack { nothing, encoded, deferred, tiles, places, room };

std::uint32_t bytesOfSamples(Visibility path) {
    constexpr std::uint32_t kColor = 4, kNearest = 4;  // bytes of a sample
    return kMultisamples * (path == Visibility::rasterOrder ? kColor + kNearest : kColor);
}

Lack lackOfMultisampling(Visibility path, const graph::PlanCaps& caps) {
    if (path == Visibility::encoded) return Lack::encoded;
    if (path == Visibility::deferred) return Lack::deferred;
    if (path == Visibility::tiles) return Lack::tiles;
    if (!caps.placesSamples) return Lack::places;
    return bytesOfSamples(path) > caps.tileBytesPerPixel ? Lack::room : Lack::nothing;
}

/// Why frames in motion have one sample per pixel by default, apart from limits of the path; null: they have more.
const char* whySingleInMotion(DeviceKind kind, Visibility path, const graph::PlanCaps& caps) {
    if (kind == DeviceKind::software) return "software rasteriser: each sample costs as much as a pixel";
    if (kind == DeviceKind::immediate) return "immediate-mode GPU: samples go through memory";
    if (!caps.transient || caps.storeAll) return "samples would take memory: none is lazily allocated here";
    if (path == Visibility::rasterOrder)
        return "no driver has shown that it reads each sample of an attachment in order; --msaa 4 asks for it";
    return nullptr;
}

/// Like chooseMotionSamples(), without the reason, which would allocate.
std::uint32_t motionSamples(const FrameCaps& device) {
    if (device.multisampling == Multisampling::four) return kMultisamples;
    const Visibility path = pickPath(device);
    const bool several = device.multisampling == Multisampling::automatic &&
                         lackOfMultisampling(path, device.plan) == Lack::nothing &&
                         !whySingleInMotion(device.kind, path, device.plan);
    return several ? kMultisamples : 1;
}

/// Why a frame has one sample per pixel; null: it can have more.
const char* lackOfSamples(const RenderSettings& settings, bool blends) {
    if (settings.debug != DebugView::none) return "debug views show single samples";
    if (settings.fine) return "16 bits per channel and sample do not fit the tile";
    if (settings.effects.rims() || settings.effects.contours.width > 0)
        return "outlines and halos have one sample per pixel";
    if (blends) return "translucent layers and volumes have one sample per pixel";
    return nullptr;
}

/// Whether a small view shows a mesh of so many triangles that samples would search long lists. The host finds the
/// triangle of each sample there.
bool isFineMesh(const View& view, const SceneFacts& scene) {
    constexpr std::uint32_t kLargest = 384;  // a side: one block of samples
    constexpr std::uint64_t kPixels = 8;     // per triangle
    return std::max(view.width, view.height) <= kLargest &&
           scene.meshTriangles * kPixels > std::uint64_t{view.width} * view.height;
}

/// A pass over the primitives: its rounds in VertexOutputs, and its vertex outputs.
struct GeometryWork {
    Rounds VertexOutputs::*rounds = nullptr;
    PassCost cost;
};

/// The passes of a path, in order. Does not allocate.
class GeometryWorks {
public:
    void add(const GeometryWork& work) { works_.at(count_++) = work; }
    const GeometryWork* begin() const { return works_.data(); }
    const GeometryWork* end() const { return works_.data() + count_; }

private:
    std::array<GeometryWork, 5> works_{};  // prepass, nearest, three targets
    std::size_t count_ = 0;
};

/// Render passes beyond the first.
std::uint32_t begun(const Rounds& rounds) { return rounds.count - (rounds.apart ? 0 : 1); }

/// Makes one choice, step by step. Steps note their reasons on request.
class Chooser {
public:
    Chooser(const FrameRequest& request, const SceneFacts& scene, const FrameCaps& device,
            std::vector<Decision>* reasons = nullptr)
        : request_(request), settings_(drawnSettings(request)), scene_(scene), device_(device), reasons_(reasons) {}

    FrameChoice choose() {
        choice_.part = request_.part;
        choice_.debug = settings_.debug;
        choice_.encoded = device_.encoded;
        chooseSamples();
        chooseEffects();
        chooseColor();
        choosePath();
        chooseGeometry();
        chooseEnding();
        chooseOverflow();
        chooseViews();
        chooseFoveation();
        chooseVertices();
        return choice_;
    }
    Samples samples() {
        chooseSamples();
        return choice_.samples;
    }

private:
    template <typename Why>
    void because(const char* what, const Why& why) {
        if (reasons_) reasons_->push_back({what, {}, why});
    }

    void replaceReason(const char* what, const char* why) {
        if (!reasons_) return;
        std::erase_if(*reasons_, [&](const Decision& d) { return d.what == what; });
        because(what, why);
    }

    bool debugs() const { return settings_.debug != DebugView::none; }
    bool rims() const { return settings_.effects.rims(); }

    /// Whether compute may shade pictures: on software devices always, on others if they draw by tiles.
    bool mayCompute() const {
        return device_.tiles.shade && (!device_.tiles.lists || pickPath(device_) == Visibility::tiles);
    }
    /// The device's path, or the path of frames that add samples or depth to a picture. Devices that shade by tiles
    /// always draw those by tiles: other paths draw each sample as a pixel.
    Visibility usual(bool adds) const { return adds && mayCompute() ? Visibility::tiles : pickPath(device_); }
    bool adds() const {
        switch (choice_.part) {
            case Part::edges:
            case Part::block:
            case Part::distances:
                return true;
            case Part::coarse:
                return rims();  // else only `deferred` draws them
            default:
                return false;
        }
    }
    /// Whether a frame by tiles can have samples at edges.
    bool canDrawEdges(bool adds) const {
        return usual(adds) == Visibility::tiles && device_.tiles.drawsEdges && !scene_.blends() && !rims() &&
               !isFineMesh(request_.settings.view, scene_);
    }

    void chooseSamples();
    bool hasFrontSpheres() const;
    bool hasSmallSpheres() const;
    bool isCrowd() const;
    const char* blind() const;
    void refine();
    void chooseEffects();
    void chooseColor();
    std::uint32_t renderPassesBeyond() const;
    void choosePath();
    void chooseGeometry();
    HostWork hostWorkOfTiles() const;
    HostWork chooseHostWork(Visibility path) const;
    bool needsPrepass(Visibility path, PlateShape plates) const;
    void chooseEnding();
    void chooseOverflow();
    const char* lackOfViews() const;
    void chooseViews();
    const char* lackOfFoveation() const;
    void chooseFoveation();
    std::uint64_t mostVertexBytes() const;
    Rounds planRounds(const PassCost& cost, const PrimitiveCounts& counts) const;
    GeometryWorks planGeometry(Visibility path, const SphereShapes& shapes) const;
    VertexOutputs fitted(Visibility path) const;
    void chooseVertices();

    const FrameRequest& request_;
    const RenderSettings settings_;
    const SceneFacts& scene_;
    const FrameCaps& device_;
    std::vector<Decision>* reasons_;
    FrameChoice choice_;
};

void Chooser::chooseSamples() {
    Samples& samples = choice_.samples;
    const std::uint32_t n = settings_.supersample;
    const char* lack = lackOfSamples(settings_, scene_.blends());
    switch (request_.part) {
        case Part::edges:
            samples = {Where::edges, RenderSettings::kEdgeSamples};
            return because("samples", "added to a picture with one sample per pixel");
        case Part::block:
            samples = {Where::everywhere, RenderSettings::kEdgeSamples};
            return because("samples", "a block of a picture, whose pixels are the mean of 4 x 4");
        case Part::motion:
            if (!lack && motionSamples(device_) > 1) samples = {Where::resolved, motionSamples(device_)};
            if (reasons_) because("samples", lack ? lack : chooseMotionSamples(device_).why);
            return;
        case Part::whole:
            break;
        default:
            return because("samples", "layers, picks, distances and refined samples have one per pixel");
    }
    if (wantsEdges(settings_)) {
        if (isCrowd()) {
            choice_.refinement = Refinement::everywhere;
            return because("samples", "many small spheres: nearly every pixel has an edge");
        }
        if (!canDrawEdges(false)) return refine();
        samples = {Where::edges, RenderSettings::kEdgeSamples};
        return because("samples", "compute draws the samples of edge pixels from the tiles' lists");
    }
    if (n > 1) {
        samples = {Where::everywhere, n * n};
    } else if (device_.multisampling == Multisampling::four && n == 1) {
        if (lack) throw Error("cannot draw 4 samples per pixel", "--msaa 4", lack);
        samples = {Where::resolved, kMultisamples};
    }
    because("samples", n == 0 ? "debug views show single samples" : kAskedFor);
}

/// Whether the host can find the nearest sphere of each pixel: it tests pixel centres only, without clipping planes and
/// rims.
bool Chooser::hasFrontSpheres() const {
    const Effects& effects = settings_.effects;
    return settings_.tuning.cull && settings_.view.projection == Projection::orthographic && !effects.clip.on() &&
           effects.contours.width <= 0 && effects.halos.width <= 0 && scene_.triangles == 0 && scene_.boxed &&
           !scene_.hasTranslucentAtoms;
}

/// Whether lists of spheres would take longer than finding the nearest one of each pixel.
bool Chooser::hasSmallSpheres() const {
    constexpr double kSmallPixels = 2.5;  // a radius
    constexpr std::uint64_t kManySpheres = 100'000;
    const double samples = choice_.part == Part::block ? RenderSettings::kBlockSamples : 1;
    return scene_.spheres >= kManySpheres && scene_.radiusPixels <= kSmallPixels * samples;
}

/// Whether nearly every pixel of a picture has an edge, and the host finds the spheres of all samples.
bool Chooser::isCrowd() const {
    constexpr double kCrowdedPixels = 1.75;  // a radius; samples of larger spheres at edges alone take less time
    return mayCompute() && !device_.tiles.lists && !scene_.leveled && !scene_.blends() && request_.quarterTurns == 0 &&
           hasFrontSpheres() && hasSmallSpheres() && scene_.radiusPixels <= kCrowdedPixels;
}

/// Why a picture with one sample per pixel may miss places that need more; null: it finds them all.
const char* Chooser::blind() const {
    constexpr double kSmallPixels = 0.75;  // half of a width
    if (request_.quarterTurns != 0) return "blocks of a turned view are its whole rows";
    if (settings_.effects.linesByGroups() && settings_.effects.contours.width < 1)
        return "outlines thinner than a pixel may lie between pixel centres";
    if (scene_.smallestPixels < kSmallPixels) return "shapes thinner than a pixel may lie between pixel centres";
    return nullptr;
}

/// Adds samples where a picture with one sample per pixel changes colour. They are drawn in blocks, so that memory does
/// not grow with the picture. A frame per sample would list the scene as often.
void Chooser::refine() {
    if (const char* why = blind()) {
        choice_.refinement = Refinement::everywhere;
        return because("samples", why);
    }
    choice_.part = Part::coarse;
    if (canDrawEdges(true)) {
        choice_.refinement = Refinement::edges;
        return because("samples", "compute adds samples of edge pixels in one frame");
    }
    choice_.refinement = Refinement::blocks;
    because("samples", rims()            ? "outlines and halos have no samples at edges"
                       : scene_.blends() ? "translucent layers and volumes have no samples at edges"
                       : isFineMesh(request_.settings.view, scene_)
                           ? "a small picture of a fine mesh: lists would be long"
                           : "the path has no lists of what edge pixels may show");
}

void Chooser::chooseEffects() {
    const auto add = [&](Kind kind, std::uint32_t size = 0) { choice_.effects.add({kind, size}); };
    if (const std::uint32_t pixels = shadowPixels(settings_)) add(Kind::shadow, pixels);
    if (settings_.effects.linesByGroups()) add(Kind::outlines);
    if (settings_.effects.halos.width > 0) add(Kind::halos);
    if (drawsLayers(request_, scene_)) add(Kind::translucency, kTranslucentLayers);
    // Sums that may stay on a tile are small.
    choice_.fineSums = choice_.layers() > 0 && device_.blendsFloats &&
                       (device_.kind == DeviceKind::software || device_.kind == DeviceKind::immediate);
    if (drawsVolume(request_, scene_)) add(Kind::volume);
    if (request_.part == Part::whole && hasLens(settings_)) add(Kind::lens);
}

void Chooser::chooseColor() {
    ColorFormat& color = choice_.color;
    switch (choice_.part) {
        case Part::whole:
        case Part::coarse:
        case Part::edges:
        case Part::block:
            // Averages of the render pass are linear: no shader codes those colours.
            if (settings_.fine && !debugs())
                color = ColorFormat::linear;
            else if (choice_.samples.where != Where::resolved && mayCompute() && !scene_.blends())
                color = ColorFormat::coded;
            break;
        case Part::motion:
        case Part::sample:
            break;  // the window's format
        default:
            color = ColorFormat::linear;
    }
    if (color == ColorFormat::linear && (choice_.layers() > 0 || choice_.has(Kind::volume)) && !device_.blendsFloats)
        throw Error("cannot draw translucent layers or volumes", device_.plan.name,
                    "it does not blend 32 bits per channel, which layers and 16-bit pictures need; use 8 bits");
}

/// Render passes that a path by triangles takes where compute draws the frame in its place; 0: it does not.
std::uint32_t Chooser::renderPassesBeyond() const {
    const bool asked = device_.visibility != Visibility::automatic || choice_.debug != DebugView::none || rims() ||
                       (choice_.attachmentSamples() > 1 && device_.multisampling == Multisampling::four);
    if (asked || device_.tested.tilesFail || request_.headset || choice_.path == Visibility::tiles) return 0;
    const std::uint32_t count = countRenderPasses(choice_, fitted(choice_.path));
    return count > 1 ? count : 0;
}

void Chooser::choosePath() {
    const Visibility path = usual(adds());
    const bool computes = path == Visibility::tiles && mayCompute() && choice_.color == ColorFormat::coded &&
                          isPicture(request_.part) && !request_.counted;
    choice_.path = rims()     ? (computes ? Visibility::tiles : Visibility::deferred)
                   : debugs() ? pickPath(settings_.debug, path)
                              : path;
    const std::uint32_t beyond = renderPassesBeyond();
    if (beyond > 0) {
        choice_.path = Visibility::tiles;
        if (choice_.attachmentSamples() > 1) {
            choice_.samples = {};
            replaceReason("samples", "compute draws one sample per pixel");
        }
    }
    if (computes && !debugs())
        choice_.shading = Shading::compute;
    else if (choice_.path == Visibility::tiles && device_.tiles.lanes == 0 && device_.tiles.lists)
        choice_.shading = Shading::image;
    if (!reasons_) return;
    because("path", beyond > 0 ? "vertex outputs would take " + std::to_string(beyond) +
                                     " render passes: compute draws from lists instead"
                    : rims() && !computes               ? "outlines and halos need the primitive of each pixel"
                    : choice_.path == pickPath(device_) ? nacre::choosePath(device_).why
                    : debugs()                          ? "the debug view needs this path"
                                                        : "compute adds samples and depth to pictures of this device");
    because("shading", choice_.shadedByCompute()           ? "compute shades faster than fragments on this device"
                       : choice_.shadedByImage()           ? "no subgroup operation and few buffers: as on every phone"
                       : choice_.path != Visibility::tiles ? "triangles cover the pixels"
                       : request_.counted                  ? "fragments are counted"
                       : !device_.tiles.shade              ? "fragments shade as fast on this device"
                                              : "no shader codes the frame's colour, or it has other targets");
}

/// Work of the host before a path that draws triangles.
HostWork Chooser::chooseHostWork(Visibility path) const {
    // Where depth is tested late, shading hidden fragments takes a CPU longer than finding hidden spheres.
    const bool late = device_.kind == DeviceKind::software && !platesReject(path, device_.plan);
    return settings_.tuning.cull && late ? HostWork::hiddenSpheres : HostWork::none;
}

HostWork Chooser::hostWorkOfTiles() const {
    const bool many = settings_.tuning.cull && scene_.spheres >= settings_.tuning.hideFrom;
    if ((many || hasSmallSpheres()) && hasFrontSpheres() && !choice_.drawsEdges()) return HostWork::frontSpheres;
    return many ? HostWork::hiddenSpheres : HostWork::none;
}

bool Chooser::needsPrepass(Visibility path, PlateShape plates) const {
    if (debugs()) return true;  // views show the prepass
    // Without plates, passes that write depth themselves need no prepass.
    const bool wanted = plates != PlateShape::none || (path != Visibility::fragdepth && path != Visibility::deferred);
    return wanted && platesReject(path, device_.plan);
}

void Chooser::chooseGeometry() {
    const bool tiles = choice_.path == Visibility::tiles;
    choice_.prepass = needsPrepass(choice_.path, settings_.tuning.plates);
    choice_.geometry = tiles ? (device_.tiles.lists ? Geometry::deviceLists : Geometry::hostLists)
                       : device_.plan.geometry.storesVaryings && !request_.counted ? Geometry::fetched
                                                                                   : Geometry::instanced;
    const bool hostLists = choice_.geometry == Geometry::hostLists;
    if (!debugs() && (hostLists || !tiles)) choice_.host = tiles ? hostWorkOfTiles() : chooseHostWork(choice_.path);
    // A volume between layers needs their depth. With fewer lanes, each has so many pixels that SwiftShader compiles
    // the stage for 209 s.
    constexpr std::uint32_t kLanes = 8;
    if (hostLists && device_.tiles.lanes >= kLanes && !choice_.has(Kind::volume))
        choice_.effects.replace(Kind::translucency, Kind::tileTranslucency);
    if (request_.part == Part::edges && choice_.shadedByCompute()) {
        // The number of a sphere is enough if nothing cuts or outlines it.
        const bool alone = !scene_.hasCylinders && !scene_.hasWires && scene_.meshTriangles == 0 && !rims() &&
                           settings_.effects.contours.width <= 0 && !settings_.effects.clip.on();
        choice_.edgePixels = alone ? EdgePixels::alone : EdgePixels::listed;
    }
    if (!reasons_) return;
    because("geometry", tiles                                   ? "compute reads the primitives of each tile"
                        : choice_.geometry == Geometry::fetched ? "varyings go through memory: a number costs less"
                        : device_.plan.geometry.storesVaryings  ? "fragments are counted"
                                                                : "varyings stay on the chip");
    constexpr const char* kHost[] = {"the device finds what is hidden",
                                     "finding hidden spheres costs less than shading them",
                                     "many small spheres: lists would take longer"};
    because("host", kHost[static_cast<std::size_t>(choice_.host)]);
    because("prepass", tiles             ? "compute draws no plates"
                       : choice_.prepass ? "plates reject fragments before they are shaded"
                                         : "the path tests depth after shading: plates reject nothing");
    because("effects", "those with passes or images of their own");
}

void Chooser::chooseEnding() {
    Ending& ending = choice_.ending;
    ending = request_.ending;
    if (choice_.part == Part::edges || choice_.part == Part::block || choice_.has(Kind::lens) ||
        choice_.refinement == Refinement::everywhere)
        ending = Ending::picture;
    if (choice_.part == Part::coarse) ending = Ending::pictureAndHost;
    because("ending", ending == request_.ending ? kAskedFor : "further frames of the picture follow");
}

void Chooser::chooseOverflow() {
    if (!choice_.drawnByTiles()) return;
    Overflow& overflow = choice_.overflow;
    const Visibility usual = pickPath(device_);
    overflow.longestListOfLayers = device_.tiles.longestList;
    // Rims walk through each list twice.
    overflow.longestList =
        choice_.drawsEdges() ? device_.tiles.longestListOfEdges : device_.tiles.longestList / (rims() ? 2 : 1);
    overflow.path = rims() ? Visibility::deferred : usual == Visibility::tiles ? Visibility::fragdepth : usual;
    // Tiles of blocks cover a quarter of the side, so their lists are shorter.
    if (choice_.drawsEdges()) overflow.refinement = blind() ? Refinement::everywhere : Refinement::blocks;
    overflow.host = chooseHostWork(overflow.path);
    overflow.prepass = needsPrepass(overflow.path, settings_.tuning.plates);
    if (reasons_)
        because("long lists",
                "taken where a tile's list has more than " + std::to_string(overflow.longestList) + " entries");
}

/// Why each eye's view is a frame of its own; null: one frame draws both.
const char* Chooser::lackOfViews() const {
    if (device_.plan.maxViews < 2) return "the driver has no multiview, or none to be trusted";
    if (choice_.drawnByTiles()) return "tiles have lists of what one eye sees";
    if (choice_.refinement != Refinement::none) return "samples at edges are found for each eye";
    if (debugs()) return "debug views show one eye";
    if (rims() || settings_.effects.contours.width > 0) return "outlines and halos are drawn for each eye";
    if (choice_.has(Kind::shadow)) return "shadows are looked up for each eye";
    if (choice_.layers() > 0) return "translucent layers are found for each eye";
    if (choice_.has(Kind::volume)) return "rays through a volume are those of one eye";
    if (hasLens(settings_)) return "each eye looks through its own lens";
    if (scene_.leveled) return "levels of detail are found for each eye";
    if (request_.counted) return "fragments are counted for each eye";
    return nullptr;
}

void Chooser::chooseViews() {
    if (!request_.eyes) return;
    const char* lack = lackOfViews();
    if (!lack) choice_.views = 2, choice_.host = HostWork::none;  // the host would find what one eye sees
    because("views", lack ? lack : "parallel eyes: a draw call draws both, and both depths stay on the tile");
}

/// Why each pixel has a fragment of its own; null: a map decides.
const char* Chooser::lackOfFoveation() const {
    if (device_.plan.densityTexel == 0) return device_.lacksDensityMaps.c_str();
    if (choice_.drawnByTiles()) return "compute draws no fragments";
    if (debugs()) return "debug views show each pixel";
    if (choice_.attachmentSamples() > 1) return "a fragment of several pixels does not tell their samples apart";
    if (rims()) return "outlines and halos read the pixels around them";
    if (choice_.layers() > 0 || choice_.has(Kind::volume))
        return "translucent layers and volumes are found for each pixel";
    return nullptr;
}

void Chooser::chooseFoveation() {
    if (!request_.headset) return;
    const char* lack = lackOfFoveation();
    choice_.foveated = !lack;
    if (!reasons_) return;
    // Vulkan leaves to the driver which pixel of its own a fragment reads ("Render Pass"), and which it covers in part.
    because("foveation", lack ? lack
                         : choice_.path == Visibility::fragdepth
                             ? "fragments of several pixels where no eye looks"
                             : "fragments of several pixels where no eye looks; each reads the depth or number of one "
                               "of them, which all share unless a polygon ends there");
}

/// 0: no limit.
std::uint64_t Chooser::mostVertexBytes() const {
    const std::uint64_t asked = settings_.tuning.mostVertexBytes;
    return asked > 0 ? asked : device_.plan.geometry.mostVertexBytes;
}

/// Rounds of a pass that keep each one's vertex outputs within the limit.
Rounds Chooser::planRounds(const PassCost& cost, const PrimitiveCounts& counts) const {
    const std::uint64_t all = countBytes(cost, counts) * choice_.views, most = mostVertexBytes();
    Rounds rounds;
    if (all <= most) return rounds;
    rounds.bytes = countBytes(cost);
    // Shares are of whole primitives: each may have one more.
    const std::uint64_t one = std::uint64_t{*std::ranges::max_element(rounds.bytes)} * choice_.views;
    const std::uint64_t room = most > 2 * one ? most - one : one;
    rounds.count = static_cast<std::uint32_t>((all + room - 1) / room);
    return rounds;
}

/// The passes of a path over the primitives, in order.
GeometryWorks Chooser::planGeometry(Visibility path, const SphereShapes& shapes) const {
    const bool stores = device_.plan.geometry.storesVaryings, fetched = stores && !request_.counted;
    const auto cost = [&](Handed handed) { return computeCost(handed, stores, shapes); };
    GeometryWorks passes;
    if (path == Visibility::tiles) return passes;
    if (needsPrepass(path, shapes.plates)) passes.add({&VertexOutputs::plating, cost(Handed::plates)});
    const std::span<const ScreenTarget> targets = screenTargets(choice_);
    if (path == Visibility::deferred) passes.add({&VertexOutputs::nearest, cost(Handed::number)});
    if (path == Visibility::encoded || (path == Visibility::rasterOrder && !settlesWhileShading(targets)))
        passes.add({&VertexOutputs::nearest, cost(Handed::depth)});
    if (path == Visibility::deferred && !rims()) return passes;
    for (const ScreenTarget& target : targets) {
        const bool colour = target.output == passes::Output::color;
        const Handed handed = path == Visibility::deferred ? Handed::number
                              : colour && fetched          ? Handed::shadingFetched
                                                           : Handed::shading;
        passes.add({&VertexOutputs::shading, cost(handed)});
        if (path == Visibility::deferred) break;
    }
    return passes;
}

/// Shapes and rounds that keep vertex outputs of each render pass within the limit: first fewer corners, then no
/// plates, then more render passes.
VertexOutputs Chooser::fitted(Visibility path) const {
    const graph::GeometryCaps& caps = device_.plan.geometry;
    PrimitiveCounts counts = scene_;
    counts.flat = counts.flat || choice_.attachmentSamples() > 1;
    const FrameTuning& tuning = settings_.tuning;
    const std::uint64_t most = mostVertexBytes();
    if (most == 0) return {};
    const auto fit = [&](VertexOutputs outputs) {
        const bool usual = outputs == VertexOutputs();
        const SphereShapes shapes = chooseShapes(usual ? tuning.plates : outputs.plates,
                                                 usual ? tuning.impostor : outputs.impostor, caps, counts);
        std::uint64_t sum = 0;
        std::uint32_t renderPasses = 1;
        for (const auto& [rounds, cost] : planGeometry(path, shapes)) {
            Rounds made = planRounds(cost, counts);
            const std::uint64_t bytes = countBytes(cost, counts) * choice_.views / made.count;
            made.apart = sum > 0 && (made.count > 1 || sum + bytes > most);
            sum = made.apart || made.count > 1 ? bytes : sum + bytes;
            renderPasses += begun(made);
            // Passes of several targets share the rounds.
            Rounds& kept = outputs.*rounds;
            for (std::size_t kind = 0; kind < kept.bytes.size(); ++kind)
                kept.bytes[kind] = std::max(kept.bytes[kind], made.bytes[kind]);
            kept.count = std::max(kept.count, made.count);
            kept.apart = kept.apart || made.apart;
        }
        return std::pair(outputs, renderPasses);
    };
    auto [best, renderPasses] = fit({});
    const bool free = tuning.plates == PlateShape::automatic && tuning.impostor == ImpostorShape::automatic;
    for (const PlateShape plates : {PlateShape::square, PlateShape::none}) {
        if (!free || debugs() || renderPasses == 1) break;
        VertexOutputs fewer;
        fewer.plates = plates, fewer.impostor = ImpostorShape::square;
        const auto [outputs, begun] = fit(fewer);
        if (begun < renderPasses) best = outputs, renderPasses = begun;
    }
    return best;
}

void Chooser::chooseVertices() {
    choice_.vertices = fitted(choice_.path);
    if (choice_.vertices.plates == PlateShape::none) choice_.prepass = needsPrepass(choice_.path, PlateShape::none);
    Overflow& overflow = choice_.overflow;
    if (choice_.drawnByTiles()) {
        overflow.vertices = fitted(overflow.path);
        if (overflow.vertices.plates == PlateShape::none)
            overflow.prepass = needsPrepass(overflow.path, PlateShape::none);
    }
    if (mostVertexBytes() == 0) return;
    const graph::GeometryCaps& caps = device_.plan.geometry;
    const FrameTuning& tuning = settings_.tuning;
    const SphereShapes ofLight = chooseShapes(PlateShape::none, tuning.impostor, caps, scene_.light);
    const PassCost ofLayers =
        computeCost(Handed::number, false, chooseShapes(PlateShape::none, tuning.impostor, caps, scene_.layers));
    for (VertexOutputs* outputs : {&choice_.vertices, &overflow.vertices}) {
        outputs->light = planRounds(computeCost(Handed::depth, caps.storesVaryings, ofLight), scene_.light);
        outputs->layers = planRounds(ofLayers, scene_.layers);
    }
    if (!reasons_ || choice_.vertices == VertexOutputs()) return;
    PrimitiveCounts counts = scene_;
    counts.flat = counts.flat || choice_.attachmentSamples() > 1;
    std::uint64_t all = 0;
    for (const GeometryWork& pass :
         planGeometry(choice_.path, chooseShapes(tuning.plates, tuning.impostor, caps, counts)))
        all += countBytes(pass.cost, counts) * choice_.views;
    constexpr std::uint64_t kMega = 1'000'000;
    const auto text = [&](std::uint64_t bytes) {
        return bytes < kMega ? std::to_string(bytes) + " B" : std::to_string((bytes + kMega / 2) / kMega) + " MB";
    };
    because("vertex outputs",
            "they would be " + text(all) + ", and a render pass gets at most " + text(mostVertexBytes()));
    if (choice_.vertices.plates == PlateShape::none)
        for (Decision& decision : *reasons_)
            if (decision.what == "prepass") decision.why = "plates would take vertex outputs beyond the limit";
}

}  // namespace

std::uint32_t EffectList::size(Kind kind) const {
    const Effect* found = std::ranges::find(*this, kind, &Effect::kind);
    return found == end() ? 0 : found->size;
}
bool EffectList::has(Kind kind) const { return std::ranges::find(*this, kind, &Effect::kind) != end(); }
void EffectList::replace(Kind kind, Kind by) {
    for (std::uint32_t i = 0; i < count_; ++i)
        if (effects_[i].kind == kind) effects_[i].kind = by;
}

std::vector<graph::Share> Rounds::shares() const {
    std::vector<graph::Share> shares;
    for (std::uint32_t i = 0; i < count; ++i) shares.push_back({i, count, bytes, apart || i > 0});
    return shares;
}

std::uint32_t FrameChoice::layers() const {
    return std::max(effects.size(Kind::translucency), effects.size(Kind::tileTranslucency));
}

bool FrameChoice::readsCopyRows() const {
    return path == Visibility::deferred || shadedByImage() || layers() > 0 || rims();
}

FrameChoice FrameChoice::within(std::uint32_t longest, std::uint32_t longestOfLayers) const {
    FrameChoice choice = *this;
    if (!drawnByTiles()) return choice;
    if (longest > overflow.longestList) {
        choice.refinement = overflow.refinement;
        choice.path = overflow.path;
        choice.geometry = Geometry::instanced;
        choice.host = overflow.host;
        choice.prepass = overflow.prepass;
        choice.vertices = overflow.vertices;
        choice.shading = Shading::fragments;
        choice.samples = {};
        choice.edgePixels = {};
        choice.overflow = {};
    }
    if (longest > overflow.longestList || longestOfLayers > overflow.longestListOfLayers)
        choice.effects.replace(Kind::tileTranslucency, Kind::translucency);
    return choice;
}

std::uint32_t countRenderPasses(const FrameChoice& choice, const VertexOutputs& v) {
    const auto targets =
        static_cast<std::uint32_t>(choice.path == Visibility::deferred ? 1 : screenTargets(choice).size());
    return 1 + begun(v.plating) + begun(v.nearest) + targets * begun(v.shading);
}

FrameChoice choose(const FrameRequest& request, const SceneFacts& scene, const FrameCaps& device,
                   std::vector<Decision>* reasons) {
    return Chooser(request, scene, device, reasons).choose();
}

RenderSettings drawnSettings(const FrameRequest& request) {
    RenderSettings settings = request.settings.ofFrame();
    if (!isPicture(request.part)) settings.debug = DebugView::none;
    const bool debug = settings.debug != DebugView::none;
    // Passes that report a pixel's atom ignore outlines.
    if (!isPicture(request.part) || debug) settings.effects.contours.width = settings.effects.halos.width = 0;
    if (debug || !hasColor(request.part)) settings.effects.shadow = {};
    return settings;
}

Samples chooseSamples(const FrameRequest& request, const SceneFacts& scene, const FrameCaps& device) {
    return Chooser(request, scene, device).samples();
}

bool wantsEdges(const RenderSettings& settings) {
    return settings.supersample == RenderSettings::kEdges && settings.debug == DebugView::none;
}

bool drawsLayers(const FrameRequest& request, const SceneFacts& scene) {
    return isPicture(request.part) && request.settings.debug == DebugView::none && scene.hasTranslucent;
}

bool drawsVolume(const FrameRequest& request, const SceneFacts& scene) {
    return isPicture(request.part) && request.settings.debug == DebugView::none && scene.hasVolume;
}

graph::TestedPath choosePath(const FrameCaps& device) {
    const auto refuse = [&](Visibility path, const std::string& lacks) {
        throw Error("cannot draw by " + std::string(visibilityName(path)), device.plan.name, lacks);
    };
    if (device.visibility == Visibility::rasterOrder && device.plan.rasterOrder == graph::RasterOrder::none)
        refuse(device.visibility, device.lacksRasterOrder);
    if (device.visibility != Visibility::automatic) return {device.visibility, kAskedFor};
    if (device.tested.visibility != Visibility::automatic) return device.tested;
    const PathRow row = pathOfKind(device.kind, device.plan);
    return {row.path, row.why};
}

MotionSamples chooseMotionSamples(const FrameCaps& device) {
    if (device.multisampling == Multisampling::off) return {1, kAskedFor};
    const Visibility path = pickPath(device);
    const std::string lacks = lacksMultisampling(path, device.plan);
    if (device.multisampling == Multisampling::four) {
        if (!lacks.empty()) throw Error("cannot draw 4 samples per pixel", device.plan.name, lacks);
        return {kMultisamples, kAskedFor};
    }
    if (!lacks.empty()) return {1, lacks};
    if (const char* why = whySingleInMotion(device.kind, path, device.plan)) return {1, why};
    return {kMultisamples, "samples stay on the tile, and each fragment is shaded once"};
}

OcclusionMaps chooseOcclusionMaps(const FrameCaps& device) {
    if (device.kind == DeviceKind::software || pickPath(device) == Visibility::tiles) return OcclusionMaps::tiles;
    // Where MIN is a blend shader, the depth buffer is cheaper.
    return pickPath(device) == Visibility::encoded && !device.encoded.ordered ? OcclusionMaps::encoded
                                                                              : OcclusionMaps::fragdepth;
}

graph::TestedPath plainestPath(const char* why) { return {Visibility::fragdepth, why}; }

bool drawsByCompute(Visibility path) { return path == Visibility::tiles; }

bool hasPath(Visibility path, bool rasterOrder) { return path != Visibility::rasterOrder || rasterOrder; }

bool platesReject(Visibility path, const graph::PlanCaps& caps) {
    return caps.conservativeDepth || (path != Visibility::fragdepth && path != Visibility::deferred);
}

std::string lacksMultisampling(Visibility path, const graph::PlanCaps& caps) {
    switch (lackOfMultisampling(path, caps)) {
        case Lack::nothing:
            break;
        case Lack::encoded:
            return "--visibility encoded settles depth in one sample per pixel; fragdepth and raster-order take more";
        case Lack::deferred:
            return "--visibility deferred numbers one primitive per pixel";
        case Lack::tiles:
            return "--visibility tiles draws by compute: --supersample auto refines its edges";
        case Lack::places:
            return "the device places samples of its own";
        case Lack::room:
            return "its samples take " + std::to_string(bytesOfSamples(path)) +
                   " bytes per pixel of the tile, which holds " + std::to_string(caps.tileBytesPerPixel);
    }
    return {};
}

std::string lacksSamples(const RenderSettings& settings, bool blends) {
    const char* lack = lackOfSamples(settings, blends);
    return lack ? lack : "";
}

}  // namespace nacre
