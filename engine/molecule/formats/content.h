#pragma once
// What a file holds, as readers want it: inflated, text as UTF-8 with '\n' for every end of line.

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>

#include "engine/molecule/formats/text_source.h"
#include "engine/molecule/read.h"

namespace nacre {

constexpr std::size_t kMaxMessage = 600;  ///< bytes of text from a file that leave a reader

struct FileContent {
    std::string bytes;
    Format format;
};

/// Text that is not held: inflated, in whatever line ends.
struct TextContent {
    TextSource text;
    Format format;
};

/// @param bytes  as they are in the file @throws Error
FileContent contentOf(const std::string& name, std::string bytes, const ReadOptions& options);

/// Of a file with more text than ReadOptions::heldText; one that is compressed, and has several models, is inflated
/// into a temporary file. Nothing if it has less, or is no text as most are. @throws Error
/// @param inflated  then gets what has been inflated, if anything has
std::optional<TextContent> textContentOf(const std::string& path, const ReadOptions& options, std::string& inflated);
/// The same of bytes, whatever their number. @param bytes  go with it
std::optional<TextContent> textContentOf(const std::string& name, std::shared_ptr<const std::string> bytes,
                                         const ReadOptions& options);

/// '\n' for every end of line, whatever the file came from; in place.
void unifyLineEnds(std::string& text);

/// Grows by what is there, to the limit and no further: a device or a pipe may never end.
/// @param expected  bytes that are probably there; 0 if that is not known @throws Error
std::string readAll(std::FILE* file, const std::string& name, std::size_t maxBytes, std::uintmax_t expected);

}  // namespace nacre
