#pragma once
// Bytes that are read, and written, as they are needed instead of being held. Must also compile as C++17.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

namespace nacre {

/// A plain file; or a temporary one without a name, which goes when this does, however the program ends. Several
/// threads may read at once.
class ByteFile {
public:
    /// @returns null if it is not there, or no plain file
    static std::shared_ptr<ByteFile> open(const std::string& path);
    /// In TMPDIR, else /var/tmp, else /tmp. @returns null if there is no room for files
    static std::shared_ptr<ByteFile> temporary();
    ~ByteFile();
    ByteFile(const ByteFile&) = delete;
    ByteFile& operator=(const ByteFile&) = delete;

    std::uint64_t size() const { return size_; }
    /// @throws Error if the file does not hold that, or not any more
    void read(std::uint64_t at, void* to, std::size_t count) const;
    /// @returns whether there was room for it
    bool append(const void* bytes, std::size_t count);

private:
    ByteFile(int file, std::uint64_t size) : file_(file), size_(size) {}

    int file_;
    std::uint64_t size_;
};

}  // namespace nacre
