#pragma once
// Values as the options that take them write them: what option_values.h reads.

#include <array>
#include <string>
#include <utility>

#include "engine/effects.h"
#include "engine/scene/appearance.h"

namespace nacre::app {

/// A number as people read it: 0.0001, 16384.
std::string numberText(double value);
/// With all digits that it takes to read the same number again.
std::string exactText(double value);
/// "spacefill", "ball-and-stick", "licorice"
const char* styleName(Style style);
/// A name where there is one that people use, else "#rrggbb", or "#rrggbbaa" if it is not opaque.
/// @param color  sRGB-coded 0..1, straight alpha
std::string backgroundText(const std::array<float, 4>& color);
/// Planes as --clip takes them.
std::string clipText(const Clip& clip);
/// The option without its dashes, and its value: {"show", "ligand=licorice"}.
std::pair<std::string, std::string> ruleText(const Rule& rule);

}  // namespace nacre::app
