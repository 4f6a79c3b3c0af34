#include "app/apple/menu.h"

#include <algorithm>

#include "app/viewer/presets.h"

namespace nacre::app {
namespace {

constexpr std::pair<const char*, const char*> kStyles[] = {
    {"By size", ""}, {"Space-filling", "spacefill"}, {"Ball and stick", "ball-and-stick"}, {"Licorice", "licorice"}};
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
        menu.children.push_back(
            looks.item(title, looks.now().style == style, [style = style](SavedView& look) { look.style = style; }));
    return menu;
}

MenuItem choices(const Looks& looks, const char* title, const char* symbol, std::span<const char* const> all,
                 std::string SavedView::*value) {
    MenuItem menu{title, symbol};
    for (const char* choice : all)
        menu.children.push_back(looks.item(choice, looks.now().*value == choice,
                                           [value, choice](SavedView& look) { look.*value = choice; }));
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
    const auto rule = [&](const char* title, const char* option, const std::string& value) {
        return looks.item(title, false, [option, value](SavedView& look) { look.rules.emplace_back(option, value); });
    };
    for (const std::string& part : partsOf(molecule)) {
        MenuItem item{part};
        item.children = {rule("Hide", "hide", part),
                         rule("Space-filling", "show", part + "=spacefill"),
                         rule("Ball and stick", "show", part + "=ball-and-stick"),
                         rule("Licorice", "show", part + "=licorice"),
                         rule("Colour by element", "color-by", part + "=element"),
                         rule("Red", "color-by", part + "=#e04030")};
        menu.children.push_back(std::move(item));
    }
    if (!looks.now().rules.empty()) {
        const auto& [option, value] = looks.now().rules.back();
        menu.children.push_back(looks.item("Undo " + option + " " + value, false, [](SavedView& look) {
            if (!look.rules.empty()) look.rules.pop_back();
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
    std::vector<MenuItem> items = {
        styles(looks), choices(looks, "Colours", "paintpalette", colorChoices(), &SavedView::color),
        choices(looks, "Background", "rectangle.fill", backgroundChoices(), &SavedView::background), presetMenu(looks),
        show(looks)};
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
