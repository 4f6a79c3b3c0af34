#pragma once
// Looks with names: light, lines, fog, background and colours that go together. A look is data: options and their
// values as a saved view writes them; what it does not say is as by default. What is seen, and from where, is no
// look's.

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/picture/description.h"

namespace nacre::app {

struct Look {
    std::string name, about;
    std::vector<std::pair<std::string, std::string>> options;  ///< without their dashes, and their values
};

/// In the order of sheets and menus; the first is the default.
std::span<const Look> looks();

/// A look by its name, or from a JSON file that holds options: a saved view is one, too, of which the rest is left
/// alone. @throws std::invalid_argument, Error
Look lookOf(const std::string& nameOrFile);

/// The text of such a file. @param name  of it @throws Error
Look lookFromText(const std::string& json, const std::string& name);

/// Gives a view a look instead of the one that it has. Colours stay unless the look has some.
void applyLook(const Look& look, PictureDescription& view);

/// The look of a view, as lookOf() reads it.
std::string lookJson(const PictureDescription& view);
std::string lookJson(const Look& look);

}  // namespace nacre::app
