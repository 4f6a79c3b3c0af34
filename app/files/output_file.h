#pragma once

#include <span>
#include <string>

namespace nacre::app {

/// Whether a name means standard output: "-", /dev/stdout, /dev/fd/1.
bool isStandardOutput(const std::string& path);

/// A file that appears whole or not at all: it is written under another name in the same folder and renamed.
/// The other name is made at once, so that a folder that cannot be written to is refused before any work; nobody
/// foresees it, and nothing that others put there is followed or overwritten. A file that is replaced keeps its
/// permissions. What is for standard output is written to a temporary file and goes there when it is whole.
/// An error, SIGINT, SIGTERM and SIGHUP remove it; what a crash leaves behind, the first that the next run on the same
/// machine makes in the same folder does, and one on another machine once it is ten minutes old. Each is one thread's
/// at a time; several threads may have theirs.
class OutputFile {
public:
    /// @param extension  of the temporary file where standard output has none: ".png"
    /// @throws Error if the folder is missing or not writable, or the path names something that is no plain file
    explicit OutputFile(const std::string& path, const std::string& extension = {});
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    /// Where to write: same folder and extension as the file asked for.
    const std::string& temporary() const { return temporary_; }
    /// For messages.
    const std::string& path() const { return path_; }
    /// Another file that is made on the way, by a library with a mind of its own: removed in the same cases.
    void alsoRemove(const std::string& name);
    /// Puts the file in its place. @throws Error
    void commit();

private:
    void makeTemporary(const std::string& folder, const std::string& extension);
    void copyToStandardOutput() const;

    std::string path_, target_, temporary_, also_;
    int lock_ = -1;  // held as long as the temporary file is somebody's
    bool committed_ = false;
};

/// From now on SIGINT, SIGTERM and SIGHUP remove what is not finished, where they would end the program; the first
/// OutputFile sees to that, too.
void removeUnfinishedOnSignals();

/// Extension in lower case, with the dot; empty if there is none.
std::string extensionOf(const std::string& path);

/// Writes text whole or not at all. @throws Error
void writeText(OutputFile& file, const std::string& text);

/// A file that a command reads or writes.
struct NamedFile {
    const char* name;  ///< of the option: "--stats"
    std::string path;  ///< empty: none; "-": the standard stream
    bool written = false;
};

/// Refuses what would be written over something that is read, or written, by whatever other name, link or stream.
/// @throws std::invalid_argument that names both
void checkApart(std::span<const NamedFile> files);

}  // namespace nacre::app
