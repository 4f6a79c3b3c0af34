#include "engine/molecule/formats/packed_integers.h"

namespace nacre {

namespace {

template <typename Wire>
Integers convert(std::string_view bytes, ByteOrder order) {
    Integers values(bytes.size() / sizeof(Wire));
    const auto* data = reinterpret_cast<const unsigned char*>(bytes.data());
    for (std::size_t i = 0; i < values.size(); ++i) {
        std::uint32_t bits = 0;
        for (std::size_t k = 0; k < sizeof(Wire); ++k) {
            const std::size_t byte = order == ByteOrder::little ? k : sizeof(Wire) - 1 - k;
            bits |= std::uint32_t{data[i * sizeof(Wire) + byte]} << 8 * k;
        }
        values[i] = static_cast<std::int32_t>(static_cast<Wire>(bits));  // NOLINT(bugprone-signed-char-misuse): numbers
    }
    return values;
}

[[noreturn]] void wrongSize(std::size_t size) {
    throw PackedFault("its packed values are not the " + std::to_string(size) + " announced");
}

}  // namespace

Integers integersFromBytes(std::string_view bytes, IntegerType type, ByteOrder order) {
    if (bytes.size() % type.bytes != 0) throw PackedFault("its bytes are no whole number of values");
    if (type.bytes == 1)
        return type.isSigned ? convert<std::int8_t>(bytes, order) : convert<std::uint8_t>(bytes, order);
    if (type.bytes == 2)
        return type.isSigned ? convert<std::int16_t>(bytes, order) : convert<std::uint16_t>(bytes, order);
    Integers values = convert<std::int32_t>(bytes, order);
    if (!type.isSigned)
        for (const std::int32_t value : values)
            if (value < 0) throw PackedFault("a value exceeds 2147483647");
    return values;
}

Integers unpackExtremes(const Integers& packed, IntegerType type, std::size_t size) {
    if (packed.size() < size) wrongSize(size);
    const auto bits = static_cast<unsigned>(8 * type.bytes);
    const std::int32_t high = type.isSigned ? (1 << (bits - 1)) - 1 : (1 << bits) - 1;
    const std::int32_t low = type.isSigned ? -high - 1 : -1;  // -1: never met among unsigned values
    Integers values(size);
    std::size_t count = 0;
    std::uint32_t sum = 0;
    for (const std::int32_t part : packed) {
        if (count == size) wrongSize(size);
        sum += static_cast<std::uint32_t>(part);
        if (part == high || part == low) continue;
        values[count++] = static_cast<std::int32_t>(sum);
        sum = 0;
    }
    if (count != size) wrongSize(size);
    return values;
}

Integers expandRuns(const Integers& runs, std::size_t size) {
    if (runs.size() % 2 != 0) wrongSize(size);
    std::size_t total = 0;
    for (std::size_t i = 1; i < runs.size(); i += 2) {
        if (runs[i] < 0 || static_cast<std::size_t>(runs[i]) > size - total) wrongSize(size);
        total += static_cast<std::size_t>(runs[i]);
    }
    if (total != size) wrongSize(size);
    Integers values;
    values.reserve(size);
    for (std::size_t i = 0; i < runs.size(); i += 2)
        values.insert(values.end(), static_cast<std::size_t>(runs[i + 1]), runs[i]);
    return values;
}

void sumDeltas(Integers& values, std::int32_t origin) {
    auto sum = static_cast<std::uint32_t>(origin);
    for (std::int32_t& value : values) {
        sum += static_cast<std::uint32_t>(value);
        value = static_cast<std::int32_t>(sum);
    }
}

}  // namespace nacre
