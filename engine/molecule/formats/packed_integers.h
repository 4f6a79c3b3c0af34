#pragma once
// The integer codecs that BinaryCIF (github.com/molstar/BinaryCIF) and MMTF (mmtf.rcsb.org's specification) share.
// Each takes the size that must come out, known from elsewhere and bounded by the file, before it allocates.

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace nacre {

using Integers = std::vector<std::int32_t>;

/// What is wrong with packed data; the reader turns it into an Error that names the file and the field.
struct PackedFault : std::runtime_error {
    using std::runtime_error::runtime_error;
};

enum class ByteOrder { little, big };

struct IntegerType {
    std::size_t bytes = 4;  ///< 1, 2 or 4
    bool isSigned = true;
};

/// Array of integers. @throws PackedFault if the size is no whole number of them, or one exceeds 2^31 - 1
Integers integersFromBytes(std::string_view bytes, IntegerType type, ByteOrder order);

/// Sums runs of the type's extreme values with the value after them ("integer packing", "recursive indexing").
/// @throws PackedFault unless exactly `size` values come out
Integers unpackExtremes(const Integers& packed, IntegerType type, std::size_t size);

/// Pairs of value and count. @throws PackedFault unless exactly `size` values come out
Integers expandRuns(const Integers& runs, std::size_t size);

/// Running sums, in place; they wrap at 32 bits, as encoders count on.
void sumDeltas(Integers& values, std::int32_t origin);

}  // namespace nacre
