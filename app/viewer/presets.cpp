#include "app/viewer/presets.h"

#include "app/picture/appearance_values.h"
#include "app/picture/looks.h"

namespace nacre::app {

std::span<const Preset> presets() {
    using enum Style;
    constexpr std::array<float, 4> kWhite{1, 1, 1, 1}, kBlack{0, 0, 0, 1};
    static const Preset kPresets[] = {
        {"Elements", {spacefill, ColorScheme::element}, kWhite},
        {"Cartoon", {cartoon, ColorScheme::chainCarbons}, kWhite},
        {"Cartoon, N to C", {cartoon, ColorScheme::rainbow, {parseColorBy("ligand or ion=element")}}, kWhite},
        {"Helices and strands",
         {cartoon, ColorScheme::secondaryStructure, {parseColorBy("ligand or ion=element")}},
         kWhite},
        {"Surface", {surface, ColorScheme::chainCarbons}, kWhite},
        {"Chains", {spacefill, ColorScheme::chain}, kWhite},
        {"Chains and ligands", {spacefill, ColorScheme::chain, {parseColorBy("ligand or ion=element")}}, kWhite},
        {"Ligand in its pocket", {}, kWhite, true},
        {"Licorice", {licorice, ColorScheme::element}, kWhite},
        {"N to C", {spacefill, ColorScheme::rainbow}, kWhite},
        {"Predicted confidence", {cartoon, ColorScheme::plddt}, kWhite},
        {"Hydrophobic and polar", {spacefill, ColorScheme::hydrophobicity}, kWhite},
        {"On black", {spacefill, ColorScheme::element}, kBlack},
    };
    return kPresets;
}

void applyPreset(const Preset& preset, PictureDescription& view) {
    const std::string assembly = view.look.assembly;
    const AnyPalette palette = view.look.palette;
    view.look = preset.look;
    view.look.assembly = assembly;
    view.look.palette = palette;
    view.background = preset.background;
    if (!preset.pocket) return;
    view.words.labels.clear();
    applyPocket("ligand", view);
}

}  // namespace nacre::app
