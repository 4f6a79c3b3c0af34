#pragma once
// Pictures for print: lengths on paper, and what files say of them.

#include "app/cli/options.h"

namespace nacre::app {

/// --width, --height, --dpi, --depth.
void addPaper(CommandSpec& command, RenderOptions& options);

/// Lengths on paper become pixels. @throws UsageError if there are none or too many
void takePaper(RenderOptions& options);

/// Whether the file's format holds what is asked for. @throws UsageError
void checkFormat(const RenderOptions& options);

}  // namespace nacre::app
