#pragma once
// The stated choices of choose_test.cpp.

#include <map>
#include <string>

namespace nacre::test {

/// A table without the lines of frames in motion.
std::string withoutMotion(const std::string& table);

/// By the path that the device's kind suggests; "software": of software devices.
const std::map<std::string, std::string>& statedChoices();

}  // namespace nacre::test
