#include "app/picture/mesh_options.h"

#include <array>

#include "app/picture/option_text.h"
#include "app/picture/option_values.h"

namespace nacre::app {
namespace {

constexpr std::array<const char*, 3> kHelixForms{"ribbon", "tube", "cylinder"};
constexpr std::array<const char*, 3> kBaseForms{"plates", "ladder", "none"};
constexpr std::array<const char*, 3> kSurfaceKinds{"excluded", "accessible", "gaussian"};

/// Of an enumeration whose values have these names in their order.
template <typename Value>
Value named(std::string_view text, const std::array<const char*, 3>& names) {
    return static_cast<Value>(parseChoice(text, names));
}
template <typename Value>
std::string nameOf(Value value, const std::array<const char*, 3>& names) {
    return names[static_cast<std::size_t>(value)];
}

bool isShown(std::string_view text) { return parseChoice(text, {"show", "hide"}) == 0; }
std::string shownText(bool shown) { return shown ? "show" : "hide"; }

const MeshOption kMeshOptions[] = {
    {"helices", "FORM", "ribbon", "Of cartoons: ribbon, tube (bent as the helix is) or cylinder (straight)",
     [](std::string_view text, RepresentationOptions& l) { l.cartoon.helices = named<HelixForm>(text, kHelixForms); },
     [](const RepresentationOptions& l) { return nameOf(l.cartoon.helices, kHelixForms); }},
    {"bases", "FORM", "plates", "Of nucleic acids' cartoons: plates, ladder or none",
     [](std::string_view text, RepresentationOptions& l) { l.cartoon.bases = named<BaseForm>(text, kBaseForms); },
     [](const RepresentationOptions& l) { return nameOf(l.cartoon.bases, kBaseForms); }},
    {"putty", "on|off", "off", "Cartoons as tubes, the wider the larger the B factor",
     [](std::string_view text, RepresentationOptions& l) {
         l.cartoon.putty = parseChoice(text, {"on", "off"}) == 0;
     },
     [](const RepresentationOptions& l) { return std::string(l.cartoon.putty ? "on" : "off"); }},
    {"disulfides", "show|hide", "show", "Bonds between sulphurs, as sticks in cartoons",
     [](std::string_view text, RepresentationOptions& l) { l.cartoon.disulfides = isShown(text); },
     [](const RepresentationOptions& l) { return shownText(l.cartoon.disulfides); }},
    {"surface", "KIND", "excluded",
     "Of --style surface: excluded (what a probe cannot enter), accessible (where its centre goes) or gaussian",
     [](std::string_view text, RepresentationOptions& l) { l.surface.kind = named<SurfaceKind>(text, kSurfaceKinds); },
     [](const RepresentationOptions& l) { return nameOf(l.surface.kind, kSurfaceKinds); }},
    {"probe", "RADIUS", "1.4", "Of surfaces, in Å, 0 to 10",
     [](std::string_view text, RepresentationOptions& l) { l.surface.probe = parseNumber(text, 0, kLargestProbe); },
     [](const RepresentationOptions& l) { return numberText(l.surface.probe); }},
    {"surface-resolution", "auto|CELL", "auto",
     "Edge of the cells that surfaces are made in, in Å, 0.1 to 1.2; auto: 0.4, more for many atoms",
     [](std::string_view text, RepresentationOptions& l) {
         l.surface.resolution = text == "auto" ? 0 : parseNumber(text, kFinestSurface, kCoarsestSurface);
     },
     [](const RepresentationOptions& l) {
         return l.surface.resolution > 0 ? numberText(l.surface.resolution) : std::string("auto");
     }},
    {"cavities", "show|hide", "show", "Surfaces that are closed off from the outside",
     [](std::string_view text, RepresentationOptions& l) { l.surface.cavities = isShown(text); },
     [](const RepresentationOptions& l) { return shownText(l.surface.cavities); }},
    {"surface-opacity", "SHARE", "1", "How much surfaces hide of what is behind them, 0.01 to 1",
     [](std::string_view text, RepresentationOptions& l) { l.surfaceOpacity = parseNumber(text, kLeastOpacity, 1); },
     [](const RepresentationOptions& l) { return numberText(l.surfaceOpacity); }},
    {"cartoon-opacity", "SHARE", "1", "The same of cartoons",
     [](std::string_view text, RepresentationOptions& l) { l.cartoonOpacity = parseNumber(text, kLeastOpacity, 1); },
     [](const RepresentationOptions& l) { return numberText(l.cartoonOpacity); }},
};

}  // namespace

std::span<const MeshOption> meshOptions() { return kMeshOptions; }

const MeshOption* meshOption(std::string_view name) {
    for (const MeshOption& option : kMeshOptions)
        if (option.name == name) return &option;
    return nullptr;
}

void setStyle(Style style, RepresentationOptions& look) {
    look.style = style;
    if (style == Style::cartoon && look.color == Coloring()) look.color = ColorScheme::chainCarbons;
}

}  // namespace nacre::app
