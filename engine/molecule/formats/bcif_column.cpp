#include "engine/molecule/formats/bcif_column.h"

#include <bit>
#include <type_traits>

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
std::vector<MsgpackValue> readEncodings(const MsgpackValue& list) {
    std::vector<MsgpackValue> encodings;
    MsgpackElements elements(list);
    for (MsgpackValue encoding; elements.next(encoding);) {
        if (encodings.size() == kMaxEncodings) throw PackedFault("it has too many encodings");
        encodings.push_back(encoding);
    }
    if (encodings.empty()) throw PackedFault("it has no encoding");
    return encodings;
}

/// Checks the number of values that an encoding states.
IntegersPointer ofSourceSize(IntegersPointer values, const MsgpackValue& encoding) {
    return exactly(std::move(values), static_cast<std::size_t>(needInteger(encoding, "srcSize", 0, INT32_MAX)));
}

IntegersPointer byteArray(std::string_view bytes, const MsgpackValue& encoding) {
    static constexpr IntegerType kTypes[] = {{1, true}, {2, true}, {4, true}, {1, false}, {2, false}, {4, false}};
    const auto type = static_cast<std::size_t>(needInteger(encoding, "type", 1, 6));
    return integersFromBytes(bytes, kTypes[type - 1], ByteOrder::little);
}

/// Undoes one encoding of integers.
IntegersPointer undo(const MsgpackValue& encoding, IntegersPointer values) {
    const std::string_view kind = needText(encoding, "kind");
    if (kind == "Delta")
        return sumDeltas(std::move(values),
                         static_cast<std::int32_t>(needInteger(encoding, "origin", INT32_MIN, INT32_MAX)));
    if (kind == "RunLength") return ofSourceSize(expandRuns(std::move(values)), encoding);
    if (kind == "IntegerPacking") {
        IntegerType type;
        type.bytes = static_cast<std::size_t>(needInteger(encoding, "byteCount", 1, 2));
        type.isSigned = need(encoding, "isUnsigned").integer == 0;
        return ofSourceSize(unpackExtremes(std::move(values), type), encoding);
    }
    throw PackedFault("unknown encoding, or out of place: '" + std::string(kind.substr(0, 32)) + "'");
}

/// @param encodings the last one is ByteArray; those from `first` on are undone
IntegersPointer decodeIntegers(std::string_view bytes, const std::vector<MsgpackValue>& encodings, std::size_t first) {
    if (first >= encodings.size() || needText(encodings.back(), "kind") != "ByteArray")
        throw PackedFault("its last encoding is not ByteArray");
    IntegersPointer values = byteArray(bytes, encodings.back());
    for (std::size_t i = encodings.size() - 1; i-- > first;) values = undo(encodings[i], std::move(values));
    return values;
}

template <typename Float>
double takeFloat(std::string_view& bytes) {
    std::uint64_t bits = 0;
    for (std::size_t k = sizeof(Float); k-- > 0;) bits = bits << 8 | static_cast<unsigned char>(bytes[k]);
    bytes.remove_prefix(sizeof(Float));
    using Bits = std::conditional_t<sizeof(Float) == 4, std::uint32_t, std::uint64_t>;
    return static_cast<double>(std::bit_cast<Float>(static_cast<Bits>(bits)));
}

}  // namespace

BcifColumn::BcifColumn(const MsgpackValue& column, std::size_t rows, std::size_t mostStrings)
    : mostStrings_(mostStrings) {
    decode(need(column, "data"), rows);
    const auto mask = column.find("mask");
    if (!mask || mask->is(MsgpackValue::Kind::nothing)) return;
    missing_ = exactly(decodeIntegers(needBytes(*mask, "data"), readEncodings(need(*mask, "encoding")), 0), rows);
}

void BcifColumn::decode(const MsgpackValue& data, std::size_t rows) {
    const std::string_view bytes = needBytes(data, "data");
    const std::vector<MsgpackValue> encodings = readEncodings(need(data, "encoding"));
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
    integers_ = exactly(decodeIntegers(bytes, encodings, kind_ == Kind::integers ? 0 : 1), rows);
}

void BcifColumn::decodeFloats(std::string_view bytes, std::size_t rows) {
    const std::size_t size = kind_ == Kind::float32 ? 4 : 8;
    if (bytes.size() % size != 0) throw PackedFault("its size is not a whole number of values");
    if (bytes.size() / size != rows)
        throw PackedFault("it has " + std::to_string(bytes.size() / size) + " values in " + std::to_string(rows) +
                          " rows");
    floats_ = bytes;
}

void BcifColumn::decodeStrings(const MsgpackValue& encoding, std::string_view bytes, std::size_t rows) {
    kind_ = Kind::strings;
    integers_ = exactly(decodeIntegers(bytes, readEncodings(need(encoding, "dataEncoding")), 0), rows);
    text_ = needText(encoding, "stringData");
    const IntegersPointer offsets =
        decodeIntegers(needBytes(encoding, "offsets"), readEncodings(need(encoding, "offsetEncoding")), 0);
    for (std::int32_t offset = 0; offsets->next(offset);) {
        const std::int64_t last = offsets_.empty() ? 0 : offsets_.back();
        if (offset < last || static_cast<std::size_t>(offset) > text_.size())
            throw PackedFault("an offset of its strings is out of range");
        if (offsets_.size() > mostStrings_)
            throw PackedFault("it has more than " + std::to_string(mostStrings_) + " different strings");
        offsets_.push_back(static_cast<std::uint32_t>(offset));
    }
}

std::string_view BcifColumn::string(std::int32_t index) const {
    const auto at = static_cast<std::size_t>(index);  // a negative index becomes too large
    if (at + 1 >= offsets_.size() || index < 0) throw PackedFault("it refers to a string that is not there");
    return text_.substr(offsets_[at], offsets_[at + 1] - offsets_[at]);
}

MmcifCell BcifColumn::next() {
    std::int32_t missing = 0, value = 0;
    if (missing_) missing_->next(missing);  // throws if the mask is too short, like the values
    if (kind_ == Kind::float32 || kind_ == Kind::float64) {
        const double number = kind_ == Kind::float32 ? takeFloat<float>(floats_) : takeFloat<double>(floats_);
        return missing == 0 ? MmcifCell(number) : MmcifCell();
    }
    integers_->next(value);
    if (missing != 0) return {};
    const auto number = static_cast<double>(value);
    switch (kind_) {
        case Kind::fixedPoint:
            return MmcifCell(number / factor_);
        case Kind::intervals:
            return MmcifCell(lowest_ + factor_ * number);
        case Kind::strings:
            return value == -1 ? MmcifCell() : MmcifCell(string(value));
        default:
            return MmcifCell(number);
    }
}

void BcifColumn::finish() {
    std::int32_t value = 0;
    if (missing_) missing_->next(value);  // throws if there is one too many
    if (integers_) integers_->next(value);
}

}  // namespace nacre
