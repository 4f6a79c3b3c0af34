// Samples of a picture, and the frames that refine it.

#include <algorithm>

#include "engine/error.h"
#include "engine/frame/chooser.h"

namespace nacre {

using graph::FrameCaps;
using Where = Samples::Where;

namespace {

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

}  // namespace

/// Whether a frame by tiles can have samples at edges.
bool Chooser::canDrawEdges(bool adds) const {
    return usual(adds) == Visibility::tiles && device_.tiles.drawsEdges && !scene_.blends() && !rims() &&
           !isFineMesh(request_.settings.view, scene_);
}

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
            return because("samples", "a block of a picture, whose pixels are the mean of several");
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
           !scene_.hasEllipsoids && !scene_.hasTranslucentAtoms;
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
    return mayCompute() && !device_.tiles.lists && !scene_.leveled && !scene_.blends() && request_.quarterTurns == 0 &&
           hasFrontSpheres() && hasSmallSpheres();
}

/// Why a picture with one sample per pixel may miss places that need more; null: it finds them all.
const char* Chooser::blind() const {
    constexpr double kSmallPixels = 0.75;  // half of a width
    if (request_.quarterTurns != 0) return "blocks of a turned view are its whole rows";
    if (settings_.effects.linesByGroups() && settings_.effects.contours.width < 1)
        return "outlines thinner than a pixel may lie between pixel centres";
    // Where the host lists all shapes, its lists mark them.
    const bool listed = pickPath(device_) == Visibility::tiles && !device_.tiles.lists &&
                        settings_.effects.contours.width <= 0 && hostWorkOfTiles() == HostWork::none;
    if (scene_.smallestPixels < kSmallPixels && !listed)
        return "shapes thinner than a pixel may lie between pixel centres";
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

Samples chooseSamples(const FrameRequest& request, const SceneFacts& scene, const FrameCaps& device) {
    return Chooser(request, scene, device).samples();
}

bool wantsEdges(const RenderSettings& settings) {
    return settings.supersample == RenderSettings::kEdges && settings.debug == DebugView::none;
}

std::string lacksSamples(const RenderSettings& settings, bool blends) {
    const char* lack = lackOfSamples(settings, blends);
    return lack ? lack : "";
}

}  // namespace nacre
