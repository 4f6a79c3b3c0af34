#include "app/drawing/drawing.h"

#include <algorithm>
#include <atomic>

#include "app/annotation/painter.h"
#include "app/drawing/aim.h"
#include "app/drawing/complete.h"
#include "app/drawing/focus.h"
#include "app/drawing/scenes.h"
#include "app/files/cache_folder.h"
#include "app/files/messages.h"
#include "app/files/output_file.h"
#include "app/input/read_input.h"
#include "app/picture/option_text.h"
#include "app/picture/options.h"
#include "engine/milliseconds.h"
#include "engine/molecule/crystal.h"
#include "engine/scene/build/mesh_caps.h"
#include "engine/scene/view/cut_scene.h"
#include "engine/scene/view/orientation.h"
#include "engine/scene/view/visible_depths.h"

namespace nacre::app {
namespace {

/// Whether a description shows a frame of a trajectory other than the first, by the first frame's camera and choices.
bool showsLaterFrame(const PictureDescription& picture) {
    const TrajectoryOptions& frames = picture.input.trajectory;
    return !frames.path.empty() && frames.frame != 1 && !picture.look.ownFrame && picture.look.assembly.empty() &&
           !picture.input.several();
}

/// The view's aim. Pictures with a shared scale are not fitted individually.
Aim sharedAim(const Molecule& molecule, const PictureDescription& picture, const std::optional<Bounds>& frame) {
    Aim aim = picture.aim;
    const bool alone = !frame && picture.input.trajectory.path.empty() && molecule.others.empty() &&
                       !picture.look.ownFrame && !aim.turns;
    aim.fits = aim.fits && alone && picture.camera.zoom == 1 && picture.camera.pan == glm::dvec2(0);
    return aim;
}

double depthOrigin(const View& view) {
    return view.projection == Projection::perspective ? view.eyeDistance : view.radius;
}

template <typename T>
void append(std::vector<T>& list, const std::vector<T>& more) {
    list.insert(list.end(), more.begin(), more.end());
}

std::uint64_t nextNumber() {
    static std::atomic<std::uint64_t> last{0};
    return ++last;
}

/// Converts clipping planes, which count from the zoom target.
void placeClip(const Aimed& aim, Clip& clip) {
    clip.near += aim.depth;
    clip.far += aim.depth;
    if (aim.clipBefore) clip.near = *aim.clipBefore;
}

/// Automatic fog covers the visible depths, if these end in front of the centre.
void placeFog(const Representation& scene, RenderSettings& settings) {
    constexpr std::size_t kMany = 5'000'000;  // atoms
    Fog& fog = settings.effects.fog;
    if (fog.range != Fog::Range::automatic || settings.effects.clip.on() || scene.drawnAtoms > kMany) return;
    const auto range = frontRange(visibleDepths(drawnBalls(scene), settings.view), scene.radius);
    if (!range) return;
    fog.range = Fog::Range::given;
    fog.start = range->near;
    fog.end = range->far;
}

/// Whether the scene has a surface that gets caps where it is cut.
bool hasSolidSurface(const Representation& scene) {
    return needsCaps(scene, Clip{.near = 0}) &&
           std::ranges::any_of(scene.meshes, [](const MeshRun& mesh) { return mesh.surface && mesh.closed; });
}

/// The frame or model of a still picture.
Moment findMoment(const Molecule& molecule, const PictureDescription& picture) {
    const TrajectoryOptions& frames = picture.input.trajectory;
    Moment moment{frames.path.empty() ? std::max(picture.input.model, 1) : frames.frame, {}};
    if (frames.path.empty() || !titleMoves(picture.words.title)) return moment;
    const HeardMessages again;  // all messages were reported when the molecule was read
    const std::unique_ptr<Motion> motion = openMotion(frames, molecule);
    motion->positions(static_cast<std::size_t>(frames.frame - 1));
    moment.picoseconds = motion->time();
    return moment;
}

RenderSettings withView(RenderSettings settings, View view) {
    settings.view = std::move(view);
    return settings;
}

}  // namespace

Rebuild rebuildFor(const PictureDescription& before, const PictureDescription& after, CameraBy by) {
    const Facets parts = difference(before, after);
    const bool uncovers = by == CameraBy::hand
                              ? before.aim.uncover != after.aim.uncover
                              : parts && (uncoveredBy(before.aim) || uncoveredBy(after.aim) || before.aim.spares ||
                                          after.aim.spares);  // depends on the view
    Rebuild rebuild{.molecule = has(parts, Facet::input) || has(parts, Facet::frame)};
    // Maps and primitives decide whether all atoms may be hidden.
    rebuild.scene = has(parts, Facet::scene) || uncovers || before.drawsBeside() != after.drawsBeside();
    rebuild.maps = has(parts, Facet::map) || (after.maps.aroundFocus && has(parts, Facet::view));
    return rebuild;
}

void Drawing::prepare(const Molecule& molecule, const PictureDescription& description,
                      const std::optional<Bounds>& frame) {
    const Clock::time_point start = Clock::now();
    try {
        facts_ = facts_ ? facts_->moved(molecule) : ResidueFacts(molecule);
        if (!update(description, frame, nullptr)) return;
        finish(description_);
    } catch (...) {
        forget();  // an incomplete result must not count as complete
        throw;
    }
    run.sceneMs = millisecondsSince(start);
}

void Drawing::build(const Molecule& molecule, const PictureDescription& description,
                    const std::optional<Bounds>& frame) {
    facts_ = facts_ ? facts_->moved(molecule) : ResidueFacts(molecule);
    update(description, frame, nullptr);
}

void Drawing::buildMoving(const Molecule& first, const Molecule& now, const PictureDescription& description) {
    facts_ = ResidueFacts(first);
    update(description, {}, &now);
}

void Drawing::compose(const PictureDescription& picture) {
    setView(picture, picture.camera);
    finish(picture);
}

/// @returns whether anything differs
bool Drawing::update(const PictureDescription& description, const std::optional<Bounds>& frame, const Molecule* now) {
    if (by_ == CameraBy::description && facts_->molecule().atoms.empty() && !description.maps.files.empty()) {
        PictureDescription near = description;
        if (lookIntoCrystal(facts_->molecule(), near)) return update(near, frame, now);
    }
    const Facets parts = difference(description_, description);
    if (scene_ && parts == 0) return false;
    const Molecule& first = facts_->molecule();
    const Rebuild rebuild = rebuildFor(description_, description, by_);
    const bool another =
        !scene_ || rebuild.molecule || rebuild.scene || first.atoms.empty() || (cutsScene_ && has(parts, Facet::view));
    description_ = description;
    if (another) rebuildScene(frame, now);
    Aimed aim{.camera = cameraFor(description_.stereo, description_.camera)};
    if (description_.aim.center) aim.camera.center = scene_->center;
    const bool follow = description_.maps.aroundFocus && !description_.maps.files.empty();
    const auto drawMaps = [&] {
        if (!another && !rebuild.maps) return;
        maps_ = buildMapLayers(first, description_, scene_->center, {aim.camera, radius_});
        number_ = nextNumber();
    };
    // The camera frames the maps, unless they are drawn around its focus.
    if (!follow) drawMaps();
    if (by_ == CameraBy::description) {
        const double framed = std::max(radius_, follow ? 0 : maps_.frame);
        aim =
            aimed(aim.camera, sharedAim(first, description_, frame), *facts_,
                  {*scene_, framed, follow ? nullptr : &maps_.shown}, eyeSize(description_.stereo, description_.size));
        if (description_.given.contains("scale")) {  // also of a close-up
            aim.camera.scale = description_.camera.scale;
            aim.camera.zoom = description_.camera.zoom;
        }
    }
    if (follow) drawMaps();
    run = {};
    run.zoom = aim.camera.zoom;
    setView(description_, aim.camera);
    std::optional<SceneView> seen;
    if (by_ == CameraBy::description) {
        // Captures include the bake.
        if (description_.capture.empty()) settings.occlusion.cache = cacheFolder(description_.input.cache, "occlusion");
        seen = applySceneFile();
    }
    if (seen) {
        dropOutside(*scene_, *seen);
        dropOutside(maps_.shown, *seen);
    }
    placeClip(aim, settings.effects.clip);
    uncoverTarget(aim.clipNear);
    return true;
}

/// @param now  the positions of moving atoms; null: they do not move
void Drawing::rebuildScene(const std::optional<Bounds>& frame, const Molecule* now) {
    moving_.reset();
    PictureDescription picture = description_;
    if (kept_) picture.camera.center = kept_->center;
    if (now) {
        moving_ = std::make_shared<MovingPicture>(facts_->molecule(), picture,
                                                  recolor);  // with separate facts: it may move to another thread
        scene_ = moving_->moved(*now);
        radius_ = moving_->radius();
        facts_ = facts_->moved(*now);
    } else if (showsLaterFrame(description_)) {
        Molecule first = facts_->molecule();
        const HeardMessages again;  // all messages were reported when the molecule was read
        movePositions(first, openMotion(description_.input.trajectory, first)->positions(0));
        MovingScene moving = buildMovingScene(first, picture);
        radius_ = moving.scene().radius;
        moving.move(facts_->molecule());
        scene_ = moving.scene();
    } else {
        scene_ = buildScene(*facts_, picture, frame, by_ == CameraBy::hand ? Emptiness::taken : Emptiness::refused);
        radius_ = scene_->radius;
    }
    reframed_ = kept_ && kept_->radius != radius_;
    if (kept_) radius_ = kept_->radius;
    if (!now) {
        if (recolor) recolor(*scene_);
        colorByMap(*facts_, description_, *scene_);
    }
    sceneNumber_ = nextNumber();
    ++counts_.scenes;
}

RenderSettings Drawing::settingsFor(const PictureDescription& picture, const Camera& camera, const Size& size) const {
    RenderSettings result = makeSettings(picture, cameraFor(picture.stereo, camera), size, radius());
    if (scene_ && facts_ && tooManyToOcclude(*scene_, facts_->molecule())) result.occlusion.directions = 0;
    if (reach() > result.view.radius) reachTo(result.view, reach());
    // With more shapes it would slow down a camera moved by hand: then finish() places it, in files.
    constexpr std::size_t kManyPerFrame = 30'000;
    if (by_ == CameraBy::hand && scene_ && scene_->sphereLooks.size() + scene_->triangles.size() <= kManyPerFrame)
        placeFog(*scene_, result);
    return result;
}

void Drawing::setView(const PictureDescription& picture, const Camera& camera) {
    stereo_ = picture.stereo;
    size_ = picture.size;
    const Size eye = eyeSize(stereo_, size_);
    settings = settingsFor(picture, camera, eye);
    depthShift_ = depthOrigin(settings.view) -
                  depthOrigin(makeView(cameraFor(picture.stereo, camera), radius(), eye.width, eye.height));
}

void Drawing::takeCamera(Camera& camera) {
    double radius = this->radius();
    const bool eye = camera.eyeDistance.has_value();
    camera = relativeCamera(camera, radius);
    if (eye) radius_ = radius;
}

/// Applies the scene file's background, camera and clipping planes, unless options set them.
/// @returns the view of its camera, if that is applied
std::optional<SceneView> Drawing::applySceneFile() {
    cutsScene_ = seenByScene_ = false;
    const Molecule& molecule = facts_->molecule();
    if (!molecule.guide) return std::nullopt;
    const bool standard =
        !description_.given.contains("background") && description_.background == PictureDescription{}.background;
    if (molecule.guide->background && standard) settings.background = *molecule.guide->background;
    const SceneCamera* camera = sceneCamera(molecule, description_);
    seenByScene_ = camera != nullptr;
    if (!camera) return std::nullopt;
    const bool ortho = description_.given.contains("projection") && !stereo_.on() &&
                       description_.camera.projection == Projection::orthographic;
    const Size eye = eyeSize(stereo_, size_);
    const SceneView seen = makeView(*camera, description_.camera, ortho, reach(), eye.width, eye.height);
    settings.view = seen.view;
    Clip& clip = settings.effects.clip;
    clip.near = std::max(clip.near, seen.clip.near);
    clip.far = std::min(clip.far, seen.clip.far);
    cutsScene_ = seen.clip.on();
    return seen;
}

/// Removes what hides the target. Uses a clipping plane instead for assemblies, whose copies share primitives, for
/// movies, which rotate around the target, and for surfaces, which would be hollow.
void Drawing::uncoverTarget(std::optional<double> plane) {
    const Aim& aim = description_.aim;
    const std::optional<Selection>& target = by_ == CameraBy::hand ? aim.uncover : uncoveredBy(aim);
    if (!target) return;
    double& near = settings.effects.clip.near;
    const bool solid = by_ == CameraBy::description && hasSolidSurface(*scene_);
    if (plane && (aim.turns || solid || !scene_->copies.transforms.empty())) near = std::max(near, *plane);
    if (aim.turns || solid) return;
    run.uncovers = target->text;
    run.uncovered = uncover(*scene_, selectAtoms(*facts_, *target), settings.view, near);
}

/// Lens, words and warnings of a picture with the current settings.
void Drawing::finish(const PictureDescription& picture) {
    const Molecule& molecule = facts_->molecule();
    focusLens(molecule, picture, scene_->center, settings);
    run.clip = clipText(settings.effects.clip);
    placeFog(*scene_, settings);
    moment = findMoment(molecule, picture);
    warnings = molecule.guide ? molecule.guide->warnings : std::vector<std::string>();
    append(warnings, scene_->warnings);
    append(warnings, maps_.warnings);
    if (stereo_.on() && picture.camera.projection == Projection::orthographic && picture.given.contains("projection"))
        warnings.push_back("--stereo is drawn in perspective, since two orthographic views show no depth");
    // --uncover implies removal; a close-up that also uncovers has to report it.
    const Uncovered& gone = run.uncovered;
    if (by_ == CameraBy::description && !picture.aim.uncover && !run.uncovers.empty() &&
        gone.spheres + gone.cylinders + gone.triangles > 0)
        warnings.push_back("what hides " + run.uncovers + " is left out (--uncover off keeps it)");
    placePictureWords(picture);
    for (std::string& idle : idleOptions(picture, *scene_, settings.effects, scene_->radius))
        warnings.push_back(std::move(idle));
    makeRoom(picture);
    if (by_ == CameraBy::description && picture.aim.spares) spare(*picture.aim.spares);
    setStats();
}

PlacedWords Drawing::placeWords(const Words& asked, WordsOfHidden hidden) const {
    PlacedWords placed = app::placeWords(asked, *facts_, *scene_, hidden);
    addLabels(maps_.labels, scene_->center, placed);
    if (asked.legend) append(placed.legends, maps_.shown.legends);
    if (asked.axes && description_.cell) placed.axes = makeAxes(cellEdges(facts_->molecule().file));
    placed.title = filledTitle(placed.title, moment);
    if (placed.legends.empty() || asked.legendTitle.empty()) return placed;
    const auto scale = std::ranges::find_if(placed.legends, [](const Legend& legend) { return legend.stops > 0; });
    (scale == placed.legends.end() ? placed.legends.front() : *scale).title = asked.legendTitle;
    return placed;
}

/// Omits labels of atoms that uncovering removed.
void Drawing::placePictureWords(const PictureDescription& picture) {
    words = {};
    wordSize_ = picture.words.size;
    wordColor_ = picture.words.color;
    if (picture.debug != DebugView::none) return;
    const bool removed = by_ == CameraBy::hand || !run.uncovers.empty();
    words = placeWords(picture.words, removed ? WordsOfHidden::leftOut : WordsOfHidden::refused);
    if (words.leftOut.empty()) return;
    const std::size_t others = words.leftOut.size() - 1;
    warnings.push_back("no label at " + words.leftOut.front() +
                       (others ? " and " + std::to_string(others) + " more" : "") +
                       ": none of its atoms is drawn, since they hide " + run.uncovers + " (--uncover off)");
}

/// Moves the molecule clear of the words around it, unless the view shows a part of it.
void Drawing::makeRoom(const PictureDescription& picture) {
    const Camera& camera = picture.camera;
    const bool placed = picture.aim.placed || picture.aim.center || camera.center || camera.scale;
    if (!words.any() || seenByScene_ || placed || picture.aim.zoomTo) return;
    constexpr std::size_t kMany = 200000;  // spheres and vertices; beyond, their bounding sphere is nearly as good
    View& view = settings.view;
    std::vector<glm::dvec4> balls{{0, 0, 0, view.radius}};
    if (!picture.aim.turns && scene_->drawnAtoms + scene_->meshVertices.size() < kMany) balls = drawnBalls(*scene_);
    const View beside = WordPainter().besideWords(view, words, picture.words.size, balls, camera.zoom);
    run.zoom *= beside.pixelsPerAngstrom / view.pixelsPerAngstrom;
    view = beside;
}

void Drawing::setStats() {
    const Molecule& molecule = facts_->molecule();
    run.atomsRead = molecule.atoms.size();
    run.bondsKnown = molecule.bonds.size();
    run.center = scene_->center;
    if (stereo_.on()) run.stereo = app::placed(stereo_, settings.view);
    run.atomsDrawn = scene_->drawnAtoms;
    run.bondsDrawn = scene_->drawnBonds;
    run.triangles = scene_->triangles.size();
    run.vertices = scene_->meshVertices.size();
    run.legends = scene_->legends;
    append(run.legends, maps_.shown.legends);
    run.warnings = molecule.warnings;
    append(run.warnings, warnings);
}

// --- atoms that move

void Drawing::startMoving(const Molecule& first) {
    moving_ = std::make_shared<MovingPicture>(first, description_, recolor);
}

void Drawing::moveTo(const Molecule& molecule) {
    takeMoved(molecule, moving_->moved(molecule));
    words = placeWords(description_.words, WordsOfHidden::refused);
    reachTo(settings.view, reach());
}

void Drawing::takeMoved(const Molecule& molecule, Representation scene) {
    facts_ = facts_->moved(molecule);
    scene_ = std::move(scene);
    number_ = nextNumber();
}

Drawing Drawing::copy() const {
    Drawing other = *this;
    other.facts_.reset();  // they are computed on demand, by one thread
    other.moving_.reset();
    return other;
}

Representation Drawing::joinedScene() const { return withMaps(*scene_, maps_); }

// --- clipping planes

/// Cuts the scene itself, so that the renderer clips nothing.
void Drawing::spare(const Selection& spared) {
    Clip& clip = settings.effects.clip;
    spareClip_ = clip;
    if (!cutScene(*scene_, settings.view, clip, selectAtoms(*facts_, spared))) {
        warnings.push_back("--clip-spare changes nothing: the copies of an assembly are cut alike");
        return;
    }
    clip.near = -Clip::kNone;
    clip.far = Clip::kNone;
    number_ = nextNumber();
}

// --- on a canvas

void Drawing::show(Canvas& canvas) {
    if (canvas.scene == number_) return;
    canvas.scene = 0;
    const bool colors = canvas.renderer.setScene(joinedScene());
    canvas.scene = number_;
    ++counts_.uploads;
    counts_.colors += colors ? 1 : 0;
}

void Drawing::handOver(Canvas& canvas) {
    canvas.scene = 0;
    canvas.renderer.setScene(withMaps(std::move(*scene_), maps_));
    canvas.scene = number_;
    scene_.reset();
    ++counts_.uploads;
}

Picture Drawing::draw(Canvas& canvas, std::vector<std::string>* said) {
    show(canvas);
    return drawAs(settings, canvas.renderer, nullptr, said);
}

CodedPicture Drawing::drawCoded(Canvas& canvas, bool alpha, std::vector<std::string>* said) {
    if (words.any() || stereo_.on()) return coded(draw(canvas, said), alpha);
    show(canvas);
    return canvas.renderer.renderCoded(settings, alpha);
}

void Drawing::startCoded(Canvas& canvas, bool alpha) {
    show(canvas);
    canvas.renderer.startCoded(settings, alpha);
}

LayerPicture Drawing::layers(Renderer& renderer) const {
    LayerPicture layers =
        stereo_.both()
            ? joinEyes(stereo_, size_, renderer.layersOfEyes(withView(settings, eyesView(settings.view, stereo_))))
            : renderer.layers(withView(settings, oneEyeView(settings.view, stereo_)));
    if (depthShift_ != 0)  // keeps the background's infinity
        for (float& z : layers.z) z = static_cast<float>(static_cast<double>(z) - depthShift_);
    return layers;
}

Picture Drawing::drawAs(const RenderSettings& drawn, Renderer& renderer, WordMemory* memory,
                        std::vector<std::string>* said) const {
    std::vector<std::string> ofWords;
    Picture picture;
    if (stereo_.both()) {
        WordMemory own;  // both eyes have a label on the same side of its atom
        RenderSettings eye = withView(drawn, eyesView(drawn.view, stereo_));
        std::array<Picture, 2> eyes = renderer.renderEyes(eye);
        for (std::size_t i = 0; i < eyes.size(); ++i) {
            if (i == 1) eye.view = otherView(eye.view);
            ofWords = addWords(eye, eyes[i], memory ? memory : &own);
        }
        picture = joinEyes(stereo_, size_, eyes);
    } else {
        const RenderSettings eye = withView(drawn, oneEyeView(drawn.view, stereo_));
        picture = renderer.render(eye);
        ofWords = addWords(eye, picture, memory);
    }
    if (said) append(*said, ofWords);
    return picture;
}

PictureDescription Drawing::placed() const {
    PictureDescription placed = description_;
    placed.camera = absoluteCamera(settings.view, description_.camera.fovDegrees, run.center);
    placed.effects.clip = description_.aim.spares ? spareClip_ : settings.effects.clip;
    placed.aim = {};
    placed.aim.spares = description_.aim.spares;
    if (!run.uncovers.empty()) placed.aim.uncover = uncoveredBy(description_.aim);
    return placed;
}

std::vector<std::string> Drawing::addWords(const RenderSettings& drawn, Picture& picture, WordMemory* memory) const {
    if (!words.any()) return {};
    return WordPainter().paint(words, drawn.view, wordSize_, wordColor_, drawn.background, picture, drawn.effects.clip,
                               memory);
}

}  // namespace nacre::app
