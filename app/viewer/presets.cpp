#include "app/viewer/presets.h"

namespace nacre::app {

std::span<const Preset> presets() {
    static const std::vector<Preset> kPresets = {
        {"Elements", "", "element", "white", {}},
        {"Chains", "spacefill", "chain", "white", {}},
        {"Chains and ligands", "spacefill", "chain", "white", {{"color-by", "ligand or ion=element"}}},
        {"Ligand in its pocket",
         "licorice",
         "chain",
         "white",
         {{"hide", "not (ligand or ion or byres within 6 of ligand)"},
          {"show", "ligand or ion=spacefill"},
          {"color-by", "ligand or ion=element"}}},
        {"Sticks", "licorice", "element", "white", {}},
        {"N to C", "spacefill", "rainbow", "white", {}},
        {"Predicted confidence", "spacefill", "plddt", "white", {}},
        {"Hydrophobic and polar", "spacefill", "hydrophobicity", "white", {}},
        {"On black", "spacefill", "element", "black", {}},
    };
    return kPresets;
}

void applyPreset(const Preset& preset, SavedView& view) {
    view.style = preset.style;
    view.color = preset.color;
    view.background = preset.background;
    view.rules = preset.rules;
}

std::span<const char* const> colorChoices() {
    static constexpr const char* kChoices[] = {"element", "chain",     "residue",       "entity",
                                               "rainbow", "charge",    "b-factor",      "secondary-structure",
                                               "plddt",   "occupancy", "hydrophobicity"};
    return kChoices;
}

std::span<const char* const> backgroundChoices() {
    static constexpr const char* kChoices[] = {"white", "lightgray", "gray", "black", "#102040"};
    return kChoices;
}

}  // namespace nacre::app
