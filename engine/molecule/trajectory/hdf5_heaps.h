#pragma once
// Global heaps of HDF5 files, which hold texts of any length. libhdf5 trusts what points into them: damaged files made
// it read and write beyond its memory, or never end. So these are read here.

#include <cstdint>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace nacre {

/// Why an HDF5 file cannot be read.
struct Hdf5Fault : std::runtime_error {
    using std::runtime_error::runtime_error;
};

class Hdf5Heaps {
public:
    /// Bytes from a place on; fewer where the file ends.
    using Read = std::function<std::string(std::uint64_t at, std::size_t most)>;
    static constexpr std::size_t kReferenceBytes = 16;  ///< length, place of the heap, number in it

    /// @param base  what places count from
    Hdf5Heaps(Read read, std::uint64_t fileBytes, std::uint64_t base)
        : read_(std::move(read)), fileBytes_(fileBytes), base_(base) {}

    /// Looks for heaps in which libhdf5 would not end. @param bytes  the begin of a file @throws Hdf5Fault
    static void check(std::string_view bytes);

    /// The text, up to its first NUL; empty if the reference is damaged or the text longer than `most`.
    std::string text(std::string_view reference, std::size_t most);

private:
    struct Object {
        std::uint64_t at, size;
    };
    using Objects = std::map<std::uint16_t, Object>;
    const Objects& objectsOf(std::uint64_t heap);

    Read read_;
    std::uint64_t fileBytes_, base_;
    std::uint64_t steps_ = 0;
    std::map<std::uint64_t, Objects> known_;
};

}  // namespace nacre
