#include "engine/molecule/formats/mmtf_fields.h"

#include <algorithm>
#include <cstring>

#include "engine/error.h"
#include "engine/molecule/text.h"

namespace nacre {

namespace {

constexpr std::size_t kHeader = 12;
constexpr IntegerType kInt8{1, true}, kInt16{2, true}, kInt32{4, true};

Integers bigEndian(std::string_view bytes, IntegerType type) { return integersFromBytes(bytes, type, ByteOrder::big); }

/// Codecs that yield floats: integers to be divided by the parameter.
bool isDivided(std::int32_t codec) { return codec >= 9 && codec <= 13; }

}  // namespace

MmtfFields::MmtfFields(const std::string& name, std::string_view document)
    : name_(name), bytes_(document.size()), root_(parseMsgpack(name, document)) {}

void MmtfFields::fail(const std::string& why) const { throw Error("cannot read molecule", name_, why); }

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
        fail(std::string(field) + " is missing or is no encoded array");
    const Integers header = bigEndian(value->bytes.substr(0, kHeader), kInt32);
    if (header[1] < 0 || static_cast<std::size_t>(header[1]) != size)
        fail(std::string(field) + " announces " + std::to_string(header[1]) + " values instead of " +
             std::to_string(size));
    return {header[0], header[2], value->bytes.substr(kHeader)};
}

Integers MmtfFields::decode(const Encoded& array, std::size_t size) const {
    Integers values;
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
            return expandRuns(bigEndian(array.data, kInt32), size);
        case 8:
            values = expandRuns(bigEndian(array.data, kInt32), size);
            sumDeltas(values, 0);
            return values;
        case 10:
            values = unpackExtremes(bigEndian(array.data, kInt16), kInt16, size);
            sumDeltas(values, 0);
            return values;
        case 12:
        case 14:
            return unpackExtremes(bigEndian(array.data, kInt16), kInt16, size);
        case 13:
        case 15:
            return unpackExtremes(bigEndian(array.data, kInt8), kInt8, size);
        case 16:
            return expandRuns(bigEndian(array.data, kInt8), size);
        default:
            throw PackedFault("its codec " + std::to_string(array.codec) + " is unknown or yields no numbers");
    }
}

Integers MmtfFields::integers(const char* field, std::size_t size) const {
    const Encoded array = encoded(field, size);
    try {
        if (isDivided(array.codec)) throw PackedFault("it holds no whole numbers");
        Integers values = decode(array, size);
        if (values.size() != size) throw PackedFault("it has " + std::to_string(values.size()) + " values");
        return values;
    } catch (const PackedFault& fault) {
        fail(std::string(field) + ": " + fault.what());
    }
}

std::vector<float> MmtfFields::floats(const char* field, std::size_t size) const {
    const Encoded array = encoded(field, size);
    try {
        // Codec 1 has the bits of floats; what is not divided counts as it is.
        const Integers values = array.codec == 1 ? bigEndian(array.data, kInt32) : decode(array, size);
        if (values.size() != size) throw PackedFault("it has " + std::to_string(values.size()) + " values");
        std::vector<float> numbers(size);
        const double divisor = isDivided(array.codec) ? array.parameter : 1;
        for (std::size_t i = 0; i < size; ++i) numbers[i] = static_cast<float>(values[i] / divisor);
        if (array.codec == 1 && size > 0) std::memcpy(numbers.data(), values.data(), size * sizeof(float));
        return numbers;
    } catch (const PackedFault& fault) {
        fail(std::string(field) + ": " + fault.what());
    }
}

std::vector<std::string> MmtfFields::names(const char* field, std::size_t size) const {
    const Encoded array = encoded(field, size);
    constexpr std::int32_t kLongest = 64;
    if (array.codec != 5 || array.parameter < 1 || array.parameter > kLongest ||
        array.data.size() != size * static_cast<std::size_t>(array.parameter))
        fail(std::string(field) + " is no array of " + std::to_string(size) + " names");
    std::vector<std::string> names(size);
    const auto length = static_cast<std::size_t>(array.parameter);
    for (std::size_t i = 0; i < size; ++i) {
        const std::string_view padded = array.data.substr(i * length, length);
        names[i] = std::string(trim(padded.substr(0, padded.find('\0'))));
    }
    return names;
}

}  // namespace nacre
