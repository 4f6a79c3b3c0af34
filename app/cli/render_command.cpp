#include <unistd.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/cli/commands.h"
#include "app/cli/progress.h"
#include "app/cli/stats.h"
#include "app/download/load_molecule.h"
#include "app/shared/cache_folder.h"
#include "app/shared/capture_file.h"
#include "app/shared/image_file.h"
#include "app/shared/messages.h"
#include "app/shared/molecules.h"
#include "engine/error.h"
#include "engine/milliseconds.h"
#include "engine/renderer.h"

namespace nacre::app {
namespace {

/// The files asked for, made at once so that a folder that cannot be written to is refused before any work.
struct Outputs {
    OutputFile picture;
    std::optional<OutputFile> layers, stats, capture;

    explicit Outputs(const RenderOptions& options) : picture(options.output, ".png") {
        if (!options.layers.empty()) layers.emplace(options.layers, ".exr");
        if (!options.stats.empty()) stats.emplace(options.stats, ".json");
        if (!options.capture.empty()) capture.emplace(options.capture, ".rdc");
    }
};

RenderSettings settingsOf(const RenderOptions& options, const Representation& scene) {
    RenderSettings settings;
    settings.view = viewOf(options.camera, scene.radius, options.size.width, options.size.height);
    settings.supersample = options.supersample;
    settings.background = options.background;
    settings.lighting = options.lighting;
    settings.occlusion.directions = options.occlusion.directions;
    settings.occlusion.bytes = options.occlusion.bytes();
    settings.tuning = options.tuning;
    settings.debug = options.debug;
    // What is captured is to be seen: the bake, too, is done then.
    if (options.capture.empty()) settings.occlusion.cache = cacheFolder(options.input.cache, "occlusion");
    return settings;
}

void drawLayers(Renderer& renderer, const RenderSettings& settings, OutputFile& file) {
    writeLayers(file, renderer.layers(settings));
}

/// Patches so small that an atom shows hardly more than one shade.
bool isCoarse(const OcclusionStats& occlusion) { return occlusion.directions > 0 && occlusion.patchTexels < 8; }

/// What the memory budget led to.
void sayOcclusion(const OcclusionStats& occlusion, const RenderSettings& settings) {
    const std::string patch = std::to_string(occlusion.patchTexels);
    std::string text = "ambient occlusion: " +
                       (occlusion.patchTexels == 1 ? "one value an atom" : patch + " x " + patch + " texels an atom");
    if (!occlusion.cached) text += ", depth maps of " + std::to_string(occlusion.mapPixels) + " pixels";
    sayNote(text + ", " + std::to_string(occlusion.bytes >> 20) + " of " +
            std::to_string(settings.occlusion.bytes >> 20) + " MB");
}

/// Draws the picture once more, by shaders that count.
std::vector<PassCount> countFragments(Renderer& renderer, RenderSettings settings) {
    settings.tuning.countFragments = true;
    settings.debug = DebugView::none;
    renderer.render(settings);
    return renderer.stats().passes;
}

/// The picture, captured with its bake if a file is given or RenderDoc started this program.
Picture drawPicture(Renderer& renderer, const RenderSettings& settings, OutputFile* capture) {
    if (!capture && !renderer.startedByRenderDoc()) return renderer.render(settings);
    renderer.beginCapture(capture ? captureStem(*capture) : "");
    Picture picture = renderer.render(settings);
    const std::string written = renderer.endCapture();
    if (capture)
        keepCapture(written, *capture);
    else
        sayNote("captured to " + written);
    return picture;
}

void checkValidation(const Renderer& renderer) {
    const std::vector<std::string>& messages = renderer.validationMessages();
    if (messages.empty()) return;
    throw Error("Vulkan validation", renderer.stats().device.name,
                std::to_string(messages.size()) + " messages, the first: " + messages.front());
}

}  // namespace

void renderCommand(const RenderOptions& options) {
    const Clock::time_point start = Clock::now();
    Outputs outputs(options);
    RunStats run;
    Progress progress;

    progress.begin("reading");
    const Molecule molecule =
        loadMolecule(options.input, downloadProgress(progress), [&](double share) { progress.advance(share); });
    run.atomsRead = molecule.atoms.size();
    run.bondsKnown = molecule.bonds.size();
    run.loadMs = millisecondsSince(start);

    progress.begin("building the scene");
    const Clock::time_point sceneStart = Clock::now();
    Representation scene = sceneOf(molecule, options.input.path, options.drawn, options.look);
    RenderSettings settings = settingsOf(options, scene);
    settings.occlusion.onProgress = [&](double share) { progress.advance(share); };
    run.center = scene.center;
    run.atomsDrawn = scene.drawnAtoms;
    run.bondsDrawn = scene.drawnBonds;
    run.legends = scene.legends;
    run.warnings = molecule.warnings;
    run.warnings.insert(run.warnings.end(), scene.warnings.begin(), scene.warnings.end());
    for (const std::string& warning : scene.warnings) sayWarning(warning);
    run.sceneMs = millisecondsSince(sceneStart);

    Renderer renderer(options.device);
    renderer.setScene(std::move(scene));
    progress.begin(options.occlusion.directions ? "ambient occlusion" : "drawing");
    const Picture picture = drawPicture(renderer, settings, outputs.capture ? &*outputs.capture : nullptr);
    run.firstPictureMs = millisecondsSince(start);
    FrameStats frame = renderer.stats();  // of this picture, before the frames that follow add theirs

    if (options.occlusion.megabytes || (isatty(STDERR_FILENO) && isCoarse(frame.occlusion)))
        sayOcclusion(frame.occlusion, settings);

    progress.begin("writing");
    if (outputs.layers) drawLayers(renderer, settings, *outputs.layers);
    if (outputs.stats) frame.passes = countFragments(renderer, settings);
    checkValidation(renderer);
    writePicture(outputs.picture, picture, options.background[3] < 1.0f);
    if (!outputs.stats) return;
    run.totalMs = millisecondsSince(start);
    writeText(*outputs.stats, statsJson(run, settings.view, frame));
}

}  // namespace nacre::app
