#pragma once
// Copies of files from other apps. Permission to read them ends with the activity, so documents are copied, and remain
// available when the view is restored.

#include <cstddef>
#include <functional>
#include <string>

namespace nacre::app {

/// Reads a document's bytes. @returns how many; 0 at its end. @throws any error
using ReadBytes = std::function<std::size_t(char* to, std::size_t most)>;

class OpenedFiles {
public:
    static constexpr std::size_t kMostFiles = 8;             ///< older ones are removed
    static constexpr std::uint64_t kMostBytes = 512u << 20;  ///< per file

    /// @param folder created on the first write
    explicit OpenedFiles(std::string folder) : folder_(std::move(folder)) {}

    /// Copies a document. @param name from the other app: any text
    /// @returns the copy's path. @throws Error if it is too large or the disk is full
    std::string keep(const std::string& name, const ReadBytes& read) const;

private:
    void trim() const;

    std::string folder_;
};

}  // namespace nacre::app
