#pragma once

#include <string>

namespace nacre::app {

/// A file that appears whole or not at all: it is written under another name in the same folder and renamed.
/// The other name is made at once, so that a folder that cannot be written to is refused before any work.
/// An error, SIGINT, SIGTERM and SIGHUP remove it. For one thread at a time.
class OutputFile {
public:
    /// @throws Error if the folder is missing or not writable, or the path names a folder
    explicit OutputFile(const std::string& path);
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    /// Where to write: same folder and extension as the file asked for.
    const std::string& temporary() const { return temporary_; }
    const std::string& path() const { return path_; }
    /// Another file that is made on the way, by a library with a mind of its own: removed in the same cases.
    void alsoRemove(const std::string& name);
    /// Puts the file in its place. @throws Error
    void commit();

private:
    std::string path_, target_, temporary_, also_;
    bool committed_ = false;
};

/// Extension in lower case, with the dot; empty if there is none.
std::string extensionOf(const std::string& path);

/// Writes text whole or not at all. @throws Error
void writeText(OutputFile& file, const std::string& text);

}  // namespace nacre::app
