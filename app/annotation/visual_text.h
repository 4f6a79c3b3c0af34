#pragma once

#include <string>

namespace nacre::app {

/// A line in visual order, left to right, with Arabic letters joined as Unicode's presentation forms: for the panel,
/// which draws character by character. Unchanged if it has no right-to-left text.
std::string visualText(const std::string& text);

/// Whether a text may have right-to-left parts. A cheap test with false positives.
bool mayRunFromRight(const std::string& text);

}  // namespace nacre::app
