#pragma once
// `nacre batch`: what its command line says, and what a line of its jobs does.

#include <string>
#include <vector>

#include "app/cli/options.h"

namespace nacre::app {

/// @param options  outlives the command, as what its options write to
void addBatch(CommandSpec& command, BatchOptions& options);

/// A picture of a batch: its line, after the options that hold for all. @throws UsageError
PictureDescription jobOf(const std::string& json, const BatchOptions& batch);

}  // namespace nacre::app
