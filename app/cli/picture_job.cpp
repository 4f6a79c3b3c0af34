#include "app/cli/picture_job.h"

#include <unistd.h>

#include <utility>

#include "app/annotation/painter.h"
#include "app/cli/banded_picture.h"
#include "app/files/capture_file.h"
#include "app/files/messages.h"
#include "app/input/input_files.h"
#include "app/picture/saved_view.h"
#include "engine/error.h"

namespace nacre::app {
namespace {

/// Patches so small that an atom has hardly more than one shade.
bool isCoarse(const OcclusionStats& occlusion) { return occlusion.directions > 0 && occlusion.patchTexels < 8; }

/// Reports the result of the memory limit.
void sayOcclusion(const OcclusionStats& occlusion) {
    const std::string patch = std::to_string(occlusion.patchTexels);
    std::string text = "ambient occlusion: " +
                       (occlusion.patchTexels == 1 ? "one value per atom" : patch + " x " + patch + " texels per atom");
    if (!occlusion.cached) text += ", depth maps of " + std::to_string(occlusion.mapPixels) + " pixels";
    sayNote(text + ", " + std::to_string(occlusion.bytes >> 20) + " of " + std::to_string(occlusion.budget >> 20) +
            " MB");
}

/// Draws the picture twice more: timed, since the first drawing compiled pipelines; and with counting shaders.
void tellOfPasses(Renderer& renderer, RenderSettings settings, FrameStats& frame) {
    settings.debug = DebugView::none;
    settings.tuning.timePasses = true;
    renderer.render(settings);
    frame.passTimes = renderer.stats().passTimes;
    settings.tuning.timePasses = false;
    settings.tuning.countFragments = true;
    renderer.render(settings);
    frame.passes = renderer.stats().passes;
}

void checkValidation(const Renderer& renderer) {
    const std::vector<std::string> messages = renderer.validationMessages();
    if (messages.empty()) return;
    throw Error("Vulkan validation", renderer.stats().device.name,
                std::to_string(messages.size()) + " messages, the first: " + messages.front());
}

}  // namespace

PictureJob::PictureJob(const PictureDescription& options, Progress& progress)
    : options_(options), progress_(progress), pictureFile_(options.output, ".png") {
    if (!options.layers.empty()) layersFile_.emplace(options.layers, ".exr");
    if (!options.saveView.empty()) viewFile_.emplace(options.saveView, ".json");
    if (!options.stats.empty()) statsFile_.emplace(options.stats, ".json");
    if (!options.capture.empty()) captureFile_.emplace(options.capture, ".rdc");
}

void PictureJob::prepare(OpenScene* scene) {
    const Molecule molecule = readMoleculeAndMaps(options_, progress_, scene);
    const double loadMs = millisecondsSince(start_);
    progress_.begin("building the scene");
    drawing_.prepare(molecule, options_);
    drawing_.run.loadMs = loadMs;
    // Statistics and captures include texels that the view does not show.
    drawing_.settings.occlusion.once = !statsFile_ && !captureFile_;
    drawing_.settings.occlusion.onProgress = [&](double share) { progress_.advance(share); };
}

/// Draws the picture. Captures it with its bake if a file is given or RenderDoc started this program. Without words it
/// is coded at once.
void PictureJob::drawPicture(Renderer& renderer) {
    const RenderSettings& settings = drawing_.settings;
    const auto draw = [&] {
        if (drawing_.stereo().on())
            picture_ = drawing_.drawAs(settings, renderer, nullptr, &ofWords_);
        else if (settings.fine || drawing_.words.any())
            picture_ = renderer.render(settings);
        else
            codes_ = renderer.renderCoded(settings, hasAlpha(chooseFormat(options_), options_.output));
    };
    if (!isCaptured(renderer)) return draw();
    renderer.beginCapture(captureFile_ ? captureStem(*captureFile_) : "");
    draw();
    const std::string written = renderer.endCapture();
    if (captureFile_)
        keepCapture(written, *captureFile_);
    else
        sayNote("captured to " + written);
}

/// Draws the picture in parts, and writes each part when it is done.
void PictureJob::drawInParts(Renderer& renderer) {
    const RenderSettings& settings = drawing_.settings;
    const View& view = settings.view;
    for (const auto& [option, asked] :
         {std::pair{"--layers", !options_.layers.empty()}, {"--capture", isCaptured(renderer)}})
        if (asked)
            throw Error("picture too large", std::to_string(view.width) + "x" + std::to_string(view.height),
                        std::string(option) + " takes one that is drawn at once");
    BandedPicture picture(renderer, settings, [&](double share) {
        if (share >= 1) return;
        progress_.begin("drawing in parts");
        progress_.advance(share);
    });
    std::optional<WordPainter> painter;
    if (drawing_.words.any()) {
        painter.emplace();
        Marks marks = painter->layOut(drawing_.words, view, options_.words.size, options_.words.color,
                                      settings.background, settings.effects.clip);
        for (const std::string& warning : painter->listWarnings(marks)) sayWarning(warning);
        picture.setMarks(*painter, std::move(marks));
    }
    writePicture(
        pictureFile_, view.width, view.height, [&](std::uint32_t first, std::uint32_t) { return picture.rows(first); },
        chooseFormat(options_));
    written_ = true;
    frame_ = picture.stats();
    drawing_.run.parts = picture.parts();
}

bool PictureJob::isCaptured(const Renderer& renderer) const { return captureFile_ || renderer.startedByRenderDoc(); }

void PictureJob::draw(Canvas& canvas) {
    Renderer& renderer = canvas.renderer;
    const RenderSettings& settings = drawing_.settings;
    drawing_.handOver(canvas);
    progress_.begin(settings.occlusion.directions ? "ambient occlusion" : "drawing");
    if (!drawing_.stereo().on() && isBanded(renderer, settings)) {
        drawInParts(renderer);
    } else {
        drawPicture(renderer);
        frame_ = renderer.stats();  // of this picture, before later frames add theirs
    }
    drawing_.run.driver = renderer.driverFeedback();
    drawing_.run.choice = renderer.decisions();
    drawing_.run.firstPictureMs = millisecondsSince(start_);
    if (options_.occlusion.megabytes || (isatty(STDERR_FILENO) && isCoarse(frame_.occlusion)))
        sayOcclusion(frame_.occlusion);
    if (layersFile_) layers_ = drawing_.layers(renderer);
    if (statsFile_ && !written_) tellOfPasses(renderer, settings, frame_);
    checkValidation(renderer);
}

void PictureJob::write() {
    progress_.begin("writing");
    if (layersFile_) writeLayers(*layersFile_, *layers_);
    layers_.reset();
    if (codes_) {
        writePicture(pictureFile_, *codes_, chooseFormat(options_).dpi);
    } else if (!written_) {
        if (!drawing_.stereo().on()) ofWords_ = drawing_.addWords(drawing_.settings, picture_);
        for (const std::string& warning : ofWords_) sayWarning(warning);
        writePicture(pictureFile_, picture_, chooseFormat(options_));
    }
    if (viewFile_) writeText(*viewFile_, savedViewJson(withPathsIn(options_.saveView, drawing_.placed())));
    if (!statsFile_) return;
    drawing_.run.totalMs = millisecondsSince(start_);
    writeText(*statsFile_, statsJson(drawing_.run, drawing_.settings.view, frame_));
}

}  // namespace nacre::app
