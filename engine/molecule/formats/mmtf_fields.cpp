#include "engine/molecule/formats/mmtf_fields.h"

#include <algorithm>
#include <bit>

#include "engine/molecule/text.h"

namespace nacre {

namespace {

constexpr std::size_t kHeader = 12;
constexpr IntegerType kInt8{1, true}, kInt16{2, true}, kInt32{4, true};

IntegersPointer bigEndian(std::string_view bytes, IntegerType type) {
    return integersFromBytes(bytes, type, ByteOrder::big);
}

/// Codecs that yield floats: integers to be divided by the parameter.
bool isDivided(std::int32_t codec) { return codec >= 9 && codec <= 13; }

}  // namespace

MmtfFields::MmtfFields(const std::string& name, std::string_view document)
    : name_(name), bytes_(document.size()), root_(parseMsgpack(name, document)) {}

void MmtfFields::fail(const std::string& why) const { cannotRead(name_, why); }

std::size_t MmtfFields::count(const char* field, std::size_t limit) const {
    const auto value = root_.find(field);
    const auto number = value ? value->asInteger() : std::nullopt;
    if (!number || *number < 0 || static_cast<std::uint64_t>(*number) > std::min(bytes_, limit))
        fail(std::string(field) + " is missing or impossible");
    return static_cast<std::size_t>(*number);
}

std::string MmtfFields::text(const char* field) const {
    const auto value = root_.find(field);
    return std::string(value ? value->asText().value_or("") : "");
}

bool MmtfFields::has(const char* field) const {
    const auto value = root_.find(field);
    return value && !value->is(MsgpackValue::Kind::nothing);
}

MmtfFields::Encoded MmtfFields::encoded(const char* field, std::size_t size) const {
    const auto value = root_.find(field);
    if (!value || !value->is(MsgpackValue::Kind::binary) || value->bytes.size() < kHeader)
        fail(std::string(field) + " is missing or not an encoded array");
    std::int32_t header[3] = {};
    const IntegersPointer words = bigEndian(value->bytes.substr(0, kHeader), kInt32);
    for (std::int32_t& word : header) words->next(word);
    if (header[1] < 0 || static_cast<std::size_t>(header[1]) != size)
        fail(std::string(field) + " announces " + std::to_string(header[1]) + " values instead of " +
             std::to_string(size));
    return {header[0], header[2], value->bytes.substr(kHeader)};
}

MmtfIntegers MmtfFields::decode(const char* field, const Encoded& array, std::size_t size) const {
    const auto values = [&]() -> IntegersPointer {
        switch (array.codec) {
            case 2:
                return bigEndian(array.data, kInt8);
            case 3:
            case 11:
                return bigEndian(array.data, kInt16);
            case 4:
                return bigEndian(array.data, kInt32);
            case 6:
            case 7:
            case 9:
                return expandRuns(bigEndian(array.data, kInt32));
            case 8:
                return sumDeltas(expandRuns(bigEndian(array.data, kInt32)), 0);
            case 10:
                return sumDeltas(unpackExtremes(bigEndian(array.data, kInt16), kInt16), 0);
            case 12:
            case 14:
                return unpackExtremes(bigEndian(array.data, kInt16), kInt16);
            case 13:
            case 15:
                return unpackExtremes(bigEndian(array.data, kInt8), kInt8);
            case 16:
                return expandRuns(bigEndian(array.data, kInt8));
            default:
                throw PackedFault("its codec " + std::to_string(array.codec) + " is unknown or yields no numbers");
        }
    };
    MmtfIntegers result;
    result.fields_ = this;
    result.field_ = field;
    try {
        result.values_ = exactly(values(), size);
    } catch (const PackedFault& fault) {
        fail(std::string(field) + ": " + fault.what());
    }
    return result;
}

MmtfIntegers MmtfFields::integers(const char* field, std::size_t size) const {
    const Encoded array = encoded(field, size);
    if (isDivided(array.codec)) fail(std::string(field) + ": it holds no whole numbers");
    return decode(field, array, size);
}

MmtfIntegers MmtfFields::integers(const char* field, std::size_t size, std::int32_t otherwise) const {
    if (has(field)) return integers(field, size);
    MmtfIntegers same;
    same.otherwise_ = otherwise;
    return same;
}

MmtfFloats MmtfFields::floats(const char* field, std::size_t size) const {
    Encoded array = encoded(field, size);
    MmtfFloats numbers;
    numbers.bits_ = array.codec == 1;
    if (isDivided(array.codec)) numbers.divisor_ = array.parameter;  // without a divisor the value itself
    if (numbers.bits_) array.codec = 4;
    numbers.values_ = decode(field, array, size);
    return numbers;
}

MmtfFloats MmtfFields::floats(const char* field, std::size_t size, std::int32_t otherwise) const {
    if (has(field)) return floats(field, size);
    MmtfFloats same;
    same.values_.otherwise_ = otherwise;
    return same;
}

std::int32_t MmtfIntegers::next() {
    if (!values_) return otherwise_;
    try {
        std::int32_t value = 0;
        if (!values_->next(value)) throw PackedFault("it has too few values");
        return value;
    } catch (const PackedFault& fault) {
        fields_->fail(std::string(field_) + ": " + fault.what());
    }
}

float MmtfFloats::next() {
    const std::int32_t value = values_.next();
    return bits_ ? std::bit_cast<float>(value) : static_cast<float>(value / divisor_);
}

std::vector<std::string_view> MmtfFields::names(const char* field, std::size_t size) const {
    const Encoded array = encoded(field, size);
    constexpr std::int32_t kLongest = 64;
    if (array.codec != 5 || array.parameter < 1 || array.parameter > kLongest ||
        array.data.size() != size * static_cast<std::size_t>(array.parameter))
        fail(std::string(field) + " is not an array of " + std::to_string(size) + " names");
    std::vector<std::string_view> names(size);
    const auto length = static_cast<std::size_t>(array.parameter);
    for (std::size_t i = 0; i < size; ++i) {
        const std::string_view padded = array.data.substr(i * length, length);
        names[i] = trim(padded.substr(0, padded.find('\0')));
    }
    return names;
}

}  // namespace nacre
