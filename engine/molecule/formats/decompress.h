#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

namespace nacre {

/// Compression of a file by its first bytes: "gzip" (RFC 1952), "xz", "bzip2" or "zstd" (RFC 8878); empty if none.
std::string_view detectCompression(std::string_view bytes);

/// Inflates a compressed file of one or more members; ignores data after the last. The ratio is limited as well as the
/// size: beyond 64 MiB, output of more than 100 times the input is refused. Structure files stay far below; a file of
/// zeros reaches thousands.
/// @param name file name for messages
/// @param bytes of the compression that detectCompression() returns
/// @throws Error if the stream is damaged or ends early, its checksum is wrong, or a limit is exceeded
std::string decompress(const std::string& name, std::string_view bytes, std::size_t maxBytes);
/// As above, part by part.
void decompress(const std::string& name, std::string_view bytes, std::size_t maxBytes,
                const std::function<void(std::string_view)>& take);

}  // namespace nacre
