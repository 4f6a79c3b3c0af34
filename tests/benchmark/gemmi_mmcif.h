#pragma once

#include <cstddef>
#include <string>

namespace nacre::test {

/// gemmi's own readers, from memory to its Structure. @returns atoms of the first model
std::size_t gemmiPdb(const std::string& bytes);
std::size_t gemmiMmcif(const std::string& bytes);

}  // namespace nacre::test
