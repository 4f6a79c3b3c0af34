#pragma once
// A file's content as readers need it: inflated, text as UTF-8 with '\n' as line end.

#include <cstddef>
#include <memory>
#include <string>

#include "engine/molecule/formats/model_spans.h"
#include "engine/molecule/formats/text_source.h"
#include "engine/molecule/read.h"

namespace nacre {

constexpr std::size_t kMaxMessage = 600;  ///< maximum length of text from a file in a reader's message

struct Content {
    std::string name;  ///< for messages
    Format format;
    std::shared_ptr<const std::string> bytes;  ///< null: text of several models, read from a file in pieces
    TextSource text;                           ///< with any line ends, unless it refers to `bytes`
    ModelSpans spans;                          ///< of a text that is not in memory
};

/// @param bytes  contents of the file @throws Error
Content makeContent(const std::string& name, std::string bytes, const ReadOptions& options);

/// A file's content. Text longer than ReadOptions::heldText is not held in memory if its models can be separated: it is
/// read from the file, or from a temporary one if that is compressed. @param path  "-": standard input @throws Error
Content openContent(const std::string& path, const ReadOptions& options);

/// As above, held in memory. @throws Error
Content heldWhole(const Content& content, const ReadOptions& options);

/// Replaces every kind of line end by '\n', in place.
void unifyLineEnds(std::string& text);

}  // namespace nacre
