#pragma once
// Explains a picture in words: its molecule, style and colours.

#include <string>

#include "app/picture/description.h"
#include "engine/scene/representation.h"

namespace nacre::app {

/// "Homo sapiens. X-ray diffraction, 1.9 Å", from the file; empty: not stated.
std::string originText(const FileSummary& file);

/// Two sentences about style and colours. @param scene  drawn for the picture
std::string explanationText(const PictureDescription& picture, const Representation& scene);

}  // namespace nacre::app
