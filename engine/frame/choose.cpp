#include "engine/frame/choose.h"

#include <algorithm>

#include "engine/error.h"
#include "engine/frame/chooser.h"
#include "engine/frame/effects/lens/choice.h"
#include "engine/frame/effects/shadow/choice.h"

namespace nacre {

using graph::DeviceKind;
using graph::FrameCaps;
using Kind = Effect::Kind;
using Where = Samples::Where;

namespace {

bool isPicture(Part part) {
    return part != Part::distances && part != Part::layers && part != Part::solid && part != Part::pick;
}
bool hasColor(Part part) { return isPicture(part) || part == Part::layers; }

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

}  // namespace

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
    return settings_.tuning.cull && late && !scene_.hasEllipsoids ? HostWork::hiddenSpheres : HostWork::none;
}

HostWork Chooser::hostWorkOfTiles() const {
    const bool many = settings_.tuning.cull && !scene_.hasEllipsoids && scene_.spheres >= settings_.tuning.hideFrom;
    if ((many || hasSmallSpheres()) && hasFrontSpheres() && !choice_.drawsEdges()) return HostWork::frontSpheres;
    return many ? HostWork::hiddenSpheres : HostWork::none;
}

bool Chooser::needsPrepass(Visibility path, PlateShape plates) const {
    if (debugs()) return true;  // views show the prepass
    // Without plates, passes that write depth themselves need no prepass.
    const bool wanted = (plates != PlateShape::none && !scene_.hasEllipsoids) ||
                        (path != Visibility::fragdepth && path != Visibility::deferred);
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
    if (request_.part == Part::block && choice_.shadedByCompute() && choice_.host == HostWork::frontSpheres &&
        !scene_.hasCylinders && !scene_.hasWires && !scene_.blends()) {
        choice_.shading = Shading::picture;
        replaceReason("shading", "the host finds the sphere of each sample");
    }
    if (request_.part == Part::edges && choice_.shadedByCompute()) {
        // The number of a sphere is enough if nothing cuts or outlines it.
        const bool alone = !scene_.hasCylinders && !scene_.hasWires && scene_.meshTriangles == 0 &&
                           !scene_.hasEllipsoids && !rims() && settings_.effects.contours.width <= 0 &&
                           !settings_.effects.clip.on();
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
    because("prepass", tiles                  ? "compute draws no plates"
                       : scene_.hasEllipsoids ? "ellipsoids do not fill their spheres: no plates hide what is behind"
                       : choice_.prepass      ? "plates reject fragments before they are shaded"
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
    // Tiles of blocks cover half or a quarter of the side, so their lists are shorter.
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

std::uint32_t EffectList::size(Kind kind) const {
    const Effect* found = std::ranges::find(*this, kind, &Effect::kind);
    return found == end() ? 0 : found->size;
}
bool EffectList::has(Kind kind) const { return std::ranges::find(*this, kind, &Effect::kind) != end(); }
void EffectList::replace(Kind kind, Kind by) {
    for (std::uint32_t i = 0; i < count_; ++i)
        if (effects_[i].kind == kind) effects_[i].kind = by;
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

bool drawsLayers(const FrameRequest& request, const SceneFacts& scene) {
    return isPicture(request.part) && request.settings.debug == DebugView::none && scene.hasTranslucent;
}

bool drawsVolume(const FrameRequest& request, const SceneFacts& scene) {
    return isPicture(request.part) && request.settings.debug == DebugView::none && scene.hasVolume;
}

}  // namespace nacre
