#pragma once
// Copies of the files that other apps handed over. Their leave to read ends with the activity, so what is opened is
// copied, and is still there when the view is restored.

#include <cstddef>
#include <functional>
#include <string>

namespace nacre::app {

/// Hands out a document's bytes. @returns how many; 0 at its end. @throws whatever went wrong
using ReadBytes = std::function<std::size_t(char* to, std::size_t most)>;

class OpenedFiles {
public:
    static constexpr std::size_t kMostFiles = 8;             ///< older ones go
    static constexpr std::uint64_t kMostBytes = 512u << 20;  ///< of one

    /// @param folder made when first written to
    explicit OpenedFiles(std::string folder) : folder_(std::move(folder)) {}

    /// Copies a document. @param name that the other app gave it: anything at all
    /// @returns the copy's path. @throws Error if it is too large or the disk is full
    std::string keep(const std::string& name, const ReadBytes& read) const;

private:
    void trim() const;

    std::string folder_;
};

}  // namespace nacre::app
