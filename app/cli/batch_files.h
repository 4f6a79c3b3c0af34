#pragma once
// Files that the jobs of a batch read and write: no job may overwrite another's output or input.

#include <mutex>
#include <string>
#include <unordered_map>

#include "app/cli/options.h"

namespace nacre::app {

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
