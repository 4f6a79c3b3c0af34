#pragma once
// Options of `nacre batch`, and of a line in its job list.

#include <string>
#include <vector>

#include "app/cli/options.h"

namespace nacre::app {

/// @param options  receives values; outlives the command
void addBatch(CommandSpec& command, BatchOptions& options);

/// The picture of a job's line, after the options common to all. @throws UsageError
PictureDescription jobOf(const std::string& json, const BatchOptions& batch);

}  // namespace nacre::app
