#pragma once
// What a file holds, as readers want it: inflated, text as UTF-8 with '\n' for every end of line.

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>

#include "engine/molecule/formats/model_spans.h"
#include "engine/molecule/formats/text_source.h"
#include "engine/molecule/read.h"

namespace nacre {

constexpr std::size_t kMaxMessage = 600;  ///< bytes of text from a file that leave a reader

struct Content {
    std::string name;  ///< for messages
    Format format;
    std::shared_ptr<const std::string> bytes;  ///< null: a text of several models that is read from a file in pieces
    TextSource text;                           ///< in whatever line ends, unless it is `bytes`
    ModelSpans spans;                          ///< of a text that is not held
};

/// @param bytes  as they are in the file @throws Error
Content contentOf(const std::string& name, std::string bytes, const ReadOptions& options);

/// A file's content. More text than ReadOptions::heldText is not held if its models can be told apart: it is read from
/// the file, or from a temporary one if that is compressed. @param path  "-": standard input @throws Error
Content openContent(const std::string& path, const ReadOptions& options);

/// The same, held whole. @throws Error
Content heldWhole(const Content& content, const ReadOptions& options);

/// '\n' for every end of line, whatever the file came from; in place.
void unifyLineEnds(std::string& text);

}  // namespace nacre
