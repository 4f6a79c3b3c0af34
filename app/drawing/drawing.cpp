#include "app/drawing/drawing.h"

#include <atomic>

#include "app/annotation/painter.h"
#include "app/drawing/aim.h"
#include "app/drawing/complete.h"
#include "app/drawing/focus.h"
#include "app/drawing/map_layers.h"
#include "app/drawing/scenes.h"
#include "app/files/cache_folder.h"
#include "app/files/messages.h"
#include "app/files/output_file.h"
#include "app/input/read_input.h"
#include "app/picture/option_text.h"
#include "app/picture/options.h"
#include "engine/error.h"
#include "engine/milliseconds.h"
#include "engine/scene/view/orientation.h"

namespace nacre::app {
namespace {

/// A frame of a trajectory is seen from where the first is, as in a window and in movies, and drawn as chosen there;
/// unless each is to have a camera of its own. @returns the radius that the camera goes by
double buildScene(const ResidueFacts& facts, const PictureDescription& options, const std::optional<Bounds>& frame,
                  Representation& scene) {
    const InputOptions& input = options.input;
    const TrajectoryOptions& frames = input.trajectory;
    const Molecule& molecule = facts.molecule();
    if (frames.path.empty() || frames.frame == 1 || options.look.ownFrame || !options.look.assembly.empty() ||
        !input.further.empty()) {
        scene = sceneOf(facts, input.path, options.drawn, options.look,
                        frame ? frame : frameOfPrimitives(molecule, options), options.drawsBeside());
        return scene.radius;
    }
    Molecule first = molecule;
    const HeardMessages again;  // everything was reported when the molecule was read
    movePositions(first, openMotion(frames, molecule)->positions(0));
    MovingScene moving = movingSceneOf(first, input.path, options.drawn, options.look);
    const double radius = moving.scene().radius;
    moving.move(molecule);
    scene = moving.scene();
    return radius;
}

RenderSettings settingsOf(const PictureDescription& options, const Camera& camera, double radius) {
    RenderSettings settings = shadingOf(options);
    settings.view = viewOf(camera, radius, options.size.width, options.size.height);
    settings.supersample = options.supersample;
    settings.meshError = options.meshError;
    settings.fine = options.bits == 16 || extensionOf(options.output) == ".exr";
    settings.tuning = options.tuning;
    settings.debug = options.debug;
    // Captures include the bake.
    if (options.capture.empty()) settings.occlusion.cache = cacheFolder(options.input.cache, "occlusion");
    return settings;
}

/// Removes what hides the target. Uses a clipping plane instead for assemblies, whose copies share primitives, and for
/// movies, which rotate around it.
void uncoverTarget(const Aimed& aim, const Aim& wanted, const ResidueFacts& facts, Representation& scene,
                   RenderSettings& settings, RunStats& run) {
    const std::optional<Selection>& target = uncoveredBy(wanted);
    if (!target) return;
    double& clipNear = settings.effects.clip.near;
    if (aim.clipNear && (wanted.turns || !scene.copies.transforms.empty()))
        clipNear = std::max(clipNear, *aim.clipNear);
    if (wanted.turns) return;
    run.uncovers = target->text;
    run.uncovered = uncover(scene, selectAtoms(facts, *target), settings.view, clipNear);
}

void tellScene(const Molecule& molecule, const Representation& scene, RunStats& run) {
    run.atomsRead = molecule.atoms.size();
    run.bondsKnown = molecule.bonds.size();
    run.center = scene.center;
    run.atomsDrawn = scene.drawnAtoms;
    run.bondsDrawn = scene.drawnBonds;
    run.triangles = scene.triangles.size();
    run.vertices = scene.meshVertices.size();
    run.legends = scene.legends;
}

/// The view's aim. Pictures that share a scale are not fitted individually.
Aim aimOf(const Molecule& molecule, const PictureDescription& options, const std::optional<Bounds>& frame) {
    Aim aim = options.aim;
    const bool alone = !frame && options.input.trajectory.path.empty() && molecule.others.empty() &&
                       !options.look.ownFrame && !aim.turns;
    aim.fits = aim.fits && alone && options.camera.zoom == 1 && options.camera.pan == glm::dvec2(0);
    return aim;
}

}  // namespace

void Drawing::prepare(const Molecule& molecule, const PictureDescription& description,
                      const std::optional<Bounds>& frame) {
    try {
        facts_ = facts_ ? facts_->moved(molecule) : ResidueFacts(molecule);
        bringUpTo(*facts_, description, frame);
    } catch (...) {
        forget();  // an incomplete result must not pass for a complete one
        throw;
    }
}

void Drawing::bringUpTo(const ResidueFacts& facts, const PictureDescription& description,
                        const std::optional<Bounds>& frame) {
    static std::atomic<std::uint64_t> scenes{0};
    const Clock::time_point start = Clock::now();
    const Molecule& molecule = facts.molecule();
    const Facets parts = difference(description_, description);
    if (scene_ && parts == 0) return;
    // Atoms left out because they hide others depend on the view, too. Maps and primitives decide whether all may be
    // hidden.
    const bool another = !scene_ || (parts & (Facet::input | Facet::frame | Facet::scene)) != 0 ||
                         description.drawsBeside() != description_.drawsBeside() || (molecule.atoms.empty() && parts) ||
                         uncoveredBy(description.aim) || uncoveredBy(description_.aim) ||
                         (cutsScene_ && has(parts, Facet::view));
    description_ = description;
    if (another) {
        scene_.emplace();
        radius_ = buildScene(facts, description_, frame, *scene_);
        if (recolor) recolor(*scene_);
        colorByMap(description_, *scene_);
        number_ = ++scenes;
        ++counts_.scenes;
    }
    const Aimed aim =
        aimed(description_.camera, aimOf(molecule, description_, frame), facts, *scene_, description_.size);
    if (another || has(parts, Facet::map) || (description_.maps.aroundFocus && has(parts, Facet::view))) {
        maps_ = mapLayersOf(molecule, description_, scene_->center, {aim.camera, radius_});
        number_ = ++scenes;
    }
    const double framed = std::max(radius_, maps_.frame);
    run = {};
    settings = settingsOf(description_, aim.camera, framed);
    const View& view = settings.view;
    const auto depthFrom = [&] { return view.projection == Projection::perspective ? view.eyeDistance : view.radius; };
    const double depthOfFirst = depthFrom();
    const double reach = std::max(scene_->radius, maps_.shown.radius);
    if (reach > framed) reachTo(settings.view, reach);
    depthShift_ = depthFrom() - depthOfFirst;
    run.zoom = aim.camera.zoom;
    takeGuide(molecule, description_, settings);
    viewScene(molecule);
    uncoverTarget(aim, description_.aim, facts, *scene_, settings, run);
    focusLens(molecule, description_, scene_->center, settings);
    run.clip = clipText(settings.effects.clip);
    warnings = molecule.guide ? molecule.guide->warnings : std::vector<std::string>();
    warnings.insert(warnings.end(), scene_->warnings.begin(), scene_->warnings.end());
    warnings.insert(warnings.end(), maps_.warnings.begin(), maps_.warnings.end());
    if (description_.debug == DebugView::none) putWords(facts);
    for (std::string& idle : idleOptions(description_, *scene_, settings.effects, scene_->radius))
        warnings.push_back(std::move(idle));
    makeRoom();
    tellScene(molecule, *scene_, run);
    run.legends.insert(run.legends.end(), maps_.shown.legends.begin(), maps_.shown.legends.end());
    run.warnings = molecule.warnings;
    run.warnings.insert(run.warnings.end(), warnings.begin(), warnings.end());
    run.sceneMs = millisecondsSince(start);
}

void Drawing::placeWordsIn(const Representation& scene, const ResidueFacts& facts, WordsOfHidden hidden) {
    words = placeWords(description_.words, facts, scene, hidden);
    addLabels(maps_.labels, scene.center, words);
    if (description_.words.legend)
        words.legends.insert(words.legends.end(), maps_.shown.legends.begin(), maps_.shown.legends.end());
}

/// Sees a scene file's molecule from where its camera stands.
void Drawing::viewScene(const Molecule& molecule) {
    cutsScene_ = false;
    const SceneCamera* camera = sceneCamera(molecule, description_);
    seenByScene_ = camera != nullptr;
    if (!camera) return;
    const bool ortho =
        description_.given.contains("projection") && description_.camera.projection == Projection::orthographic;
    const double reach = std::max(scene_->radius, maps_.shown.radius);
    const SceneView seen =
        viewOf(*camera, description_.camera, ortho, reach, description_.size.width, description_.size.height);
    settings.view = seen.view;
    Clip& clip = settings.effects.clip;
    clip.near = std::max(clip.near, seen.clip.near);
    clip.far = std::min(clip.far, seen.clip.far);
    cutsScene_ = seen.clip.on();
    dropOutside(*scene_, seen);
    dropOutside(maps_.shown, seen);
}

/// Words of what is left out since it hides something go with it.
void Drawing::putWords(const ResidueFacts& facts) {
    const bool some = !run.uncovers.empty();
    placeWordsIn(*scene_, facts, some ? WordsOfHidden::leftOut : WordsOfHidden::refused);
    if (words.leftOut.empty()) return;
    const std::size_t others = words.leftOut.size() - 1;
    warnings.push_back("no label at " + words.leftOut.front() +
                       (others ? " and " + std::to_string(others) + " more" : "") +
                       ": none of its atoms is drawn, since they hide " + run.uncovers + " (--uncover off)");
}

/// Moves the molecule clear of the words beside it, unless the view shows a part of it.
void Drawing::makeRoom() {
    if (!words.any() || seenByScene_ || description_.aim.placed || description_.aim.zoomTo) return;
    constexpr std::size_t kMany = 200000;  // spheres and vertices: their sphere is nearly as good
    View& view = settings.view;
    std::vector<glm::dvec4> balls{{0, 0, 0, view.radius}};
    if (!description_.aim.turns && scene_->drawnAtoms + scene_->meshVertices.size() < kMany)
        balls = drawnBalls(*scene_);
    const View beside =
        WordPainter().besideWords(view, words, description_.words.size, balls, description_.camera.zoom);
    run.zoom *= beside.pixelsPerAngstrom / view.pixelsPerAngstrom;
    view = beside;
}

void Drawing::show(Canvas& canvas) {
    if (canvas.scene == number_) return;
    canvas.scene = 0;
    const bool colors = canvas.renderer.setScene(maps_.empty() ? *scene_ : withMaps(*scene_, maps_));
    canvas.scene = number_;
    ++counts_.uploads;
    counts_.colors += colors ? 1 : 0;
}

void Drawing::handOver(Canvas& canvas) {
    canvas.scene = 0;
    canvas.renderer.setScene(withMaps(std::move(*scene_), maps_));
    scene_.reset();
    ++counts_.uploads;
}

Picture Drawing::draw(Canvas& canvas, std::vector<std::string>* said) {
    show(canvas);
    Picture picture = canvas.renderer.render(settings);
    const std::vector<std::string> ofWords = addWords(settings, picture);
    if (said) said->insert(said->end(), ofWords.begin(), ofWords.end());
    return picture;
}

CodedPicture Drawing::drawCoded(Canvas& canvas, bool alpha, std::vector<std::string>* said) {
    if (words.any()) return coded(draw(canvas, said), alpha);
    show(canvas);
    return canvas.renderer.renderCoded(settings, alpha);
}

void Drawing::startCoded(Canvas& canvas, bool alpha) {
    show(canvas);
    canvas.renderer.startCoded(settings, alpha);
}

LayerPicture Drawing::layers(Renderer& renderer) const {
    LayerPicture layers = renderer.layers(settings);
    if (depthShift_ != 0)  // the background's infinity stays
        for (float& z : layers.z) z = static_cast<float>(static_cast<double>(z) - depthShift_);
    return layers;
}

std::vector<std::string> Drawing::addWords(const RenderSettings& drawn, Picture& picture, WordMemory* memory) const {
    if (!words.any()) return {};
    return WordPainter().paint(words, drawn.view, description_.words.size, description_.words.color, drawn.background,
                               picture, drawn.effects.clip, memory);
}

}  // namespace nacre::app
