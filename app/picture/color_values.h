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
/// Packed like the engine's colours (engine/scene/color/colors.h), opaque.
std::uint32_t opaqueColor(const std::array<float, 4>& color);
/// The colour names that parseColor() accepts.
std::vector<std::string> colorNames();

}  // namespace nacre::app
