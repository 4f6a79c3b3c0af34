#pragma once
// Colours as text.

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace nacre::app {

/// "transparent", a CSS colour name, #rgb, #rrggbb or #rrggbbaa; sRGB-coded 0..1, straight alpha.
/// @throws std::invalid_argument with the reason, as text that continues "--option: "
std::array<float, 4> parseColor(std::string_view text);
/// Packed as the engine has it (engine/scene/color/colors.h), opaque.
std::uint32_t opaqueColor(const std::array<float, 4>& color);
/// The names that it takes.
std::vector<std::string> colorNames();

}  // namespace nacre::app
