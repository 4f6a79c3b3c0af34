#pragma once
// Reads MessagePack (msgpack.org's specification) in place: copies and allocates nothing. Announced lengths are only
// compared with the available bytes.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace nacre {

/// One value of a document. Views into the document's bytes, which must outlive it.
struct MsgpackValue {
    enum class Kind : std::uint8_t { nothing, boolean, integer, number, text, binary, array, map, extension };
    Kind kind = Kind::nothing;
    std::uint32_t count = 0;  ///< elements of an array, pairs of a map
    std::int64_t integer = 0;
    double number = 0;
    std::string_view bytes;  ///< text, binary; for a container the bytes after its header, to the document's end

    bool is(Kind other) const { return kind == other; }
    /// The value of a map's key, the first if repeated; empty if it is missing, or this is no map.
    std::optional<MsgpackValue> find(std::string_view key) const;
    /// An integer, or a floating-point number with an integral value.
    std::optional<std::int64_t> asInteger() const;
    std::optional<double> asNumber() const;
    std::optional<std::string_view> asText() const;
};

/// Iterates over the elements of an array, or over keys and values of a map in turn.
class MsgpackElements {
public:
    explicit MsgpackElements(const MsgpackValue& container);
    /// Moves to the next element; false after the last. Other values have none.
    bool next(MsgpackValue& element);

private:
    std::string_view rest_;
    std::uint64_t left_ = 0;
};

/// The value of a document, fully validated; ignores data after it.
/// @param name file name for messages
/// @throws Error if it is truncated or not MessagePack
MsgpackValue parseMsgpack(const std::string& name, std::string_view document);

}  // namespace nacre
