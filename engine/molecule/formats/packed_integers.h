#pragma once
// The integer codecs shared by BinaryCIF (github.com/molstar/BinaryCIF) and MMTF (mmtf.rcsb.org's specification), as
// streams: values are decoded in blocks, so that a few bytes for millions of values take no memory.

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string_view>

namespace nacre {

/// An error in packed data; the reader turns it into an Error that names the file and the field.
struct PackedFault : std::runtime_error {
    using std::runtime_error::runtime_error;
};

enum class ByteOrder { little, big };

struct IntegerType {
    std::size_t bytes = 4;  ///< 1, 2 or 4
    bool isSigned = true;
};

/// A stream of values.
class Integers {
public:
    virtual ~Integers() = default;
    Integers(const Integers&) = delete;
    Integers& operator=(const Integers&) = delete;

    /// Moves to the next value; false after the last. @throws PackedFault if the data is malformed
    bool next(std::int32_t& value) {
        if (at_ == size_) {
            at_ = 0;
            size_ = fill(block_.data(), block_.size());
            if (size_ == 0) return false;
        }
        value = block_[at_++];
        return true;
    }

protected:
    Integers() = default;
    /// Writes the next values, at most `most` of them. @return how many; 0 at the end
    virtual std::size_t fill(std::int32_t* values, std::size_t most) = 0;

private:
    std::array<std::int32_t, 256> block_;
    std::size_t at_ = 0, size_ = 0;
};
using IntegersPointer = std::unique_ptr<Integers>;

/// Array of integers, which must outlive the stream. @throws PackedFault if the size is no multiple of theirs; the
/// stream throws for values above 2^31 - 1
IntegersPointer integersFromBytes(std::string_view bytes, IntegerType type, ByteOrder order);

/// Sums runs of the type's extreme values with the value after them ("integer packing", "recursive indexing").
IntegersPointer unpackExtremes(IntegersPointer packed, IntegerType type);

/// Pairs of value and count.
IntegersPointer expandRuns(IntegersPointer runs);

/// Running sums; they wrap at 32 bits, which encoders rely on.
IntegersPointer sumDeltas(IntegersPointer values, std::int32_t origin);

/// The same values, which must number exactly `size`. The stream throws PackedFault at one more, or at the end if there
/// are fewer.
IntegersPointer exactly(IntegersPointer values, std::size_t size);

}  // namespace nacre
