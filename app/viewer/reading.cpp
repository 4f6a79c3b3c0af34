#include "app/viewer/reading.h"

#include <algorithm>
#include <utility>

#include "app/picture/input_names.h"
#include "engine/volume/read_map.h"

namespace nacre::app {
namespace {

/// Which molecules a view is of, and where they come from.
void takeInput(const PictureDescription& from, PictureDescription& to) {
    to.input = from.input;
    to.look.assembly = from.look.assembly;
    to.maps = from.maps;
    to.mapsChanged();
}

}  // namespace

Reading::Reading(Stage& stage, Sources sources, std::function<void()> wake)
    : stage_(stage), loader_(std::move(sources), std::move(wake)) {
    const PictureDescription& view = stage.view();
    // Saved views keep their look.
    if (!view.input.path.empty()) view.input.hash.empty() ? loader_.open(view) : loader_.read(view);
}

/// Density maps among some files: drawn with the current document, or with the one being read.
std::vector<std::string> Reading::divideMaps(std::vector<std::string>& paths) {
    const auto maps =
        std::stable_partition(paths.begin(), paths.end(), [](const std::string& path) { return !isMapFile(path); });
    std::vector<std::string> taken(maps, paths.end());
    paths.erase(maps, paths.end());
    return taken;
}

/// Adds maps to the current document.
void Reading::addMaps(const std::vector<std::string>& maps, double now) {
    if (!stage_.shown()) return stage_.messages.fail("open a molecule first, and then its density map", now);
    std::vector<std::string>& files = stage_.wanted().maps.files;
    if (files.size() + maps.size() > kMostMaps)
        return stage_.messages.fail("more than " + std::to_string(kMostMaps) + " maps are not shown together", now);
    stage_.remember();
    files.insert(files.end(), maps.begin(), maps.end());
    stage_.wanted().mapsChanged();
    build();
}

void Reading::open(const std::vector<std::string>& all, double now) {
    std::vector<std::string> paths = all;
    const std::vector<std::string> maps = divideMaps(paths);
    if (paths.empty()) return maps.empty() ? void() : addMaps(maps, now);
    PictureDescription fresh = stage_.view();
    PictureDescription first;
    first.input.path = paths.front();
    first.maps.files = maps;
    takeInput(first, fresh);
    fresh.look.rules.clear();
    fresh.words.labels.clear();
    fresh.words.measures.clear();
    fresh.words.title.clear();
    first.camera.projection = fresh.camera.projection;
    fresh.camera = first.camera;
    if (beginWith(fresh, {paths.begin() + 1, paths.end()}, now)) loader_.open(fresh);
}

void Reading::add(const std::vector<std::string>& all, double now) {
    if (!stage_.shown()) return open(all, now);
    std::vector<std::string> paths = all;
    const std::vector<std::string> maps = divideMaps(paths);
    if (!maps.empty()) addMaps(maps, now);
    if (paths.empty()) return;
    PictureDescription more = stage_.view();
    more.input.model = 1;  // models of one are nothing to the others
    more.input.trajectory = {};
    more.look.assembly.clear();
    more.camera.pan = {};
    more.camera.zoom = 1;
    if (beginWith(more, paths, now)) loader_.read(more);
}

/// Adds molecules to a view about to be read. @returns whether there is room
bool Reading::beginWith(PictureDescription& view, const std::vector<std::string>& paths, double now) {
    question_.reset();
    stage_.messages.dismissFailure();
    stage_.remember();
    restoring_ = false;
    stage_.schedule.overlayChanged();
    const std::size_t before = view.input.further.size() + 1;
    if (before + paths.size() > kMostInputs) {
        stage_.messages.fail("at most 100 molecules can be shown together", now);
        return false;
    }
    for (const std::string& path : paths) view.input.further.push_back({"", path, ""});
    if (!paths.empty()) colorApart(inputNames(inputOf(view)), view.look, before);
    return true;
}

void Reading::restore(const PictureDescription& view, bool another) {
    restoring_ = another;
    another ? loader_.read(view) : loader_.build(view, stage_.document);
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
        if (document) question_.reset();
        return document;
    } catch (const Question& question) {
        question_ = question;
        asked_ = loader_.view();
        stage_.schedule.overlayChanged();
    } catch (const std::exception& error) {
        if (std::exchange(restoring_, false) && stage_.shown()) takeInput(stage_.document.view, stage_.wanted());
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
    arrival.restored = std::exchange(restoring_, false);
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
    if (first && stage_.view().camera.scale) stage_.motion.set(there.camera);
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
