#pragma once
// Bytes read and written on demand instead of held in memory. Must also compile as C++17.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

namespace nacre {

/// A regular file, or an unnamed temporary one, which the system removes when the program ends. Several threads may
/// read at once.
class ByteFile {
public:
    /// @returns null if it does not exist or is not a regular file
    static std::shared_ptr<ByteFile> open(const std::string& path);
    /// Why open() has just returned null.
    static std::string whyNotOpened(const std::string& path);
    /// In TMPDIR, else /var/tmp, else /tmp. @returns null if no file can be made
    static std::shared_ptr<ByteFile> temporary();
    ~ByteFile();
    ByteFile(const ByteFile&) = delete;
    ByteFile& operator=(const ByteFile&) = delete;

    std::uint64_t size() const { return size_; }
    /// @throws Error if the file does not (or no longer) contain these bytes
    void read(std::uint64_t at, void* to, std::size_t count) const;
    /// @returns false if there is no space left
    bool append(const void* bytes, std::size_t count);

private:
    ByteFile(int file, std::uint64_t size) : file_(file), size_(size) {}

    int file_;
    std::uint64_t size_;
};

}  // namespace nacre
