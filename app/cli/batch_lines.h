#pragma once
// Jobs as lines of text, from a file or a pipe, and the files that they read and write: no job may overwrite another's
// output or input.

#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <unordered_map>

#include "app/cli/options.h"

namespace nacre::app {

struct BatchLine {
    std::uint64_t number;  ///< 1-based
    std::string text;      ///< its beginning, if it is too long
    bool tooLong = false;
    /// @throws UsageError if it is too long
    const std::string& whole() const;
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
    bool readLine(BatchLine& line);
    bool fill();

    const std::string path_;
    const std::function<bool()> stopped_;
    int file_ = 0;
    bool isFile_ = false;
    std::string buffer_;  ///< bytes read
    std::size_t at_ = 0;  ///< position of the next line
    std::mutex turn_;
    std::uint64_t number_ = 0;
};

/// Files are identified by location, whatever path or link leads there, in 40 bytes each.
class BatchFiles {
public:
    /// @param jobs  the job list itself, which is also read
    explicit BatchFiles(const std::string& jobs);

    /// Records what a job reads and writes; thread-safe. Later jobs are unknown, but pictures and layers have their own
    /// file endings, and stats only replace stats.
    /// @throws UsageError if it would write a file that an earlier job reads or writes
    void claim(const PictureDescription& job);

private:
    std::mutex turn_;
    std::unordered_map<std::size_t, bool> files_;  ///< by location: whether they are written
};

}  // namespace nacre::app
