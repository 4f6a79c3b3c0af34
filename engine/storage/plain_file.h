#pragma once
// Opening files where others may have put something else in their place.

#include <sys/types.h>

#include <optional>
#include <string>

namespace nacre {

/// Opens a plain file. No link is followed, and nothing is waited for, as for the other end of a pipe.
/// @param flags of open(); what may truncate only does so if it is a plain file
/// @returns the file, or -1 and errno: ELOOP for a link, EISDIR for a folder, EINVAL for another thing that is no file
int openPlain(const std::string& path, int flags, mode_t mode = 0);

/// All of a plain file of at most `mostBytes`. Empty if there is none.
std::optional<std::string> readPlain(const std::string& path, std::uint64_t mostBytes);

/// 16 hexadecimal digits that nobody foresees.
std::string unforeseenDigits();

}  // namespace nacre
