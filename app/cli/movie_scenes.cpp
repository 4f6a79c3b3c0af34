#include "app/cli/movie_scenes.h"

#include <algorithm>
#include <cmath>

#include "app/cli/saved_options.h"
#include "app/download/load_molecule.h"
#include "app/movie/movie_file.h"
#include "app/shared/messages.h"
#include "app/shared/molecules.h"
#include "app/shared/saved_view.h"
#include "app/shared/view_input.h"
#include "engine/error.h"

namespace nacre::app {
namespace {

/// Whether two pictures show the same but from elsewhere.
bool sameLook(const RenderOptions& a, const RenderOptions& b) {
    Effects effects = b.effects;  // clipping planes move
    effects.clip.near = a.effects.clip.near;
    effects.clip.far = a.effects.clip.far;
    return a.effects == effects && a.look == b.look && a.drawn == b.drawn && a.lighting == b.lighting &&
           a.background == b.background && a.words == b.words && a.occlusion.directions == b.occlusion.directions;
}

/// The options as a key view changes them. @throws Error if it is of another molecule
RenderOptions keyOptions(const RenderOptions& options, const std::string& file) {
    RenderOptions key = options;
    const SavedView view = readSavedView(file);
    applySavedView(view, key);
    key.aim.turns = true;
    InputOptions named = key.savedInput;
    named.namedBy = file;
    if (!named.path.empty() && (filePathOf(named) != filePathOf(options.input) || named.model != options.input.model))
        throw Error("cannot join views", file, "it is of another molecule than the first: " + filePathOf(named));
    return key;
}

/// Planes on their way from one view to the next. One that is nowhere comes from, or goes, just outside the molecule.
void moveClip(Clip& clip, const Clip& a, const Clip& b, double share, double radius) {
    const auto way = [&](double from, double to, double outside) {
        if (from == to) return from;
        const auto place = [&](double depth) { return std::isfinite(depth) ? depth : outside; };
        return place(from) + (place(to) - place(from)) * share;
    };
    clip.near = way(a.near, b.near, -radius);
    clip.far = way(a.far, b.far, radius);
}

Picture mixed(Picture a, const Picture& b, float share) {
    for (std::size_t i = 0; i < a.rgba.size(); ++i) a.rgba[i] += (b.rgba[i] - a.rgba[i]) * share;
    return a;
}

}  // namespace

bool isTransparent(const MovieOptions& options) {
    if (options.views.empty()) return options.picture.background[3] < 1.0f;
    return std::any_of(options.views.begin(), options.views.end(),
                       [&](const std::string& file) { return keyOptions(options.picture, file).background[3] < 1.0f; });
}

MovieScenes::MovieScenes(const MovieOptions& options, Progress& progress) : options_(options), progress_(progress) {
    progress_.begin("reading");
    InputOptions input = options.picture.input;
    const bool laid = input.trajectory.fit || input.trajectory.smooth != 1;
    if (options.models && laid) input.alone = false;  // all their places at once
    molecules_ = input.model;
    molecule_ = loadMolecule(input, downloadProgress(progress_));
    if (options.models && !input.trajectory.path.empty()) {
        motion_ = openMotion(input.trajectory, molecule_);
        models_ = motion_->frames();
        molecules_ = 1;
        movePositions(molecule_, motion_->positions(0));
    } else if (options.models) {
        const FileSummary& file = molecule_.file;
        models_ =
            static_cast<std::uint64_t>(std::max<std::int64_t>({file.models.value_or(1), file.records.value_or(1), 1}));
        if (models_ < 2) throw Error("cannot show models", input.path, "it has one alone");
        if (laid) layModels(input);
    }
    frames_ = framesOf(options, models_);
    if (frames_ > kMostMovieFrames)
        throw Error("movie too long", input.path, "more than " + std::to_string(kMostMovieFrames) + " frames");
    progress_.begin("building the scene");
    if (!options.views.empty()) {
        addKeys();
        return;
    }
    addLook(options.picture);
    const Look& look = ready(0, molecules_);
    first_ = look.prepared->settings.view;
    center_ = look.prepared->run.center;
}

MovieScenes::~MovieScenes() = default;

/// Models as the frames of a trajectory: as they are to be fitted and smoothed, all at once.
void MovieScenes::layModels(const InputOptions& input) {
    auto models = trajectoryOfModels(std::make_shared<const Molecule>(molecule_), input.model);
    if (!models)
        throw Error(
            "cannot fit or smooth models", input.path,
            molecule_.othersMissing.empty() ? "their atoms differ from one to the next" : molecule_.othersMissing);
    models_ = models->frames();
    motion_ = std::make_unique<Motion>(std::move(models), molecule_, motionOptions(input.trajectory, molecule_));
    molecules_ = 1;
    movePositions(molecule_, motion_->positions(0));
}

void MovieScenes::addLook(const RenderOptions& options) {
    looks_.emplace_back();
    looks_.back().options = options;
    looks_.back().options.aim.turns = true;
}

void MovieScenes::addKeys() {
    std::vector<Lens> lenses;
    for (const std::string& file : options_.views) {
        RenderOptions options = keyOptions(options_.picture, file);
        const auto same = std::find_if(looks_.begin(), looks_.end(),
                                       [&](const Look& look) { return sameLook(look.options, options); });
        Key key{static_cast<std::size_t>(same - looks_.begin()), {}, options.effects.clip};
        const PreparedPicture prepared = preparePicture(molecule_, options);
        key.view = prepared.settings.view;
        lenses.push_back(lensOf(key.view, prepared.run.center));
        if (lenses.back().projection != lenses.front().projection)
            throw Error("cannot join views", file, "it is not of the same --projection as the first");
        if (same == looks_.end()) addLook(options);
        keys_.push_back(key);
    }
    if (options_.models && looks_.size() > 1)
        throw Error("cannot join views", options_.views.front(),
                    "with --models, views may differ in their cameras alone");
    path_.emplace(std::move(lenses), options_.loop);
    ready(keys_.front().look, molecules_);
}

/// A look with its scene on a renderer.
MovieScenes::Look& MovieScenes::ready(std::size_t number, int model) {
    Look& look = looks_[number];
    if (look.renderer && look.model == model) return look;
    if (motion_ && look.moving) {
        moveTo(look, model);
        return look;
    }
    if (molecules_ != model && !motion_) {
        InputOptions input = options_.picture.input;
        input.model = model;
        input.alone = true;  // the first one's camera is that of all
        molecule_ = loadMolecule(input);
        molecules_ = model;
    }
    const bool first = !look.prepared;
    look.prepared = preparePicture(molecule_, look.options);
    if (first)
        for (const std::string& warning : look.prepared->scene.warnings) sayWarning(warning);
    look.model = model;
    look.prepared->settings.occlusion.onProgress = [this](double share) {
        if (onBake) onBake(share);
    };
    // Occlusion of models that come and go is not worth room on the disk.
    if (options_.models) look.prepared->settings.occlusion.cache.clear();
    if (motion_)
        look.moving.emplace(movingSceneOf(molecule_, look.options.input.path, look.options.drawn, look.options.look));
    if (!look.renderer) look.renderer = std::make_unique<Renderer>(look.options.device);
    look.renderer->setScene(std::move(look.prepared->scene));
    return look;
}

/// Only positions change: what is drawn, and in what colours, is settled.
void MovieScenes::moveTo(Look& look, int frame) {
    movePositions(molecule_, motion_->positions(static_cast<std::size_t>(frame - 1)));
    look.moving->move(molecule_);
    look.model = frame;
    look.renderer->setScene(look.moving->scene());
    look.prepared->words = placeWords(look.options.words, molecule_, look.moving->scene());
    reachTo(look.prepared->settings.view, look.moving->scene().radius);
}

/// Renderers of other looks than these two hold no memory.
void MovieScenes::letGo(std::size_t a, std::size_t b) {
    for (std::size_t i = 0; i < looks_.size(); ++i)
        if (i != a && i != b) looks_[i].renderer.reset();
}

Picture MovieScenes::pictureOf(Look& look, const RenderSettings& settings) const {
    Picture picture = look.renderer->render(settings);
    addWords(*look.prepared, look.options, settings, picture, look.wordMemory.get());
    return picture;
}

Picture MovieScenes::drawKeys(double place) {
    const auto from = std::min(static_cast<std::size_t>(place), path_->stretches() - 1);
    double share = place - static_cast<double>(from);
    if (options_.easing.value_or(Easing::smooth) == Easing::stops) share = eased(Easing::smooth, share);
    const Key &a = keys_[from], &b = keys_[(from + 1) % keys_.size()];
    letGo(a.look, b.look);
    const int model = molecules_;
    const auto draw = [&](std::size_t number) {
        Look& look = ready(number, model);
        RenderSettings settings = look.prepared->settings;
        Clip& clip = settings.effects.clip;
        // At a key view itself the very numbers of that view.
        if (share == 0 && number == a.look) {
            settings.view = a.view;
            clip = a.clip;
        } else if (share == 1 && number == b.look) {
            settings.view = b.view;
            clip = b.clip;
        } else {
            settings.view =
                viewThrough(path_->at(static_cast<double>(from) + share), settings.view, look.prepared->run.center);
            moveClip(clip, a.clip, b.clip, share, settings.view.radius);
        }
        return pictureOf(look, settings);
    };
    if (a.look == b.look || share == 0) return draw(a.look);
    if (share == 1) return draw(b.look);
    return mixed(draw(a.look), draw(b.look), static_cast<float>(eased(Easing::smooth, share)));
}

int MovieScenes::modelAt(std::uint64_t frame) const {
    return options_.models ? static_cast<int>(frame * models_ / frames_) + 1 : molecules_;
}

Picture MovieScenes::draw(std::uint64_t frame) {
    const double time = timeOf(options_, frame, frames_);
    const int model = modelAt(frame);
    if (path_) {
        ready(keys_.front().look, model);
        const Easing easing = options_.easing.value_or(options_.loop ? Easing::linear : Easing::smooth);
        return drawKeys(eased(easing, time) * static_cast<double>(path_->stretches()));
    }
    Look& look = ready(0, model);
    RenderSettings settings = look.prepared->settings;
    const glm::dvec3 center = look.prepared->run.center;
    View& view = settings.view;
    if (center != center_ || view.pixelsPerAngstrom != first_.pixelsPerAngstrom)  // every model from the same place
        view = viewThrough(lensOf(first_, center_), view, center);
    view = viewAt(options_, view, time);
    return pictureOf(look, settings);
}

}  // namespace nacre::app
