#pragma once
// A view of MessagePack (msgpack.org's specification) where it lies: nothing is copied, nothing is allocated, and a
// length that the document announces is only ever compared with the bytes that are there.

#include <cstddef>
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
    std::string_view bytes;  ///< text, binary; of a container what follows its header, to the document's end

    bool is(Kind other) const { return kind == other; }
    /// The value of a key of a map, the first if there are several; empty if there is none, or this is no map.
    std::optional<MsgpackValue> find(std::string_view key) const;
    /// An integer, or a number that is one.
    std::optional<std::int64_t> asInteger() const;
    std::optional<double> asNumber() const;
    std::optional<std::string_view> asText() const;
};

/// Walks through the elements of an array, or through the keys and values of a map in turn.
class MsgpackElements {
public:
    explicit MsgpackElements(const MsgpackValue& container);
    /// Steps to the next element; false after the last. Anything but a container has none.
    bool next(MsgpackValue& element);

private:
    std::string_view rest_;
    std::uint64_t left_ = 0;
};

/// The value that a document holds, found well formed all through; what follows it is passed over.
/// @param name file name for messages
/// @throws Error if it is cut short or no MessagePack
MsgpackValue parseMsgpack(const std::string& name, std::string_view document);

}  // namespace nacre
