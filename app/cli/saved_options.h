#pragma once
// Between the options of the command line and a saved view.

#include "app/cli/options.h"
#include "app/picture/looks.h"
#include "app/picture/saved_view.h"

namespace nacre::app {

/// Sets what a saved view says. Rules go before those that are there already; its INPUT becomes `savedInput`.
void applySavedView(const SavedView& view, RenderOptions& options);

/// Sets what a look says, and what it does not say to its default.
void takeLook(const Look& look, RenderOptions& options);

SavedView savedViewOf(const RenderOptions& options);

/// A window that shows what `options` say at first.
ViewOptions viewOptionsOf(const RenderOptions& options);

}  // namespace nacre::app
