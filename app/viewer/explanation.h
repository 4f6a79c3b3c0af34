#pragma once
// What a picture is of, and what its style and colours mean, in words.

#include <string>

#include "app/picture/description.h"
#include "engine/scene/representation.h"

namespace nacre::app {

/// "Homo sapiens. X-ray diffraction, 1.9 Å": what the file states of it; empty: nothing.
std::string originText(const FileSummary& file);

/// What is seen, in two sentences: the style and the colours. @param scene  that is drawn of it
std::string explanationText(const PictureDescription& picture, const Representation& scene);

}  // namespace nacre::app
