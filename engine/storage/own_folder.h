#pragma once

#include <filesystem>

namespace nacre {

/// The folder of the program or module that this code is in, where its companions lie; empty if it is unknown.
std::filesystem::path ownFolder();

}  // namespace nacre
