#pragma once
// What a saved view names as its molecule. Someone else may have written the view: it must not fetch, nor have read,
// what its user does not know of.

#include <string>

#include "app/shared/input_options.h"

namespace nacre::app {

/// The file that INPUT names; "-" and samples and downloads as they are. A path that a view names starts from the
/// view's folder.
std::string filePathOf(const InputOptions& input);

/// What to say before a file that a view names outside of its own folder is opened; otherwise empty.
std::string outsideNotice(const InputOptions& input);

}  // namespace nacre::app
