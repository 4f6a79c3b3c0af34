#pragma once
// Makes text safe for terminals: file names, chains, titles and servers' answers may contain control sequences.

#include <string>
#include <string_view>

namespace nacre::app {

/// One line that a terminal only displays: line ends and tabs become spaces; other control characters (C0, DEL, C1),
/// bidirectional marks, line separators and invalid UTF-8 become visible, as "\x1b" and "\u202e".
std::string printable(std::string_view text);

/// As above, keeping line ends.
std::string printableLines(std::string_view text);

/// JSON, with C1 controls, DEL and bidirectional marks escaped; valid UTF-8 before and after.
std::string printableJson(std::string_view json);

/// A message that may quote anything: drops the middle of a long one.
std::string shortened(const std::string& text);

}  // namespace nacre::app
