#pragma once
// Global heaps of HDF5 files, which hold variable-length texts. libhdf5 trusts references into them: damaged files made
// it access memory out of bounds, or loop forever. So they are read here.

#include <cstdint>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>

namespace nacre {

/// Why an HDF5 file cannot be read.
struct Hdf5Fault : std::runtime_error {
    using std::runtime_error::runtime_error;
};

class Hdf5Heaps {
public:
    /// Reads bytes from a position; fewer at the end of the file.
    using Read = std::function<std::string(std::uint64_t at, std::size_t most)>;
    static constexpr std::size_t kReferenceBytes = 16;  ///< length, position of the heap, index in it

    /// @param base  origin of positions
    Hdf5Heaps(Read read, std::uint64_t fileBytes, std::uint64_t base)
        : read_(std::move(read)), fileBytes_(fileBytes), base_(base) {}

    /// Finds heaps on which libhdf5 would loop forever. @param bytes  the start of a file @throws Hdf5Fault
    static void check(std::string_view bytes);

    /// The text, up to its first NUL; empty if the reference is damaged or the text longer than `most`.
    std::string text(std::string_view reference, std::size_t most);

private:
    struct Object {
        std::uint64_t at, size;
    };
    using Objects = std::map<std::uint16_t, Object>;
    const Objects& readObjects(std::uint64_t heap);

    Read read_;
    std::uint64_t fileBytes_, base_;
    std::uint64_t steps_ = 0;
    std::map<std::uint64_t, Objects> known_;
};

}  // namespace nacre
