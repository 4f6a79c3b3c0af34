#pragma once

#include <cstddef>
#include <cstdint>

namespace nacre::app {

/// An open file to write from its beginning, which keeps the first failure. No write after it does anything.
class CheckedFile {
public:
    /// @param file  stays open
    explicit CheckedFile(int file);
    ~CheckedFile() { finish(); }
    CheckedFile(const CheckedFile&) = delete;
    CheckedFile& operator=(const CheckedFile&) = delete;

    /// Writes at the current place. @returns whether nothing failed so far
    bool write(const void* bytes, std::size_t size);
    /// Reads what was written. @returns the number of bytes
    std::size_t read(void* bytes, std::size_t size);
    void seek(std::uint64_t place) { place_ = place; }
    std::uint64_t place() const { return place_; }
    std::uint64_t size() const { return size_; }
    int failure() const { return failure_; }  ///< errno of the first failure; 0: none
    /// Closes the file. @returns failure()
    int finish();

private:
    int file_ = -1;
    int failure_ = 0;
    std::uint64_t place_ = 0, size_ = 0;
};

}  // namespace nacre::app
