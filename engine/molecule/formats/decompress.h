#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

namespace nacre {

/// How a file is compressed, by its first bytes: "gzip" (RFC 1952), "xz", "bzip2" or "zstd" (RFC 8878); empty if it is
/// not.
std::string_view compressionOf(std::string_view bytes);

/// Inflates a compressed file of one or more members, as each program writes them; what follows the last member is
/// passed over.
/// Besides maxBytes there is a bound on the ratio: beyond 64 MiB, output of more than 100 times the input is refused,
/// since no structure file comes near it and zeros reach thousands.
/// @param name file name for messages
/// @param bytes those of which compressionOf() names the compression
/// @throws Error if the stream is damaged or ends early, if its checksum is wrong, or if a bound is exceeded
std::string decompress(const std::string& name, std::string_view bytes, std::size_t maxBytes);
/// The same, part by part.
void decompress(const std::string& name, std::string_view bytes, std::size_t maxBytes,
                const std::function<void(std::string_view)>& take);

}  // namespace nacre
