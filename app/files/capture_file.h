#pragma once
// RenderDoc captures as files that appear complete or not at all.

#include <string>

#include "app/files/output_file.h"

namespace nacre::app {

/// For Renderer::beginCapture(): RenderDoc writes beside `file`; leftovers are removed with `file`.
std::string captureStem(OutputFile& file);

/// Moves RenderDoc's capture to `file`. @throws Error if it is incomplete
void keepCapture(const std::string& written, OutputFile& file);

/// Whether a file has all sections that its headers announce: RenderDoc does not detect a full disk.
bool isWholeCapture(const std::string& path);

}  // namespace nacre::app
