#include "app/apple/menu.h"

#include <algorithm>

#include "app/shared/appearance_values.h"
#include "app/shared/looks.h"
#include "app/shared/mesh_options.h"
#include "app/shared/option_text.h"
#include "app/viewer/presets.h"

namespace nacre::app {
namespace {

constexpr std::pair<const char*, std::optional<Style>> kStyles[] = {
    {"By size", std::nullopt},     {"Space-filling", Style::spacefill}, {"Ball and stick", Style::ballAndStick},
    {"Licorice", Style::licorice}, {"Cartoon", Style::cartoon},         {"Surface", Style::surface}};
constexpr std::size_t kMostChains = 24;

/// Makes items that change the look; each starts from the look that is there when it is chosen.
class Looks {
public:
    Looks(Viewer& viewer, const std::function<double()>& now) : viewer_(viewer), now_(now) {}

    template <class Change>
    MenuItem item(const std::string& title, bool checked, Change change) const {
        return {title, "", checked, [&viewer = viewer_, now = now_, change] {
                    SavedView look = viewer.view();
                    change(look);
                    viewer.setLook(look, now());
                }};
    }
    const SavedView& now() const { return viewer_.view(); }

private:
    Viewer& viewer_;
    std::function<double()> now_;
};

MenuItem styles(const Looks& looks) {
    MenuItem menu{"Style", "circle.hexagongrid"};
    for (const auto& [title, style] : kStyles)
        menu.children.push_back(looks.item(title, looks.now().look.style == style, [style = style](SavedView& look) {
            look.look.style.reset();
            if (style) setStyle(*style, look.look);
        }));
    return menu;
}

MenuItem colors(const Looks& looks) {
    MenuItem menu{"Colours", "paintpalette"};
    for (const char* choice : colorChoices())
        menu.children.push_back(looks.item(choice, coloringText(looks.now().look.color) == choice,
                                           [choice](SavedView& look) { look.look.color = parseColoring(choice); }));
    return menu;
}

MenuItem backgrounds(const Looks& looks) {
    MenuItem menu{"Background", "rectangle.fill"};
    for (const char* choice : backgroundChoices())
        menu.children.push_back(looks.item(choice, backgroundText(looks.now().background) == choice,
                                           [choice](SavedView& look) { look.background = parseColor(choice); }));
    return menu;
}

MenuItem lookMenu(const Looks& looks) {
    MenuItem menu{"Look", "paintbrush"};
    for (const Look& look : app::looks())
        menu.children.push_back(looks.item(look.name, false, [&look](SavedView& view) { applyLook(look, view); }));
    return menu;
}

MenuItem presetMenu(const Looks& looks) {
    MenuItem menu{"Presets", "wand.and.stars"};
    for (const Preset& preset : presets())
        menu.children.push_back(
            looks.item(preset.name, false, [&preset](SavedView& look) { applyPreset(preset, look); }));
    return menu;
}

MenuItem show(const Looks& looks) {
    const SavedView& now = looks.now();
    MenuItem menu{"Show", "eye"};
    menu.children = {
        looks.item("Water", now.drawn.water, [](SavedView& look) { look.drawn.water = !look.drawn.water; }),
        looks.item("Hydrogens", now.drawn.hydrogens,
                   [](SavedView& look) { look.drawn.hydrogens = !look.drawn.hydrogens; }),
        looks.item("Light", now.lighting, [](SavedView& look) { look.lighting = !look.lighting; }),
        looks.item("Ambient occlusion", now.occlusionDirections > 0,
                   [](SavedView& look) {
                       look.occlusionDirections = look.occlusionDirections ? 0 : SavedView{}.occlusionDirections;
                   }),
        looks.item("Perspective", now.camera.projection == Projection::perspective,
                   [](SavedView& look) {
                       look.camera.projection = look.camera.projection == Projection::perspective
                                                    ? Projection::orthographic
                                                    : Projection::perspective;
                   }),
    };
    return menu;
}

/// What can be told apart in a molecule, as selections.
std::vector<std::string> partsOf(const Molecule& molecule) {
    std::vector<std::string> parts = {"ligand", "ion", "protein", "nucleic", "water", "hydrogens"};
    const std::size_t kinds = parts.size();
    for (const Chain& chain : molecule.chains) {
        const bool plain = std::all_of(chain.name.begin(), chain.name.end(), [](unsigned char c) {
            return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
        });
        const std::string part = "chain " + chain.name;
        if (chain.name.empty() || !plain || std::find(parts.begin(), parts.end(), part) != parts.end()) continue;
        if (parts.size() == kinds + kMostChains) break;
        parts.push_back(part);
    }
    return parts;
}

MenuItem selections(const Looks& looks, const Molecule& molecule) {
    MenuItem menu{"Parts", "square.dashed"};
    const auto rule = [&](const char* title, const Rule& change) {
        return looks.item(title, false, [change](SavedView& look) { look.look.rules.push_back(change); });
    };
    for (const std::string& part : partsOf(molecule)) {
        MenuItem item{part};
        item.children = {rule("Hide", parseHide(part)),
                         rule("Space-filling", parseShow(part + "=spacefill")),
                         rule("Ball and stick", parseShow(part + "=ball-and-stick")),
                         rule("Licorice", parseShow(part + "=licorice")),
                         rule("Colour by element", parseColorBy(part + "=element")),
                         rule("Red", parseColorBy(part + "=#e04030"))};
        menu.children.push_back(std::move(item));
    }
    if (!looks.now().look.rules.empty()) {
        const auto [option, value] = ruleText(looks.now().look.rules.back());
        menu.children.push_back(looks.item("Undo " + option + " " + value, false, [](SavedView& look) {
            if (!look.look.rules.empty()) look.look.rules.pop_back();
        }));
    }
    return menu;
}

}  // namespace

std::vector<MenuItem> viewMenu(Viewer& viewer, const std::function<double()>& now) {
    const Looks looks(viewer, now);
    const auto command = [&](const char* title, const char* symbol, ViewerCommand c, bool checked = false) {
        return MenuItem{title, symbol, checked, [&viewer, now, c] { viewer.run(c, now()); }};
    };
    std::vector<MenuItem> items = {styles(looks),   colors(looks),     backgrounds(looks),
                                   lookMenu(looks), presetMenu(looks), show(looks)};
    if (viewer.document()) items.push_back(selections(looks, *viewer.document()->molecule));
    items.push_back(
        command("Turn by itself", "arrow.triangle.2.circlepath", ViewerCommand::autoRotate, viewer.autoRotating()));
    items.push_back(command("Show the whole molecule", "arrow.up.left.and.arrow.down.right", ViewerCommand::fit));
    items.push_back(command("First view", "arrow.uturn.backward", ViewerCommand::reset));
    if (!viewer.picks().empty())
        items.push_back(command("Forget the picked atoms", "xmark.circle", ViewerCommand::clearPicks));
    return items;
}

}  // namespace nacre::app
