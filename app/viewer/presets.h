#pragma once
// Looks that are one key away.

#include <span>
#include <string>
#include <vector>

#include "app/shared/saved_view.h"

namespace nacre::app {

struct Preset {
    const char* name;
    const char* style;  ///< empty: by size
    const char* color;
    const char* background;
    std::vector<std::pair<std::string, std::string>> rules;
};

std::span<const Preset> presets();
/// Changes what is drawn and its colours; camera and file stay.
void applyPreset(const Preset& preset, SavedView& view);

/// What the panel offers, as `--color` and `--background` take it.
std::span<const char* const> colorChoices();
std::span<const char* const> backgroundChoices();

}  // namespace nacre::app
