#pragma once
// Pictures for two eyes.

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

#include "app/picture/option_values.h"

namespace nacre::app {

struct Stereo {
    enum class Mode : std::uint8_t { off, sideBySide, crossEyed, topBottom, anaglyph, left, right };
    static constexpr std::array<const char*, 7> kNames{"off",      "side-by-side", "cross-eyed", "top-bottom",
                                                       "anaglyph", "left",         "right"};
    static constexpr double kUsualShare = 1.0 / 30;  ///< of the screen distance, between the eyes

    Mode mode = Mode::off;
    std::optional<double> eyeDistance;     ///< Å between the eyes; empty: kUsualShare
    std::optional<double> screenDistance;  ///< Å from the eyes; empty: that of the picture's centre

    bool on() const { return mode != Mode::off; }
    bool beside() const { return mode == Mode::sideBySide || mode == Mode::crossEyed; }
    /// Whether both eyes are in one picture.
    bool both() const { return on() && mode != Mode::left && mode != Mode::right; }
    friend bool operator==(const Stereo&, const Stereo&) = default;
};

/// Size of one eye's picture. If a side is odd, the last column or row of the whole stays empty.
inline Size eyeSize(const Stereo& stereo, Size whole) {
    if (stereo.beside()) whole.width = std::max(whole.width / 2, 1u);
    if (stereo.mode == Stereo::Mode::topBottom) whole.height = std::max(whole.height / 2, 1u);
    return whole;
}

}  // namespace nacre::app
