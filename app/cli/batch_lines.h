#pragma once
// Jobs as lines of text, from a file or a pipe.

#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <string>

namespace nacre::app {

struct BatchLine {
    std::uint64_t number;  ///< 1-based
    std::string text;
};

/// The lines of a file or of standard input, one at a time; thread-safe.
class BatchLines {
public:
    /// @param stopped  polled while waiting for a pipe: true ends the lines @throws Error
    BatchLines(const std::string& path, std::function<bool()> stopped);
    ~BatchLines();
    BatchLines(const BatchLines&) = delete;
    BatchLines& operator=(const BatchLines&) = delete;

    /// The next line that is not empty; none at the end. @throws Error
    std::optional<BatchLine> next();
    /// Whether it can be read again: a file can, a pipe cannot.
    bool isFile() const { return isFile_; }

private:
    bool readLine(std::string& text);
    bool fill();

    static constexpr std::size_t kLongestLine = 1 << 20;
    const std::string path_;
    const std::function<bool()> stopped_;
    int file_ = 0;
    bool isFile_ = false;
    std::string buffer_;  ///< bytes read
    std::size_t at_ = 0;  ///< position of the next line
    std::mutex turn_;
    std::uint64_t number_ = 0;
};

}  // namespace nacre::app
