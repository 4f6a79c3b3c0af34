#pragma once
// Text in memory or in a file, read in pieces.

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "engine/molecule/byte_file.h"

namespace nacre {

struct TextSource {
    std::uint64_t size = 0;
    /// Reads bytes that exist. @throws Error
    std::function<void(std::uint64_t at, char* to, std::size_t count)> read;
};

/// @param text  outlives the result
inline TextSource textInMemory(std::string_view text) {
    return {text.size(), [text](std::uint64_t at, char* to, std::size_t count) {
                text.copy(to, count, static_cast<std::size_t>(at));
            }};
}

inline TextSource textInFile(std::shared_ptr<ByteFile> file) {
    const std::uint64_t size = file->size();
    return {size,
            [file = std::move(file)](std::uint64_t at, char* to, std::size_t count) { file->read(at, to, count); }};
}

/// A piece of a text.
struct TextSpan {
    std::uint64_t begin = 0, end = 0;
    std::uint64_t size() const { return end - begin; }
};

inline void appendText(std::string& to, const TextSource& source, const TextSpan& span) {
    const std::size_t before = to.size();
    to.resize(before + static_cast<std::size_t>(span.size()));
    source.read(span.begin, to.data() + before, static_cast<std::size_t>(span.size()));
}

}  // namespace nacre
