#include "engine/molecule/formats/msgpack.h"

#include <bit>
#include <cmath>

#include "engine/molecule/text.h"

namespace nacre {

namespace {

/// Takes a big-endian number off the front.
bool takeUnsigned(std::string_view& rest, std::size_t size, std::uint64_t& value) {
    if (rest.size() < size) return false;
    value = 0;
    for (std::size_t i = 0; i < size; ++i) value = value << 8 | static_cast<unsigned char>(rest[i]);
    rest.remove_prefix(size);
    return true;
}

bool takeBytes(std::string_view& rest, std::uint64_t size, std::string_view& bytes) {
    if (rest.size() < size) return false;
    bytes = rest.substr(0, static_cast<std::size_t>(size));
    rest.remove_prefix(static_cast<std::size_t>(size));
    return true;
}

using Kind = MsgpackValue::Kind;

bool takeSized(std::string_view& rest, Kind kind, std::uint64_t size, MsgpackValue& value) {
    value.kind = kind;
    if (kind == Kind::array || kind == Kind::map) {
        value.count = static_cast<std::uint32_t>(size);
        value.bytes = rest;
        return size <= rest.size();  // an element takes a byte at least
    }
    if (kind == Kind::extension && !takeBytes(rest, 1, value.bytes)) return false;  // its type
    return takeBytes(rest, size, value.bytes);
}

bool takeInteger(std::string_view& rest, std::size_t size, bool isSigned, MsgpackValue& value) {
    std::uint64_t bits = 0;
    if (size == 0 || !takeUnsigned(rest, size, bits)) return false;
    value.kind = Kind::integer;
    const auto unused = static_cast<unsigned>(64 - 8 * size);
    value.integer = isSigned ? static_cast<std::int64_t>(bits << unused) >> unused : static_cast<std::int64_t>(bits);
    if (isSigned || value.integer >= 0) return true;
    value.kind = Kind::number;  // 2^63 and above
    value.number = static_cast<double>(bits);
    return true;
}

bool takeFloat(std::string_view& rest, std::size_t size, MsgpackValue& value) {
    std::uint64_t bits = 0;
    if (!takeUnsigned(rest, size, bits)) return false;
    value.kind = Kind::number;
    value.number = size == 8 ? std::bit_cast<double>(bits)
                             : static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
    return true;
}

/// A value whose header has the size in 1, 2 or 4 bytes.
bool takeLong(std::string_view& rest, Kind kind, std::size_t sizeBytes, MsgpackValue& value) {
    std::uint64_t size = 0;
    return takeUnsigned(rest, sizeBytes, size) && takeSized(rest, kind, size, value);
}

bool takeMarked(std::string_view& rest, unsigned mark, MsgpackValue& value) {
    const auto width = [mark](unsigned first) { return std::size_t{1} << (mark - first); };
    value.kind = Kind::nothing;
    if (mark == 0xC0) return true;
    if (mark == 0xC1) return false;  // never used
    if (mark <= 0xC3) {
        value.kind = Kind::boolean;
        value.integer = mark == 0xC3;
        return true;
    }
    if (mark <= 0xC6) return takeLong(rest, Kind::binary, width(0xC4), value);
    if (mark <= 0xC9) return takeLong(rest, Kind::extension, width(0xC7), value);
    if (mark <= 0xCB) return takeFloat(rest, mark == 0xCA ? 4 : 8, value);
    if (mark <= 0xCF) return takeInteger(rest, width(0xCC), false, value);
    if (mark <= 0xD3) return takeInteger(rest, width(0xD0), true, value);
    if (mark <= 0xD8) return takeSized(rest, Kind::extension, width(0xD4), value);
    if (mark <= 0xDB) return takeLong(rest, Kind::text, width(0xD9), value);
    return takeLong(rest, mark <= 0xDD ? Kind::array : Kind::map, mark % 2 == 0 ? 2 : 4, value);
}

/// Reads a scalar, or the header of a container. False if it is truncated or invalid.
bool take(std::string_view& rest, MsgpackValue& value) {
    value = {};
    if (rest.empty()) return false;
    const unsigned mark = static_cast<unsigned char>(rest.front());
    rest.remove_prefix(1);
    if (mark < 0x80 || mark >= 0xE0) {
        value.kind = Kind::integer;
        value.integer = mark < 0x80 ? static_cast<int>(mark) : static_cast<int>(mark) - 256;
        return true;
    }
    if (mark < 0x90) return takeSized(rest, Kind::map, mark & 15u, value);
    if (mark < 0xA0) return takeSized(rest, Kind::array, mark & 15u, value);
    if (mark < 0xC0) return takeSized(rest, Kind::text, mark & 31u, value);
    return takeMarked(rest, mark, value);
}

std::uint64_t countElements(const MsgpackValue& value) {
    if (value.is(Kind::array)) return value.count;
    return value.is(Kind::map) ? std::uint64_t{2} * value.count : 0;
}

/// Skips a whole value by counting open elements, without recursion.
bool skip(std::string_view& rest) {
    MsgpackValue value;
    for (std::uint64_t open = 1; open > 0; --open) {
        if (!take(rest, value)) return false;
        open += countElements(value);
    }
    return true;
}

}  // namespace

MsgpackElements::MsgpackElements(const MsgpackValue& container)
    : rest_(container.bytes), left_(countElements(container)) {}

bool MsgpackElements::next(MsgpackValue& element) {
    if (left_ == 0) return false;
    --left_;
    std::string_view after = rest_;
    if (!skip(after)) return false;
    take(rest_, element);
    rest_ = after;
    return true;
}

std::optional<MsgpackValue> MsgpackValue::find(std::string_view key) const {
    if (kind != Kind::map) return std::nullopt;
    MsgpackElements elements(*this);
    MsgpackValue name, value;
    while (elements.next(name) && elements.next(value))
        if (name.kind == Kind::text && name.bytes == key) return value;
    return std::nullopt;
}

std::optional<std::int64_t> MsgpackValue::asInteger() const {
    if (kind == Kind::integer) return integer;
    // JavaScript knows one kind of number, and its encoders may write 1.0 for 1.
    if (kind == Kind::number && std::abs(number) < 9e15 && std::nearbyint(number) == number)
        return static_cast<std::int64_t>(number);
    return std::nullopt;
}

std::optional<double> MsgpackValue::asNumber() const {
    if (kind == Kind::number) return number;
    if (kind == Kind::integer) return static_cast<double>(integer);
    return std::nullopt;
}

std::optional<std::string_view> MsgpackValue::asText() const {
    if (kind == Kind::text) return bytes;
    return std::nullopt;
}

MsgpackValue parseMsgpack(const std::string& name, std::string_view document) {
    std::string_view rest = document;
    if (!skip(rest)) {
        const std::string where = std::to_string(document.size() - rest.size());
        cannotRead(name, "not valid MessagePack, or cut short: byte " + where);
    }
    MsgpackValue value;
    take(document, value);
    return value;
}

}  // namespace nacre
