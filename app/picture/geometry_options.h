#pragma once
// Geometry in addition to the molecule, as option values: a file, or the file's text.

#include <memory>
#include <string>
#include <string_view>

namespace nacre {
struct Primitives;
}

namespace nacre::app {

/// Primitives (docs/geometry.md) from a file, from JSON text, or from a scene reader.
struct PrimitiveSource {
    /// The file's name, or JSON on one line. For scene readers: a name that changes with the primitives.
    std::string text;
    std::shared_ptr<const Primitives> made = {};
};

constexpr std::size_t kMostPrimitiveSources = 64;
constexpr std::size_t kLongestGeometryText = 1 << 20;  ///< limit of JSON in an option, bytes

/// Whether a value is JSON, not a file name.
bool isJsonText(std::string_view text);

/// A file name, or JSON, which is put on one line. @throws std::invalid_argument
PrimitiveSource parsePrimitiveSource(std::string_view text);

}  // namespace nacre::app
