#pragma once
// Which files the jobs of a batch read and write, so that none undoes another's work, or takes away what it reads.

#include <mutex>
#include <string>
#include <unordered_map>

#include "app/cli/options.h"

namespace nacre::app {

/// Files are known by where they are, whatever path or link leads there, in 40 bytes each.
class BatchFiles {
public:
    /// @param jobs  the file that lists them, which is read, too
    explicit BatchFiles(const std::string& jobs);

    /// Takes note of what a job reads and writes; several threads may. What is to come cannot be known: but pictures
    /// and layers have names of their own kind, and stats only take the place of stats.
    /// @throws UsageError if it would write what an earlier job reads or writes
    void claim(const PictureDescription& job);

private:
    std::mutex turn_;
    std::unordered_map<std::size_t, bool> files_;  ///< by their places: whether they are written
};

}  // namespace nacre::app
