#pragma once
// Text for people. Names of files, chains, titles, servers' answers: anything may stand in them, and a terminal obeys.

#include <string>
#include <string_view>

namespace nacre::app {

/// One line that does to a terminal nothing but show: line ends and tabs become spaces; other control characters (C0,
/// DEL, C1), marks that turn the direction of writing, line separators, and bytes that are no UTF-8 become visible, as
/// "\x1b" and "\u202e".
std::string printable(std::string_view text);

/// The same, but line ends stay.
std::string printableLines(std::string_view text);

/// JSON, with C1 controls, DEL and marks of direction escaped as JSON does it; valid UTF-8 before and after.
std::string printableJson(std::string_view json);

}  // namespace nacre::app
