#include "app/cli/saved_options.h"

#include <filesystem>

#include "app/input/input_files.h"

namespace nacre::app {

void applySavedView(const SavedView& view, RenderOptions& options) {
    options.savedInput = inputOf(view);
    const std::vector<Rule> rules = options.look.rules;
    options.look = view.look;
    options.look.rules.insert(options.look.rules.end(), rules.begin(), rules.end());
    options.drawn = view.drawn;
    options.camera = view.camera;
    options.aim.uncover = view.uncover;
    options.aim.placed = view.camera.zoom != 1 || view.camera.pan != glm::dvec2(0);
    const std::vector<Label> labels = options.words.labels;
    const std::vector<Measure> measures = options.words.measures;
    options.words = view.words;
    options.words.labels.insert(options.words.labels.end(), labels.begin(), labels.end());
    options.words.measures.insert(options.words.measures.end(), measures.begin(), measures.end());
    options.background = view.background;
    options.lighting = view.lighting;
    options.effects = view.effects;
    options.occlusion.directions = view.occlusionDirections;
}

void takeLook(const Look& look, RenderOptions& options) {
    SavedView view = savedViewOf(options);
    applyLook(look, view);
    options.look.color = view.look.color;
    options.background = view.background;
    options.lighting = view.lighting;
    options.effects = view.effects;
    options.occlusion.directions = view.occlusionDirections;
}

SavedView savedViewOf(const RenderOptions& options) {
    SavedView view;
    view.input = options.input.path;
    view.format = options.input.format;
    view.model = options.input.model;
    view.trajectory = options.input.trajectory;
    view.name = options.input.name;
    view.further = options.input.further;
    view.fits = options.input.fits;
    view.look = options.look;
    view.drawn = options.drawn;
    view.camera = options.camera;
    view.uncover = options.aim.uncover;
    view.words = options.words;
    view.background = options.background;
    view.lighting = options.lighting;
    view.effects = options.effects;
    view.occlusionDirections = options.occlusion.directions;
    return view;
}

ViewOptions viewOptionsOf(const RenderOptions& options) {
    ViewOptions window;
    window.first = savedViewOf(options);
    window.first.input = filePathOf(options.input);
    for (FurtherInput& further : window.first.further) {
        InputOptions each = options.input;
        each.path = further.path;
        each.hash = further.hash;
        further.path = filePathOf(each);
    }
    window.input = options.input;
    window.input.path = window.first.input;
    if (!options.input.trajectory.path.empty())
        window.first.trajectory.path =
            std::filesystem::absolute(options.input.trajectory.path).lexically_normal().string();
    window.aim = options.aim;
    window.size = options.size;
    window.occlusionBytes = options.occlusion.bytes();
    window.debug = options.debug;
    window.tuning = options.tuning;
    window.device = options.device;
    window.stats = options.stats;
    return window;
}

}  // namespace nacre::app
