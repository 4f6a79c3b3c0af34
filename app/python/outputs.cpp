// Movies and files of triangles.

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "app/annotation/layout.h"
#include "app/download/load_map.h"
#include "app/drawing/map_layers.h"
#include "app/drawing/scenes.h"
#include "app/export/scene_files.h"
#include "app/input/read_input.h"
#include "app/movie/camera_path.h"
#include "app/movie/movie_file.h"
#include "app/movie/write_movie.h"
#include "app/picture/usage_error.h"
#include "app/python/frames.h"
#include "app/python/interrupt.h"
#include "engine/error.h"
#include "engine/molecule/trajectory/morph.h"

namespace nacre::python {
namespace {

/// @throws app::UsageError
app::CameraMotion parseMotion(const Moving& moving) {
    app::CameraMotion motion;
    for (const auto& [key, text] : moving.motion) try {
            if (!app::setMotion(key, text, motion)) throw app::UsageError("movie() takes no \"" + key + "\"");
        } catch (const std::invalid_argument& error) {
            throw app::UsageError(key + ": " + error.what());
        }
    motion.models = moving.models;
    motion.loop = moving.loop;
    const bool one = moving.models == app::MovieModels::one, morph = moving.models == app::MovieModels::morph;
    if (!motion.spin && !motion.rock && !motion.sweep && one) motion.spin = glm::dvec3(0, 1, 0);
    app::checkCameraMotion(motion);
    if (motion.loop && !morph) throw app::UsageError("loop: it is for morph");
    if (motion.easing == app::Easing::stops && !morph)
        throw app::UsageError("easing: 'stops' is for morph, and for a path along views");
    return motion;
}

std::uint64_t countFrames(const app::CameraMotion& motion, std::uint64_t models, bool trajectory) {
    const double seconds = app::movieSeconds(motion, models, trajectory);
    return static_cast<std::uint64_t>(std::max(std::llround(seconds * motion.framesPerSecond), 1ll));
}

/// The models of a structure, the frames of the trajectory that it was opened with, or a morph.
class Models {
public:
    /// @throws Error if there is only one model
    Models(const Structure& structure, const app::CameraMotion& motion)
        : now_(*structure.molecule), motion_(chooseMotion(structure, motion, now_)) {
        if (!motion_)
            throw Error("cannot show models", structure.inputs.front(),
                        structure.molecule->othersMissing.empty() ? "it has only one, or models of other atoms"
                                                                  : structure.molecule->othersMissing);
        app::movePositions(now_, motion_->positions(0));
    }

    std::uint64_t count() const { return motion_->frames(); }
    const Molecule& molecule() const { return now_; }
    /// Moves the drawing to a model. @throws Error
    void move(std::uint64_t model, app::Drawing& drawing) {
        app::movePositions(now_, motion_->positions(model));
        drawing.moment = {static_cast<std::int64_t>(model + 1), motion_->time()};
        drawing.moveTo(now_);
    }

private:
    static std::unique_ptr<Motion> chooseMotion(const Structure& structure, const app::CameraMotion& motion,
                                                const Molecule& now) {
        if (motion.models != app::MovieModels::morph) return makeMotion(structure, now);
        const app::InputOptions& read = structure.reading;
        if (!read.trajectory.path.empty()) throw app::UsageError("morph: it goes through models, not a trajectory");
        const std::uint64_t models = std::max<std::uint64_t>(now.others.size() + 1, 2);
        return std::make_unique<Motion>(
            morphOfModels(structure.molecule, read.model,
                          app::morphPlaces(motion, countFrames(motion, models, false), models), motion.loop,
                          structure.inputs.front()),
            now, app::motionOptions(read.trajectory, now));
    }

    Molecule now_;
    std::unique_ptr<Motion> motion_;
};

}  // namespace

std::pair<std::uint64_t, std::vector<std::string>> movie(const Structure& structure, const std::string& path,
                                                         const Moving& moving, const std::string& options,
                                                         const Colors& colors, const std::function<void()>& between) {
    checkName("movie()", path, app::isMovieName(path) && !app::isFrameFolder(path), app::movieEndings());
    const app::CameraMotion motion = parseMotion(moving);
    app::PictureDescription request = makeRequest(structure, options, kPlain);
    const bool several = moving.models != app::MovieModels::one;
    if (motion.sweep && (several || request.maps.files.empty()))
        throw app::UsageError("map_sweep: it needs map, and does not go with models");
    request.aim.turns = true;
    std::optional<Models> models;
    if (several) models.emplace(structure, motion);
    const std::uint64_t modelCount = models ? models->count() : 1;
    const bool morph = moving.models == app::MovieModels::morph;  // its models are the movie's frames
    const std::uint64_t frames =
        morph ? modelCount : countFrames(motion, modelCount, !structure.reading.trajectory.path.empty());
    if (frames > app::kMostMovieFrames)
        throw app::UsageError("more than " + std::to_string(app::kMostMovieFrames) + " frames: seconds, fps");
    const app::MovieShape shape{request.size, motion.framesPerSecond, request.background[3] < 1.0f, frames};
    const std::unique_ptr<app::MovieFile> file = app::makeMovieFile(path, shape);
    std::vector<std::string> warnings;
    Structure own = structure;  // a separate scene: the moving camera needs other room for words
    own.kept = std::make_shared<Structure::Kept>();
    withScene(own, request, colors, [&](app::Drawing& drawing, app::Canvas& canvas) {
        warnings = drawing.warnings;
        app::WordMemory memory;
        if (models) {
            drawing.settings.occlusion.cache.clear();  // of temporary models
            drawing.startMoving(models->molecule());
        }
        const bool comesBack =
            motion.spin || motion.rock;  // a cyclic motion starts again at 1, which the last frame does not reach
        const auto picture = [&](std::uint64_t frame) {
            const std::uint64_t whole = comesBack ? frames : std::max<std::uint64_t>(frames - 1, 1);
            if (motion.sweep) {
                app::PictureDescription at = drawing.description();
                at.maps.levels.resize(std::max<std::size_t>(at.maps.levels.size(), 1));
                at.maps.levels.front() = app::levelAt(motion, static_cast<double>(frame) / static_cast<double>(whole));
                drawing.prepare(*structure.molecule, at);
            }
            if (models) models->move(frame * modelCount / frames, drawing);
            RenderSettings settings = drawing.settings;
            // A rotation returns to its start at 1, which the last frame does not reach.
            settings.view =
                app::viewAt(motion, settings.view, static_cast<double>(frame) / static_cast<double>(frames));
            models ? drawing.handOver(canvas) : drawing.show(canvas);
            return drawing.drawAs(settings, canvas.renderer, &memory);
        };
        app::writeMovie(*file, {frames, picture, [&](app::MovieStage, std::uint64_t) { return between(), true; }});
    });
    return {frames, warnings};
}

std::vector<std::string> exportScene(const Structure& structure, const std::string& path, const std::string& options,
                                     const Colors& colors) {
    checkName("export()", path, app::isSceneName(path), app::sceneEndings());
    const app::PictureDescription request = makeRequest(structure, options, kPlain);
    app::OutputFile file(path);
    const Molecule& molecule = *structure.molecule;
    app::loadMaps(request);
    Representation scene = app::buildScene(molecule, request);
    if (!colors.atoms.empty()) {
        checkCount(colors, molecule.atoms.size());
        paint(colors, scene);
    }
    app::addMapSurfaces(molecule, request, scene);
    checkInterrupt();
    const std::string& title = molecule.file.title;
    const app::SceneFileOptions titled{title.empty() ? structure.inputs.front() : title, 1};
    app::writeText(file, app::sceneFile(app::exportScene(molecule, scene, {}), app::fileExtension(path), titled));
    return scene.warnings;
}

}  // namespace nacre::python
