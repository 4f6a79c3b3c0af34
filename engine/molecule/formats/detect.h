#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "engine/molecule/read.h"

namespace nacre {

/// The format of a file's text: by its content first, by its name second (ignoring endings such as .gz).
/// @throws Error if the format is known but not supported, no molecule format, or ambiguous
Format detectFormat(const std::string& name, std::string_view text);

/// The binary format that the content shows; empty otherwise.
std::optional<Format> detectBinaryFormat(std::string_view bytes);

}  // namespace nacre
