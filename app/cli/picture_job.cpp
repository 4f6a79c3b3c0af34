#include "app/cli/picture_job.h"

#include <unistd.h>

#include <iterator>
#include <utility>
#include <vector>

#include "app/annotation/painter.h"
#include "app/cli/banded_picture.h"
#include "app/cli/idle_options.h"
#include "app/download/load_molecule.h"
#include "app/drawing/aim.h"
#include "app/drawing/scenes.h"
#include "app/files/cache_folder.h"
#include "app/files/capture_file.h"
#include "app/files/messages.h"
#include "app/images/image_file.h"
#include "app/input/trajectory_input.h"
#include "app/picture/effect_options.h"
#include "engine/error.h"
#include "engine/scene/orientation.h"
#include "engine/scene/uncover.h"

namespace nacre::app {
namespace {

/// A frame of a trajectory is seen from where the first is, as in a window and in films, and drawn as chosen there;
/// unless each is to have a camera of its own. @returns the radius that the camera goes by
double buildScene(const Molecule& molecule, const RenderOptions& options, const std::optional<Bounds>& frame,
                  Representation& scene) {
    const InputOptions& input = options.input;
    const TrajectoryOptions& frames = input.trajectory;
    if (frames.path.empty() || frames.frame == 1 || options.look.ownFrame || !options.look.assembly.empty() ||
        !input.further.empty()) {
        scene = sceneOf(molecule, input.path, options.drawn, options.look, frame);
        return scene.radius;
    }
    Molecule first = molecule;
    const HeardMessages again;  // what there is to say was said when the molecule was read
    movePositions(first, openMotion(frames, molecule)->positions(0));
    MovingScene moving = movingSceneOf(first, input.path, options.drawn, options.look);
    const double radius = moving.scene().radius;
    moving.move(molecule);
    scene = moving.scene();
    return radius;
}

RenderSettings settingsOf(const RenderOptions& options, const Camera& camera, double radius) {
    RenderSettings settings;
    settings.view = viewOf(camera, radius, options.size.width, options.size.height);
    settings.supersample = options.supersample;
    settings.meshError = options.meshError;
    settings.background = options.background;
    settings.lighting = options.lighting;
    settings.effects = options.effects;
    settings.occlusion.directions = options.occlusion.directions;
    settings.occlusion.bytes = options.occlusion.bytes();
    settings.occlusion.detail = options.occlusion.detail;
    settings.fine = options.bits == 16 || extensionOf(options.output) == ".exr";
    settings.tuning = options.tuning;
    settings.debug = options.debug;
    // What is captured is to be seen: the bake, too, is done then.
    if (options.capture.empty()) settings.occlusion.cache = cacheFolder(options.input.cache, "occlusion");
    return settings;
}

/// Patches so small that an atom shows hardly more than one shade.
bool isCoarse(const OcclusionStats& occlusion) { return occlusion.directions > 0 && occlusion.patchTexels < 8; }

/// What the memory budget led to.
void sayOcclusion(const OcclusionStats& occlusion) {
    const std::string patch = std::to_string(occlusion.patchTexels);
    std::string text = "ambient occlusion: " +
                       (occlusion.patchTexels == 1 ? "one value an atom" : patch + " x " + patch + " texels an atom");
    if (!occlusion.cached) text += ", depth maps of " + std::to_string(occlusion.mapPixels) + " pixels";
    sayNote(text + ", " + std::to_string(occlusion.bytes >> 20) + " of " + std::to_string(occlusion.budget >> 20) +
            " MB");
}

/// Draws the picture twice more: timed, since the first has compiled what it needs; and by shaders that count.
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

/// Moves the molecule out of the way of the words that stand beside it, unless a part of it is what is to be seen.
void makeRoom(PreparedPicture& prepared, const RenderOptions& options) {
    if (!prepared.words.any() || options.aim.placed || options.aim.zoomTo) return;
    constexpr std::size_t kMany = 200000;  // spheres and vertices: their sphere is nearly as good
    View& view = prepared.settings.view;
    const Representation& scene = prepared.scene;
    std::vector<glm::dvec4> balls{{0, 0, 0, view.radius}};
    if (!options.aim.turns && scene.drawnAtoms + scene.meshVertices.size() < kMany) balls = drawnBalls(scene);
    const View beside = WordPainter().besideWords(view, prepared.words, options.words.size, balls, options.camera.zoom);
    prepared.run.zoom *= beside.pixelsPerAngstrom / view.pixelsPerAngstrom;
    view = beside;
}

/// What is to be seen whole is. A plane cuts where what is left out would not do: copies of an assembly share what
/// they are made of, and a film goes around it.
void uncoverTarget(PreparedPicture& prepared, const RenderOptions& options, const Aimed& aim,
                   const Molecule& molecule) {
    const std::optional<Selection>& target = uncoveredBy(options.aim);
    if (!target) return;
    double& clipNear = prepared.settings.effects.clip.near;
    if (aim.clipNear && (options.aim.turns || !prepared.scene.copies.transforms.empty()))
        clipNear = std::max(clipNear, *aim.clipNear);
    if (options.aim.turns) return;
    prepared.run.uncovers = target->text;
    prepared.run.uncovered = uncover(prepared.scene, selectAtoms(molecule, *target), prepared.settings.view, clipNear);
}

/// Words of what is left out since it hides something go with it.
void putWords(PreparedPicture& prepared, const RenderOptions& options, const Molecule& molecule) {
    const bool some = !prepared.run.uncovers.empty();
    prepared.words =
        placeWords(options.words, molecule, prepared.scene, some ? WordsOfHidden::leftOut : WordsOfHidden::refused);
    const std::vector<std::string>& gone = prepared.words.leftOut;
    if (gone.empty()) return;
    const std::string more = gone.size() > 1 ? " and " + std::to_string(gone.size() - 1) + " more" : "";
    prepared.scene.warnings.push_back("no words at " + gone.front() + more + ": none of its atoms is drawn beside " +
                                      prepared.run.uncovers + ", which they hide (--uncover off)");
}

}  // namespace

PictureFormat formatOf(const RenderOptions& options) {
    return {options.background[3] < 1.0f, options.bits, options.dpi.value_or(0)};
}

PreparedPicture preparePicture(const Molecule& molecule, const RenderOptions& options,
                               const std::optional<Bounds>& frame) {
    const Clock::time_point start = Clock::now();
    PreparedPicture prepared;
    const double radius = buildScene(molecule, options, frame, prepared.scene);
    const Aimed aim = aimed(options.camera, options.aim, molecule, prepared.scene, options.size);
    prepared.settings = settingsOf(options, aim.camera, radius);
    View& view = prepared.settings.view;
    const auto depthFrom = [&] { return view.projection == Projection::perspective ? view.eyeDistance : view.radius; };
    const double depthOfFirst = depthFrom();
    if (prepared.scene.radius > radius) reachTo(view, prepared.scene.radius);
    prepared.depthShift = depthFrom() - depthOfFirst;
    RunStats& run = prepared.run;
    run.zoom = aim.camera.zoom;
    uncoverTarget(prepared, options, aim, molecule);
    run.clip = effectOption("clip")->text(prepared.settings.effects);
    if (options.debug == DebugView::none) putWords(prepared, options, molecule);
    std::ranges::copy(idleOptions(options, prepared.scene, prepared.settings.effects, prepared.scene.radius),
                      std::back_inserter(prepared.scene.warnings));
    makeRoom(prepared, options);
    run.atomsRead = molecule.atoms.size();
    run.bondsKnown = molecule.bonds.size();
    run.center = prepared.scene.center;
    run.atomsDrawn = prepared.scene.drawnAtoms;
    run.bondsDrawn = prepared.scene.drawnBonds;
    run.triangles = prepared.scene.triangles.size();
    run.vertices = prepared.scene.meshVertices.size();
    run.legends = prepared.scene.legends;
    run.warnings = molecule.warnings;
    run.warnings.insert(run.warnings.end(), prepared.scene.warnings.begin(), prepared.scene.warnings.end());
    run.sceneMs = millisecondsSince(start);
    return prepared;
}

std::size_t addWords(const PreparedPicture& prepared, const RenderOptions& options, const RenderSettings& settings,
                     Picture& picture, WordMemory* memory) {
    if (!prepared.words.any()) return 0;
    return WordPainter().paint(prepared.words, settings.view, options.words.size, options.words.color,
                               options.background, picture, settings.effects.clip, memory);
}

PictureJob::PictureJob(const RenderOptions& options, Progress& progress)
    : options_(options), progress_(progress), pictureFile_(options.output, ".png") {
    if (!options.layers.empty()) layersFile_.emplace(options.layers, ".exr");
    if (!options.stats.empty()) statsFile_.emplace(options.stats, ".json");
    if (!options.capture.empty()) captureFile_.emplace(options.capture, ".rdc");
}

void PictureJob::prepare() {
    progress_.begin("reading");
    const Molecule molecule =
        loadMolecule(options_.input, downloadProgress(progress_), [&](double share) { progress_.advance(share); });
    const double loadMs = millisecondsSince(start_);
    progress_.begin("building the scene");
    prepared_ = preparePicture(molecule, options_);
    prepared_.run.loadMs = loadMs;
    prepared_.settings.occlusion.onProgress = [&](double share) { progress_.advance(share); };
    warnings_ = prepared_.scene.warnings;
}

/// The picture, captured with its bake if a file is given or RenderDoc started this program.
Picture PictureJob::drawPicture(Renderer& renderer) {
    if (!isCaptured(renderer)) return renderer.render(prepared_.settings);
    renderer.beginCapture(captureFile_ ? captureStem(*captureFile_) : "");
    Picture picture = renderer.render(prepared_.settings);
    const std::string written = renderer.endCapture();
    if (captureFile_)
        keepCapture(written, *captureFile_);
    else
        sayNote("captured to " + written);
    return picture;
}

void PictureJob::sayCrowded(std::size_t labels) const {
    if (labels > 0)
        sayWarning(std::to_string(labels) + (labels == 1 ? " label" : " labels") +
                   " found no room in the picture (smaller --text-size, or fewer)");
}

/// Draws the picture in parts, and writes it meanwhile.
void PictureJob::drawInParts(Renderer& renderer) {
    const RenderSettings& settings = prepared_.settings;
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
    if (prepared_.words.any()) {
        painter.emplace();
        Marks marks = painter->layOut(prepared_.words, view, options_.words.size, options_.words.color,
                                      options_.background, settings.effects.clip);
        sayCrowded(marks.crowded);
        picture.setMarks(*painter, std::move(marks));
    }
    writePicture(
        pictureFile_, view.width, view.height, [&](std::uint32_t first, std::uint32_t) { return picture.rows(first); },
        formatOf(options_));
    written_ = true;
    frame_ = picture.stats();
    prepared_.run.parts = picture.parts();
}

bool PictureJob::isCaptured(const Renderer& renderer) const { return captureFile_ || renderer.startedByRenderDoc(); }

void PictureJob::draw(Renderer& renderer) {
    const RenderSettings& settings = prepared_.settings;
    renderer.setScene(std::move(prepared_.scene));
    progress_.begin(settings.occlusion.directions ? "ambient occlusion" : "drawing");
    if (isBanded(renderer, settings)) {
        drawInParts(renderer);
    } else {
        picture_ = drawPicture(renderer);
        frame_ = renderer.stats();  // of this picture, before the frames that follow add theirs
    }
    prepared_.run.driver = renderer.driverFeedback();
    prepared_.run.firstPictureMs = millisecondsSince(start_);
    if (options_.occlusion.megabytes || (isatty(STDERR_FILENO) && isCoarse(frame_.occlusion)))
        sayOcclusion(frame_.occlusion);
    if (layersFile_) layers_ = renderer.layers(settings);
    if (layers_ && prepared_.depthShift != 0)  // the background's infinity stays
        for (float& z : layers_->z) z = static_cast<float>(static_cast<double>(z) - prepared_.depthShift);
    if (statsFile_ && !written_) tellOfPasses(renderer, settings, frame_);
    checkValidation(renderer);
}

void PictureJob::write() {
    progress_.begin("writing");
    if (layersFile_) writeLayers(*layersFile_, *layers_);
    layers_.reset();
    if (!written_) {
        sayCrowded(addWords(prepared_, options_, prepared_.settings, picture_));
        writePicture(pictureFile_, picture_, formatOf(options_));
    }
    if (!statsFile_) return;
    prepared_.run.totalMs = millisecondsSince(start_);
    writeText(*statsFile_, statsJson(prepared_.run, prepared_.settings.view, frame_));
}

}  // namespace nacre::app
