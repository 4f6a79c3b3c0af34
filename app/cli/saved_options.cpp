#include "app/cli/saved_options.h"

#include <cstdio>

#include "app/shared/srgb.h"
#include "engine/scene/palettes.h"

namespace nacre::app {
namespace {

const char* styleName(Style style) {
    switch (style) {
        case Style::spacefill:
            return "spacefill";
        case Style::ballAndStick:
            return "ball-and-stick";
        case Style::licorice:
            return "licorice";
    }
    return "";
}

std::string coloringText(const Coloring& coloring) {
    return coloring.scheme == ColorScheme::uniform ? colorText(coloring.color)
                                                   : std::string(colorSchemeName(coloring.scheme));
}

std::pair<std::string, std::string> ruleText(const Rule& rule) {
    switch (rule.action) {
        case Rule::Action::show:
            return {"show", rule.selection.text + "=" + styleName(rule.style)};
        case Rule::Action::hide:
            return {"hide", rule.selection.text};
        case Rule::Action::color:
            return {"color-by", rule.selection.text + "=" + coloringText(rule.coloring)};
    }
    return {};
}

std::string backgroundText(const std::array<float, 4>& background) {
    for (const char* name : {"white", "black", "gray", "lightgray"})
        if (background == parseColor(name)) return name;
    char text[16];
    std::snprintf(text, sizeof text, background[3] < 1 ? "#%02x%02x%02x%02x" : "#%02x%02x%02x", toByte(background[0]),
                  toByte(background[1]), toByte(background[2]), toByte(background[3]));
    return text;
}

}  // namespace

InputOptions inputOf(const SavedView& view, InputOptions options) {
    options.path = view.input;
    options.format = formatFromName(view.format);
    options.model = view.model;
    return options;
}

void applySavedView(const SavedView& view, RenderOptions& options) {
    options.savedInput = inputOf(view, {});
    RepresentationOptions look = lookOf(view);
    options.look.assembly = look.assembly;
    options.look.style = look.style;
    options.look.color = look.color;
    options.look.rules.insert(options.look.rules.begin(), look.rules.begin(), look.rules.end());
    options.drawn = view.drawn;
    options.camera = view.camera;
    options.background = parseColor(view.background);
    options.lighting = view.lighting;
    options.occlusion.directions = view.occlusionDirections;
}

SavedView savedViewOf(const RenderOptions& options) {
    SavedView view;
    view.input = options.input.path;
    if (options.input.format) view.format = formatName(*options.input.format);
    view.model = options.input.model;
    view.assembly = options.look.assembly;
    if (options.look.style) view.style = styleName(*options.look.style);
    view.color = coloringText(options.look.color);
    for (const Rule& rule : options.look.rules) view.rules.push_back(ruleText(rule));
    view.drawn = options.drawn;
    view.camera = options.camera;
    view.background = backgroundText(options.background);
    view.lighting = options.lighting;
    view.occlusionDirections = options.occlusion.directions;
    return view;
}

}  // namespace nacre::app
