#pragma once
// Geometry beside the molecule, as options name it: a file, or the file's text itself.

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace nacre {
struct Primitives;
}

namespace nacre::app {

/// Primitives (docs/geometry.md) from a file, from JSON in its place, or as a reader of scenes has made them.
struct PrimitiveSource {
    /// The file's name, or JSON on one line. Of what was made: a name that differs if the primitives do.
    std::string text;
    std::shared_ptr<const Primitives> made = {};
};

constexpr std::size_t kMostPrimitiveSources = 64;
constexpr std::size_t kLongestGeometryText = 1 << 20;  ///< bytes of JSON in an option

/// Whether a value is JSON, no file's name.
bool isJsonText(std::string_view text);

/// A file's name, or JSON, which comes out on one line. @throws std::invalid_argument
PrimitiveSource parsePrimitiveSource(std::string_view text);

}  // namespace nacre::app
