#pragma once
// Describes a picture in sentences: style, colours and hidden atoms. Mentions only what is drawn.

#include <string>

#include "app/drawing/drawing.h"

namespace nacre::app {

/// A few sentences.
std::string explanationText(const PictureDescription& picture, const Drawing& drawing);

}  // namespace nacre::app
