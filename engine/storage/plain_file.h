#pragma once
// Opens regular files safely, where others could have replaced them.

#include <sys/types.h>

#include <optional>
#include <string>

namespace nacre {

/// Opens a regular file. Follows no link, and does not block, for example on a pipe.
/// @param flags of open(); truncates only if it is a regular file
/// @returns the file, or -1 and errno: ELOOP for a link, EISDIR for a folder, EINVAL for anything else
int openPlain(const std::string& path, int flags, mode_t mode = 0);

/// All of a regular file of at most `mostBytes`. Empty if there is none.
std::optional<std::string> readPlain(const std::string& path, std::uint64_t mostBytes);

/// 16 unpredictable hexadecimal digits.
std::string unforeseenDigits();

}  // namespace nacre
