#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace nacre {

/// Whether the bytes begin as a gzip file does (RFC 1952).
bool isGzip(std::string_view bytes);

/// Inflates a gzip file of one or more members; what follows the last member is passed over, as gzip does.
/// Besides maxBytes there is a bound on the ratio: beyond 64 MiB, output of more than 100 times the input is refused,
/// since no structure file comes near it and zeros reach 1,032.
/// @param name file name for messages
/// @throws Error if the stream is damaged or ends early, if its checksum is wrong, or if a bound is exceeded
std::string inflateGzip(const std::string& name, std::string_view bytes, std::size_t maxBytes);

}  // namespace nacre
