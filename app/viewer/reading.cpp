#include "app/viewer/reading.h"

#include <utility>

#include "app/picture/input_names.h"
#include "app/viewer/file_kind.h"

namespace nacre::app {
namespace {

/// Copies the molecules of a view, and their sources.
void takeInput(const PictureDescription& from, PictureDescription& to) {
    to.input = from.input;
    to.look.assembly = from.look.assembly;
    to.maps = from.maps;
    to.mapsChanged();
}

/// The first maps of a structure: contours around the camera's focus, and sticks instead of a cartoon unless rules or
/// --style request one, as model builders prefer.
void lookAtDensity(PictureDescription& view) {
    if (view.maps.files.size() > 0 || view.maps.around || view.given.contains("map-around")) return;
    view.maps.aroundFocus = true;
    const bool chosen = view.given.contains("style") || !view.look.rules.empty();
    if (!chosen && (!view.look.style || view.look.style == Style::cartoon)) view.look.style = Style::licorice;
}

}  // namespace

Reading::Reading(Stage& stage, Sources sources, std::function<void()> wake)
    : stage_(stage), loader_(std::move(sources), std::move(wake)) {
    const PictureDescription& view = stage.view();
    // Saved views keep their look.
    request_.opens = view.input.hash.empty();
    if (!view.input.path.empty()) request_.opens ? loader_.open(view) : loader_.read(view);
}

/// Files by their role.
struct Reading::Files {
    std::vector<std::string> structures, maps, trajectories;

    explicit Files(const std::vector<std::string>& paths) {
        for (const std::string& path : paths) {
            const FileKind kind = detectKind(path);
            (kind == FileKind::map ? maps : kind == FileKind::trajectory ? trajectories : structures).push_back(path);
        }
    }
};

/// Adds maps to the current document.
void Reading::addMaps(const std::vector<std::string>& maps, double now) {
    std::vector<std::string>& files = stage_.wanted().maps.files;
    if (files.size() + maps.size() > kMostMaps)
        return stage_.messages.fail("more than " + std::to_string(kMostMaps) + " maps are not shown together", now);
    stage_.remember();
    if (!stage_.document.molecule->atoms.empty()) lookAtDensity(stage_.wanted());
    files.insert(files.end(), maps.begin(), maps.end());
    stage_.wanted().mapsChanged();
    build();
}

/// Moves the atoms of the current document by a trajectory.
void Reading::addTrajectory(const std::string& path, double now) {
    if (!stage_.document.view.input.further.empty())
        return stage_.messages.fail("a trajectory moves one structure: open that alone first", now);
    stage_.remember();
    stage_.wanted().input.trajectory = {};
    stage_.wanted().input.trajectory.path = path;
    restore(stage_.view(), true);
}

/// Adds files that belong to the current document. @returns whether these were all
bool Reading::join(const Files& files, double now) {
    stage_.messages.dismissFailure();
    if (files.trajectories.size() > 1)
        return stage_.messages.fail("a structure takes one trajectory at a time", now), true;
    if (!stage_.shown() && files.structures.empty() && !files.trajectories.empty())
        return stage_.messages.fail("open the structure first: a trajectory holds only positions", now), true;
    if (!stage_.shown() || !files.structures.empty()) return false;
    if (!files.maps.empty()) addMaps(files.maps, now);
    if (!files.trajectories.empty()) addTrajectory(files.trajectories.front(), now);
    return true;
}

void Reading::open(const std::vector<std::string>& paths, double now) {
    const Files files(paths);
    if (join(files, now)) return;
    const std::vector<std::string>& shown = files.structures.empty() ? files.maps : files.structures;
    if (shown.empty()) return;
    PictureDescription fresh = stage_.view();
    PictureDescription first;
    first.input.path = shown.front();
    if (!files.trajectories.empty()) first.input.trajectory.path = files.trajectories.front();
    first.maps.files = files.maps;
    takeInput(first, fresh);
    fresh.view.clear();
    fresh.given.clear();
    fresh.look.rules.clear();
    fresh.words.labels.clear();
    fresh.words.measures.clear();
    fresh.words.title.clear();
    first.camera.projection = fresh.camera.projection;
    fresh.camera = first.camera;
    if (beginWith(fresh, {files.structures.begin() + (files.structures.empty() ? 0 : 1), files.structures.end()},
                  now)) {
        request_.opens = true;
        loader_.open(fresh);
    }
}

void Reading::add(const std::vector<std::string>& paths, double now) {
    if (!stage_.shown()) return open(paths, now);
    const Files files(paths);
    if (join(files, now)) return;
    PictureDescription more = stage_.view();
    more.maps.files.insert(more.maps.files.end(), files.maps.begin(), files.maps.end());
    more.input.model = 1;  // model numbers do not apply to the others
    more.input.trajectory = {};
    more.look.assembly.clear();
    more.camera.pan = {};
    more.camera.zoom = 1;
    if (beginWith(more, files.structures, now)) loader_.read(more);
}

/// Adds molecules to a view about to be read. @returns whether there is room
bool Reading::beginWith(PictureDescription& view, const std::vector<std::string>& paths, double now) {
    question_.reset();
    stage_.remember();
    request_ = {};
    stage_.schedule.overlayChanged();
    const std::size_t before = view.input.further.size() + 1;
    if (before + paths.size() > kMostInputs) {
        stage_.messages.fail("at most 100 molecules can be shown together", now);
        return false;
    }
    for (const std::string& path : paths) view.input.further.push_back({"", path, ""});
    if (!paths.empty() && view.input.several()) colorApart(inputNames(makeInput(view)), view.look, before);
    return true;
}

void Reading::restore(const PictureDescription& view, bool another) {
    request_ = {another, !another && request_.opens, another && view.camera.center};
    another ? loader_.read(view) : loader_.build(view, stage_.document);
}

void Reading::again() {
    if (std::exchange(failure_, {}).empty()) return;
    stage_.messages.dismissFailure();
    loader_.again();
}

void Reading::readModel(int model) {
    PictureDescription next = stage_.view();
    next.input.model = model;
    loader_.read(next);
}

void Reading::cancel(double now) {
    if (!loader_.busy()) return;
    loader_.cancel();
    stage_.messages.say("stopped", now);
}

void Reading::answer(bool yes, double now) {
    if (!question_) return;
    const Question question = *std::exchange(question_, std::nullopt);
    stage_.schedule.overlayChanged();
    if (!yes) return stage_.messages.say("not opened", now);
    question.accept();
    loader_.read(asked_);
}

bool Reading::another() const {
    const PictureDescription& there = stage_.document.view;
    return loader_.busy() && (!stage_.shown() || loader_.view().input.path != there.input.path);
}

std::optional<Document> Reading::take(double now) {
    try {
        std::optional<Document> document = loader_.take();
        if (document) question_.reset(), failure_.clear();
        return document;
    } catch (const Question& question) {
        question_ = question;
        asked_ = loader_.view();
        stage_.schedule.overlayChanged();
    } catch (const std::exception& error) {
        failure_ = error.what();
        if (std::exchange(request_.restores, false) && stage_.shown()) takeInput(stage_.document.view, stage_.wanted());
        stage_.messages.fail(error.what(), now);
    }
    return std::nullopt;
}

Reading::Arrival Reading::arrive(Document document) {
    const PictureDescription& before = stage_.document.view;
    const PictureDescription& view = document.view;
    Arrival arrival;
    arrival.another = document.molecule != stage_.document.molecule;
    // The camera stays under user control.
    arrival.step = arrival.another && stage_.shown() && view.input.path == before.input.path &&
                   view.input.model != before.input.model;
    arrival.restored = std::exchange(request_.restores, false);
    const Camera& camera = view.camera;
    const bool plain = camera.orientation == glm::dquat(1, 0, 0, 0) && camera.rotationDegrees == glm::dvec3(0) &&
                       !view.given.contains("rotate");
    arrival.opened = arrival.another && std::exchange(request_.opens, false) && plain && !camera.isPlaced() &&
                     !document.molecule->guide;
    stage_.document = std::move(document);
    if (!arrival.another) return arrival;
    const PictureDescription& there = stage_.document.view;
    PictureDescription& wanted = stage_.wanted();
    takeInput(there, wanted);
    if (!arrival.step && !wanted.look.style) {
        wanted.look.style = there.look.style;
        wanted.look.color = there.look.color;
    }
    const bool first = std::exchange(first_, false);
    const bool placed = std::exchange(request_.placed, false);
    if (first || placed) stage_.motion.set(there.camera);
    if (stage_.document.molecule->guide && !arrival.step && !arrival.restored) {
        wanted.background = there.background;
        if (first) stage_.motion.set(there.camera);
    }
    if (!first && !arrival.step && !arrival.restored) {
        wanted.look.rules = there.look.rules;
        wanted.words = there.words;
        stage_.motion.set(there.camera);
    }
    return arrival;
}

}  // namespace nacre::app
