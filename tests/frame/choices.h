#pragma once
// The stated choices of choose_test.cpp.

#include <map>
#include <string>

namespace nacre::test {

/// The lines of a table but those of frames in motion.
std::string withoutMotion(const std::string& table);

/// By the path that a device's kind suggests; "software" of one.
const std::map<std::string, std::string>& statedChoices();

}  // namespace nacre::test
