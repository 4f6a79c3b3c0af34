#include "engine/molecule/formats/bcif_column.h"

#include <cstring>

namespace nacre {

namespace {

constexpr std::size_t kMaxEncodings = 8;  // real chains have up to four

MsgpackValue need(const MsgpackValue& map, const char* key) {
    const auto value = map.find(key);
    if (!value) throw PackedFault(std::string("it has no ") + key);
    return *value;
}

std::string_view needBytes(const MsgpackValue& map, const char* key) {
    const MsgpackValue value = need(map, key);
    if (!value.is(MsgpackValue::Kind::binary)) throw PackedFault(std::string(key) + " is not binary");
    return value.bytes;
}

std::string_view needText(const MsgpackValue& map, const char* key) {
    const auto text = need(map, key).asText();
    if (!text) throw PackedFault(std::string(key) + " is not text");
    return *text;
}

std::int64_t needInteger(const MsgpackValue& map, const char* key, std::int64_t low, std::int64_t high) {
    const auto value = need(map, key).asInteger();
    if (!value || *value < low || *value > high) throw PackedFault(std::string(key) + " is out of range");
    return *value;
}

double needNumber(const MsgpackValue& map, const char* key) {
    const auto value = need(map, key).asNumber();
    if (!value) throw PackedFault(std::string(key) + " is not a number");
    return *value;
}

/// Encodings in the order in which they were applied; decoding goes from the last to the first.
std::vector<MsgpackValue> encodingsOf(const MsgpackValue& list) {
    std::vector<MsgpackValue> encodings;
    MsgpackElements elements(list);
    for (MsgpackValue encoding; elements.next(encoding);) {
        if (encodings.size() == kMaxEncodings) throw PackedFault("it has too many encodings");
        encodings.push_back(encoding);
    }
    if (encodings.empty()) throw PackedFault("it has no encoding");
    return encodings;
}

/// @return the size of the values that an encoding yields, if it says so, else the size of the whole column
std::size_t sizeOf(const MsgpackValue& encoding, std::size_t limit) {
    return static_cast<std::size_t>(needInteger(encoding, "srcSize", 0, static_cast<std::int64_t>(limit)));
}

Integers byteArray(std::string_view bytes, const MsgpackValue& encoding) {
    static constexpr IntegerType kTypes[] = {{1, true}, {2, true}, {4, true}, {1, false}, {2, false}, {4, false}};
    const auto type = static_cast<std::size_t>(needInteger(encoding, "type", 1, 6));
    return integersFromBytes(bytes, kTypes[type - 1], ByteOrder::little);
}

/// Undoes one encoding of integers. @param limit no step may yield more values
void undo(const MsgpackValue& encoding, Integers& values, std::size_t limit) {
    const std::string_view kind = needText(encoding, "kind");
    if (kind == "Delta") {
        sumDeltas(values, static_cast<std::int32_t>(needInteger(encoding, "origin", INT32_MIN, INT32_MAX)));
    } else if (kind == "RunLength") {
        values = expandRuns(values, sizeOf(encoding, limit));
    } else if (kind == "IntegerPacking") {
        IntegerType type;
        type.bytes = static_cast<std::size_t>(needInteger(encoding, "byteCount", 1, 2));
        const MsgpackValue isUnsigned = need(encoding, "isUnsigned");
        type.isSigned = isUnsigned.integer == 0;
        values = unpackExtremes(values, type, sizeOf(encoding, values.size()));
    } else {
        throw PackedFault("unknown encoding, or out of place: '" + std::string(kind.substr(0, 32)) + "'");
    }
}

/// @param encodings the last of them ByteArray; those from `first` on are undone
Integers decodeIntegers(std::string_view bytes, const std::vector<MsgpackValue>& encodings, std::size_t first,
                        std::size_t limit) {
    if (first >= encodings.size() || needText(encodings.back(), "kind") != "ByteArray")
        throw PackedFault("its last encoding is not ByteArray");
    Integers values = byteArray(bytes, encodings.back());
    for (std::size_t i = encodings.size() - 1; i-- > first;) undo(encodings[i], values, limit);
    return values;
}

void expectSize(std::size_t size, std::size_t rows) {
    if (size != rows)
        throw PackedFault("it has " + std::to_string(size) + " values in " + std::to_string(rows) + " rows");
}

template <typename Float>
double floatAt(std::string_view bytes, std::size_t index) {
    static_assert(sizeof(Float) == 4 || sizeof(Float) == 8);
    std::uint64_t bits = 0;
    for (std::size_t k = sizeof(Float); k-- > 0;)
        bits = bits << 8 | static_cast<unsigned char>(bytes[index * sizeof(Float) + k]);
    if constexpr (sizeof(Float) == 8) {
        double value = 0;
        std::memcpy(&value, &bits, sizeof value);
        return value;
    } else {
        const auto half = static_cast<std::uint32_t>(bits);
        float value = 0;
        std::memcpy(&value, &half, sizeof value);
        return static_cast<double>(value);
    }
}

}  // namespace

BcifColumn::BcifColumn(const MsgpackValue& column, std::size_t rows) {
    decode(need(column, "data"), rows);
    const auto mask = column.find("mask");
    if (!mask || mask->is(MsgpackValue::Kind::nothing)) return;
    const Integers marks = decodeIntegers(needBytes(*mask, "data"), encodingsOf(need(*mask, "encoding")), 0, rows);
    expectSize(marks.size(), rows);
    missing_.assign(marks.begin(), marks.end());  // 1 is '.', 2 is '?'
}

void BcifColumn::decode(const MsgpackValue& data, std::size_t rows) {
    const std::string_view bytes = needBytes(data, "data");
    const std::vector<MsgpackValue> encodings = encodingsOf(need(data, "encoding"));
    const MsgpackValue& outer = encodings.front();
    const std::string_view kind = needText(outer, "kind");
    if (kind == "StringArray") {
        if (encodings.size() != 1) throw PackedFault("StringArray is not its only encoding");
        decodeStrings(outer, bytes, rows);
        return;
    }
    if (kind == "ByteArray" && needInteger(outer, "type", 1, 33) >= 32) {
        kind_ = needInteger(outer, "type", 32, 33) == 32 ? Kind::float32 : Kind::float64;
        decodeFloats(bytes, rows);
        return;
    }
    if (kind == "FixedPoint") {
        kind_ = Kind::fixedPoint;
        factor_ = needNumber(outer, "factor");
    } else if (kind == "IntervalQuantization") {
        kind_ = Kind::intervals;
        lowest_ = needNumber(outer, "min");
        factor_ = (needNumber(outer, "max") - lowest_) /
                  static_cast<double>(needInteger(outer, "numSteps", 2, INT32_MAX) - 1);
    }
    integers_ = decodeIntegers(bytes, encodings, kind_ == Kind::integers ? 0 : 1, rows);
    expectSize(integers_.size(), rows);
}

void BcifColumn::decodeFloats(std::string_view bytes, std::size_t rows) {
    const std::size_t size = kind_ == Kind::float32 ? 4 : 8;
    if (bytes.size() % size != 0) throw PackedFault("its bytes are no whole number of values");
    expectSize(bytes.size() / size, rows);
    floats_ = bytes;
}

void BcifColumn::decodeStrings(const MsgpackValue& encoding, std::string_view bytes, std::size_t rows) {
    kind_ = Kind::strings;
    integers_ = decodeIntegers(bytes, encodingsOf(need(encoding, "dataEncoding")), 0, rows);
    expectSize(integers_.size(), rows);
    const std::string_view text = needText(encoding, "stringData");
    // The strings differ, so that one at most is empty; there is one offset more than strings.
    const Integers offsets = decodeIntegers(needBytes(encoding, "offsets"),
                                            encodingsOf(need(encoding, "offsetEncoding")), 0, text.size() + 2);
    for (std::size_t i = 0; i + 1 < offsets.size(); ++i) {
        if (offsets[i] < 0 || offsets[i + 1] < offsets[i] || static_cast<std::size_t>(offsets[i + 1]) > text.size())
            throw PackedFault("an offset of its strings is out of range");
        strings_.push_back(
            text.substr(static_cast<std::size_t>(offsets[i]), static_cast<std::size_t>(offsets[i + 1] - offsets[i])));
    }
    for (const std::int32_t index : integers_)
        if (index < -1 || index >= static_cast<std::int32_t>(strings_.size()))
            throw PackedFault("it refers to a string that is not there");
}

MmcifCell BcifColumn::cell(std::size_t row) const {
    if (!missing_.empty() && missing_[row] != 0) return {};
    switch (kind_) {
        case Kind::integers:
            return MmcifCell(static_cast<double>(integers_[row]));
        case Kind::fixedPoint:
            return MmcifCell(static_cast<double>(integers_[row]) / factor_);
        case Kind::intervals:
            return MmcifCell(lowest_ + factor_ * static_cast<double>(integers_[row]));
        case Kind::float32:
            return MmcifCell(floatAt<float>(floats_, row));
        case Kind::float64:
            return MmcifCell(floatAt<double>(floats_, row));
        case Kind::strings:
            break;
    }
    return integers_[row] < 0 ? MmcifCell() : MmcifCell(strings_[static_cast<std::size_t>(integers_[row])]);
}

}  // namespace nacre
