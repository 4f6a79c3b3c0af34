#pragma once

#include <cstddef>
#include <cstdint>

namespace nacre::app {

/// Writes an open file from its beginning, and keeps the first failure. Later writes do nothing.
class CheckedFile {
public:
    /// @param file  a descriptor, which stays open
    explicit CheckedFile(int file);
    ~CheckedFile() { finish(); }
    CheckedFile(const CheckedFile&) = delete;
    CheckedFile& operator=(const CheckedFile&) = delete;

    /// Writes at the current position. @returns whether nothing failed so far
    bool write(const void* bytes, std::size_t size);
    void seek(std::uint64_t place) { place_ = place; }
    std::uint64_t place() const { return place_; }
    int failure() const { return failure_; }  ///< errno of the first failure; 0: none
    /// Closes its own descriptor. @returns failure()
    int finish();

private:
    int file_ = -1;
    int failure_ = 0;
    std::uint64_t place_ = 0;
};

}  // namespace nacre::app
