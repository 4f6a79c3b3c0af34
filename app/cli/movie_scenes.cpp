#include "app/cli/movie_scenes.h"

#include <algorithm>
#include <cmath>

#include "app/download/load_map.h"
#include "app/download/load_molecule.h"
#include "app/drawing/complete.h"
#include "app/files/messages.h"
#include "app/input/input_files.h"
#include "app/input/read_input.h"
#include "app/movie/movie_file.h"
#include "app/picture/input_names.h"
#include "app/picture/saved_view.h"
#include "engine/error.h"
#include "engine/molecule/trajectory/morph.h"
#include "engine/scene/view/shared_frame.h"

namespace nacre::app {
namespace {

/// Whether two pictures differ only in the camera and clipping planes.
bool sameLook(const PictureDescription& a, PictureDescription b) {
    b.effects.clip.near = a.effects.clip.near;
    b.effects.clip.far = a.effects.clip.far;
    constexpr Facets kSeen = Facet::scene | Facet::map | Facet::shading | Facet::occlusion | Facet::annotation;
    const Facets parts = difference(a, b);
    return (parts & kSeen) == 0 && !(a.maps.aroundFocus && has(parts, Facet::view));
}

std::string joinPaths(const InputOptions& input) {
    std::string paths = resolveInputPath(input);
    for (const FurtherInput& further : input.further) paths += ", " + resolveInputPath(furtherInput(input, further));
    return paths;
}

/// Views that name an input must all name the same one. @throws Error
void checkSameInput(const MovieOptions& options, const InputOptions& named) {
    const InputOptions& input = options.picture.input;
    const std::string file = named.namedBy, cannot = "cannot join views";
    if (input.namedBy.empty() || named.path.empty()) return;  // INPUT itself names it
    if (joinPaths(named) != joinPaths(input) || (options.models == MovieModels::one && named.model != input.model))
        throw Error(cannot, file, "it is of another molecule than the first: " + joinPaths(named));
    if (!isGiven(options, "trajectory") && resolveTrajectoryPath(named) != input.trajectory.path)
        throw Error(cannot, file, "it is of another trajectory than the first: " + resolveTrajectoryPath(named));
}

/// A key view as in `nacre render --view`, with the options given. @throws Error
PictureDescription keyOptions(const MovieOptions& options, const std::string& file) {
    PictureDescription key;
    applySavedView(file, key);
    key.input.namedBy = file;
    checkSameInput(options, key.input);
    setOptions(options.given, key);
    key.input = options.picture.input;
    takeSeveral(key);
    return key;
}

/// Moves planes from one view to the next. A plane that is off in one view comes from, or goes, just outside the
/// molecule.
void moveClip(Clip& clip, const Clip& a, const Clip& b, double share, double radius) {
    const auto way = [&](double from, double to, double outside) {
        if (from == to) return from;
        const auto place = [&](double depth) { return std::isfinite(depth) ? depth : outside; };
        return place(from) + (place(to) - place(from)) * share;
    };
    clip.near = way(a.near, b.near, -radius);
    clip.far = way(a.far, b.far, radius);
}

}  // namespace

Picture mixed(Picture a, const Picture& b, float share) {
    for (std::size_t i = 0; i < a.rgba.size(); ++i) a.rgba[i] += (b.rgba[i] - a.rgba[i]) * share;
    return a;
}

bool isTransparent(const MovieOptions& options) {
    if (options.views.empty()) return options.picture.background[3] < 1.0f;
    return std::any_of(options.views.begin(), options.views.end(),
                       [&](const std::string& file) { return keyOptions(options, file).background[3] < 1.0f; });
}

MovieScenes::MovieScenes(const MovieOptions& options, Progress& progress) : options_(options), progress_(progress) {
    progress_.begin("reading");
    InputOptions input = options.picture.input;
    const bool laid = input.trajectory.fit || input.trajectory.smooth != 1;
    const bool one = options.models == MovieModels::one, morph = options.models == MovieModels::morph;
    molecules_ = one ? input.model : 1;
    if (morph) {
        layMorph(input);
    } else if (!one && input.conformations) {
        molecule_ = loadMolecule(input, downloadProgress(progress_));
        models_ = molecule_.others.size() + 1;
        layModels(input);
    } else if (!one && input.trajectory.path.empty()) {
        file_ = openModels(input, downloadProgress(progress_));
        models_ = static_cast<std::uint64_t>(file_->count());
        molecule_ = file_->first();
        if (laid) layModels(input);
    } else {
        InputOptions still = input;
        if (!one) {  // the trajectory is opened below
            still.trajectory = {};
            still.alone = true;
        }
        molecule_ = loadMolecule(still, downloadProgress(progress_));
        if (!one) {
            motion_ = openMotion(input.trajectory, molecule_);
            models_ = motion_->frames();
        }
    }
    if (options.models == MovieModels::sequence) takeRange(input.path);
    loadMaps(options.picture, downloadProgress(progress_));
    frames_ = morph ? models_ : countFrames(options, models_);
    if (frames_ > kMostMovieFrames)
        throw Error("movie too long", input.path, "more than " + std::to_string(kMostMovieFrames) + " frames");
    progress_.begin("building the scene");
    if (motion_) movePositions(molecule_, motion_->positions(0));
    if (!options.views.empty()) {
        addKeys();
        return;
    }
    addLook(options.picture);
    const Look& look = ready(0, molecules_);
    first_ = look.drawing.settings.view;
    firstClip_ = look.drawing.settings.effects.clip;
    center_ = look.drawing.run.center;
}

MovieScenes::~MovieScenes() = default;

/// Applies --frames to the number of models. @throws Error if the range ends after the last
void MovieScenes::takeRange(const std::string& path) {
    const auto all = static_cast<std::int64_t>(models_);
    const FrameRange& range = options_.range;
    const std::int64_t last = range.last == 0 ? all : range.last;
    if (range.first > all || last > all)
        throw Error(
            "cannot show frames", path,
            "there is no frame " + std::to_string(std::max(range.first, last)) + "; it has " + std::to_string(all));
    models_ = static_cast<std::uint64_t>((last - range.first) / range.step + 1);
}

/// Models as the frames of a trajectory, to be fitted and smoothed.
void MovieScenes::layModels(const InputOptions& input) {
    auto models = trajectoryOfModels(std::make_shared<const Molecule>(molecule_), 1, true);
    if (!models)
        throw Error("cannot fit or smooth models", input.path,
                    molecule_.othersMissing.empty() ? differenceOfModels(molecule_) : molecule_.othersMissing);
    motion_ = std::make_unique<Motion>(std::move(models), molecule_, motionOptions(input.trajectory, molecule_));
}

/// The conformations between the models: one per frame of the movie.
void MovieScenes::layMorph(const InputOptions& input) {
    molecule_ = loadMolecule(input, downloadProgress(progress_));
    const std::uint64_t keys = std::max<std::uint64_t>(molecule_.others.size() + 1, 2);
    models_ = countFrames(options_, keys);
    motion_ = std::make_unique<Motion>(morphOfModels(std::make_shared<const Molecule>(molecule_), 1,
                                                     morphPlaces(options_, models_, keys), options_.loop, input.path),
                                       molecule_, motionOptions(input.trajectory, molecule_));
}

void MovieScenes::addLook(const PictureDescription& options) {
    looks_.emplace_back();
    looks_.back().options = options;
    looks_.back().options.aim.turns = true;
}

void MovieScenes::addKeys() {
    std::vector<Lens> lenses;
    for (const std::string& file : options_.views) {
        PictureDescription options = keyOptions(options_, file);
        const auto same = std::find_if(looks_.begin(), looks_.end(),
                                       [&](const Look& look) { return sameLook(look.options, options); });
        Key key{static_cast<std::size_t>(same - looks_.begin()), {}, {}};
        Drawing drawing;
        drawing.prepare(molecule_, options);
        key.view = drawing.settings.view;
        key.clip = drawing.settings.effects.clip;
        lenses.push_back(makeLens(key.view, drawing.run.center));
        if (lenses.back().projection != lenses.front().projection)
            throw Error("cannot join views", file, "it is not of the same --projection as the first");
        if (same == looks_.end()) addLook(options);
        keys_.push_back(key);
    }
    if (severalModels() && looks_.size() > 1)
        throw Error("cannot join views", options_.views.front(),
                    "with --models, views may differ in their cameras alone");
    path_.emplace(std::move(lenses), options_.loop);
    forgetWords();
    ready(keys_.front().look, molecules_);
}

/// A look with its scene on a renderer.
MovieScenes::Look& MovieScenes::ready(std::size_t number, int model) {
    Look& look = looks_[number];
    if (look.canvas && look.model == model) return look;
    if (look.drawing.moving()) {
        moveTo(look, model);
        return look;
    }
    const bool first = look.model == 0;
    if (motion_) movePositions(molecule_, motion_->positions(static_cast<std::size_t>(model - 1)));
    if (molecules_ != model && !motion_) {
        molecule_ = file_->read(model);
        molecules_ = model;
    }
    const std::optional<Bounds> frame = file_ && !motion_ ? findFrame(look) : std::nullopt;
    look.framed = frame.has_value();
    look.drawing.forget();
    if (severalModels() && !motion_) look.options.input.model = model;  // for titles
    look.drawing.prepare(molecule_, look.options, frame);
    if (first)
        for (const std::string& warning : look.drawing.warnings) sayWarning(warning);
    look.model = model;
    look.drawing.settings.occlusion.onProgress = [this](double share) {
        if (onBake) onBake(share);
    };
    if (severalModels()) setMovingOcclusion(look.drawing.settings.occlusion);
    if (motion_ && !look.options.look.ownFrame) look.drawing.startMoving(molecule_);
    if (!look.canvas) look.canvas = std::make_unique<Canvas>(look.options.device);
    options_.sweep ? look.drawing.show(*look.canvas) : look.drawing.handOver(*look.canvas);
    return look;
}

/// Occlusion that was asked for, or that a view sets, is as in a picture.
void MovieScenes::setMovingOcclusion(OcclusionSettings& occlusion) const {
    occlusion.cache.clear();  // temporary models are not worth disk space
    occlusion.once = frames_ <= models_;
    const OcclusionSettings standard;
    occlusion.moving = occlusion.directions == standard.directions && occlusion.detail == standard.detail &&
                       !isGiven(options_, "occlusion") && !isGiven(options_, "occlusion-detail");
}

/// The shared bounds of all models. The first model knows the others' positions; but the default style depends on the
/// model, and each style has its own bounds.
std::optional<Bounds> MovieScenes::findFrame(Look& look) const {
    const DrawnAtomsOptions& drawn = look.options.drawn;
    RepresentationOptions shared = look.options.look;
    if (!shared.style) shared.style = makeAppearance(molecule_, drawnAtoms(molecule_, drawn), shared).style;
    const auto known = look.frames.find(*shared.style);
    if (known != look.frames.end()) return known->second;
    return look.frames[*shared.style] = sharedFrame(file_->first(), drawn, shared);
}

/// Only positions change: selection and colours are fixed.
void MovieScenes::moveTo(Look& look, int frame) {
    movePositions(molecule_, motion_->positions(static_cast<std::size_t>(frame - 1)));
    if (!saidTorn_) saidTorn_ = sayTorn(*motion_, look.options.input.trajectory.path);
    look.model = frame;
    look.drawing.moment = {frame, motion_->time()};
    look.drawing.moveTo(molecule_);
    look.drawing.handOver(*look.canvas);
}

/// Unchanged parts of the scene are kept.
void MovieScenes::sweepTo(Look& look, double time) {
    std::vector<MapLevel>& levels = look.options.maps.levels;
    levels.resize(std::max<std::size_t>(levels.size(), 1));
    levels.front() = levelAt(options_, time);
    look.drawing.prepare(molecule_, look.options);
    look.drawing.show(*look.canvas);
}

/// Renderers of other looks than these two release their memory.
void MovieScenes::letGo(std::size_t a, std::size_t b) {
    for (std::size_t i = 0; i < looks_.size(); ++i)
        if (i != a && i != b) looks_[i].canvas.reset();
}

/// Words are placed as in a single picture. Looks with the same words share a memory: during a cross-fade each word has
/// one position.
void MovieScenes::forgetWords() {
    for (Look& look : looks_) {
        const auto same = std::find_if(looks_.begin(), looks_.end(),
                                       [&](const Look& other) { return other.options.words == look.options.words; });
        look.wordMemory = &*same == &look ? std::make_shared<WordMemory>() : same->wordMemory;
    }
}

Picture MovieScenes::drawKeys(double place, int model) {
    const auto from = std::min(static_cast<std::size_t>(place), path_->stretches() - 1);
    double share = place - static_cast<double>(from);
    // At a key view, the picture of that view exactly; from there on, words follow their atoms.
    if (from != stretch_ || share == 0 || share == 1) forgetWords();
    stretch_ = from;
    if (options_.easing.value_or(Easing::smooth) == Easing::stops) share = eased(Easing::smooth, share);
    const Key &a = keys_[from], &b = keys_[(from + 1) % keys_.size()];
    letGo(a.look, b.look);
    const auto draw = [&](std::size_t number) {
        Look& look = ready(number, model);
        RenderSettings settings = look.drawing.settings;
        Clip& clip = settings.effects.clip;
        // At a key view, exactly the numbers of that view.
        if (share == 0 && number == a.look) {
            settings.view = a.view;
            clip = a.clip;
        } else if (share == 1 && number == b.look) {
            settings.view = b.view;
            clip = b.clip;
        } else {
            settings.view =
                viewThrough(path_->at(static_cast<double>(from) + share), settings.view, look.drawing.run.center);
            moveClip(clip, a.clip, b.clip, share, settings.view.radius);
        }
        return look.drawing.drawAs(settings, look.canvas->renderer, look.wordMemory.get());
    };
    if (a.look == b.look || share == 0) return draw(a.look);
    if (share == 1) return draw(b.look);
    return mixed(draw(a.look), draw(b.look), static_cast<float>(eased(Easing::smooth, share)));
}

int MovieScenes::modelAt(std::uint64_t frame) const {
    if (!severalModels()) return molecules_;
    return static_cast<int>(options_.range.first +
                            static_cast<std::int64_t>(frame * models_ / frames_) * options_.range.step);
}

std::optional<int> MovieScenes::shownModel(std::uint64_t frame) const {
    return severalModels() ? std::optional(modelAt(frame)) : std::nullopt;
}

Picture MovieScenes::draw(std::uint64_t frame) {
    if (frame != next_) forgetWords();
    next_ = frame + 1;
    const double time = frameTime(options_, frame, frames_);
    const int model = modelAt(frame);
    if (path_) {
        const Easing easing = options_.easing.value_or(options_.loop ? Easing::linear : Easing::smooth);
        return drawKeys(eased(easing, time) * static_cast<double>(path_->stretches()), model);
    }
    Look& look = ready(0, model);
    if (options_.sweep) sweepTo(look, time);
    RenderSettings settings = look.drawing.settings;
    const glm::dvec3 center = look.drawing.run.center;
    View& view = settings.view;
    // All models use the camera aimed at the first, unless each has its own.
    const bool aimed = options_.picture.aim.any() && file_ && !motion_ && model != 1;
    const bool elsewhere = center != center_ || view.pixelsPerAngstrom != first_.pixelsPerAngstrom;
    if (!look.options.look.ownFrame && (aimed || (elsewhere && !look.framed))) {
        view = viewThrough(makeLens(first_, center_), view, center);
        settings.effects.clip = firstClip_;
    }
    view = viewAt(options_, view, time);
    return look.drawing.drawAs(settings, look.canvas->renderer, look.wordMemory.get());
}

}  // namespace nacre::app
