#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace nacre::app {

/// A path under which this process opens the file of a descriptor anew.
std::string pathOfDescriptor(int descriptor);

/// Over a limit on file sizes, writing then fails like on a full disk, where SIGXFSZ would end the program.
void failOverFileSize();

/// A file without a name: nobody else finds it, and it is gone with this object, however the process ends.
class UnnamedFile {
public:
    enum class Place {
        memory,  ///< where the system has such files; else as `disk`
        disk,    ///< in TMPDIR
    };
    /// @throws Error if there is no room
    explicit UnnamedFile(Place place = Place::memory);
    ~UnnamedFile();
    UnnamedFile(const UnnamedFile&) = delete;
    UnnamedFile& operator=(const UnnamedFile&) = delete;

    int descriptor() const { return file_; }
    std::string path() const { return pathOfDescriptor(file_); }
    std::uint64_t size() const;

    /// @throws Error if there is no room
    void append(std::string_view bytes);
    /// Reads up to `count` bytes. @returns how many there were @throws Error
    std::size_t read(std::uint64_t at, char* to, std::size_t count) const;
    /// All of it. @throws Error
    std::string bytes() const;
    /// All of it, piece by piece. @throws Error
    void eachPiece(const std::function<void(std::string_view)>& take) const;

private:
    int file_;
};

}  // namespace nacre::app
