#pragma once
// Converts values to option text, which option_values.h parses.

#include <array>
#include <string>
#include <utility>

#include "engine/effects.h"
#include "engine/scene/build/appearance.h"

namespace nacre::app {

/// A number in short form: 0.0001, 16384.
std::string numberText(double value);
/// With all digits needed to parse to the same number.
std::string exactText(double value);
constexpr std::pair<const char*, Style> kStyles[] = {
    {"spacefill", Style::spacefill},  {"ball-and-stick", Style::ballAndStick},
    {"licorice", Style::licorice},    {"cartoon", Style::cartoon},
    {"surface", Style::surface},      {"line", Style::line},
    {"backbone", Style::backbone},    {"carbohydrate", Style::carbohydrate},
    {"ellipsoids", Style::ellipsoids}};
/// "spacefill", "ball-and-stick", "licorice"
const char* styleName(Style style);
/// A common name if there is one, else "#rrggbb", or "#rrggbbaa" if not opaque.
/// @param color  sRGB-coded 0..1, straight alpha
std::string backgroundText(const std::array<float, 4>& color);
/// Planes in the format of --clip.
std::string clipText(const Clip& clip);
/// The option without dashes, and its value: {"show", "ligand=licorice"}.
std::pair<std::string, std::string> ruleText(const Rule& rule);

/// A description of a preset's selection: "residues within 4 Å of the ligand"; other selections unchanged.
std::string selectionWords(const std::string& text);

}  // namespace nacre::app
