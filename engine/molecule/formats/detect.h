#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "engine/molecule/read.h"

namespace nacre {

/// The format of a file's text: by its content first, by its name second (an ending such as .gz is passed over).
/// @throws Error if it is a format that is known but not supported, no molecule at all, or not to be told
Format detectFormat(const std::string& name, std::string_view text);

/// The format of a file whose content says that it is one of the binary ones; empty otherwise.
std::optional<Format> detectBinaryFormat(std::string_view bytes);

}  // namespace nacre
