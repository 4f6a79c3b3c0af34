#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace nacre::app {

/// A path under which this process can open the descriptor's file again.
std::string pathOfDescriptor(int descriptor);

/// Makes writing over a limit on file sizes fail like on a full disk, instead of ending the program by SIGXFSZ.
void failOverFileSize();

/// A file without a name: nobody else can find it, and it disappears with this object, however the process ends.
class UnnamedFile {
public:
    enum class Place {
        memory,  ///< if the system has such files; else as `disk`
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
    /// Reads up to `count` bytes. @returns the number read @throws Error
    std::size_t read(std::uint64_t at, char* to, std::size_t count) const;
    /// The whole content. @throws Error
    std::string bytes() const;
    /// The whole content, in pieces. @throws Error
    void eachPiece(const std::function<void(std::string_view)>& take) const;

private:
    int file_;
};

}  // namespace nacre::app
