#pragma once
// What a picture shows, in words: style, colours, and what is hidden. Names only what is drawn.

#include <string>

#include "app/drawing/drawing.h"

namespace nacre::app {

/// A few sentences.
std::string explanationText(const PictureDescription& picture, const Drawing& drawing);

}  // namespace nacre::app
