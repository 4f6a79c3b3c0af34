#pragma once
// Captures that RenderDoc writes, as files that appear whole or not at all.

#include <string>

#include "app/files/output_file.h"

namespace nacre::app {

/// For Renderer::beginCapture(): RenderDoc writes beside `file`, and what it leaves there goes with `file`.
std::string captureStem(OutputFile& file);

/// Puts the capture that RenderDoc wrote in the place of `file`. @throws Error if it is not whole
void keepCapture(const std::string& written, OutputFile& file);

/// Whether a file has all the sections that its headers announce: RenderDoc does not notice that a disk is full.
bool isWholeCapture(const std::string& path);

}  // namespace nacre::app
