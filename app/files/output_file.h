#pragma once

#include <span>
#include <string>

namespace nacre::app {

/// Whether a name means standard output: "-", /dev/stdout, /dev/fd/1.
bool isStandardOutput(const std::string& path);

/// A file that appears complete or not at all: written under a temporary name in the same folder and renamed. The
/// temporary file is created at once, so that an unwritable folder is refused before any work; its name is
/// unpredictable, and files of others are neither followed nor overwritten. A replaced file keeps its permissions.
/// Standard output receives the complete temporary file. Errors and signals that end the program remove it. The first
/// OutputFile in a folder removes leftovers of crashes there; those of other machines once they are ten minutes old.
/// Each object is for one thread at a time.
class OutputFile {
public:
    /// @param extension  of the temporary file for standard output: ".png"
    /// @throws Error if the folder is missing or not writable, or the path is not a regular file
    explicit OutputFile(const std::string& path, const std::string& extension = {});
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    /// Path to write to: same folder and extension as the final file.
    const std::string& temporary() const { return temporary_; }
    /// The same file, open for reading and writing.
    int descriptor() const { return lock_; }
    /// For messages.
    const std::string& path() const { return path_; }
    /// Registers another temporary file, made by a library: removed in the same cases.
    void alsoRemove(const std::string& name);
    /// Moves the file to its place. @throws Error
    void commit();

private:
    void makeTemporary(const std::string& folder, const std::string& extension);
    void copyToStandardOutput() const;

    std::string path_, target_, temporary_, also_;
    int lock_ = -1;  // held while the temporary file is in use
    bool committed_ = false;
};

/// From now on SIGINT, SIGTERM, SIGHUP, SIGPIPE and SIGXCPU remove unfinished files, if they would end the program; the
/// first OutputFile also sets this up.
void removeUnfinishedOnSignals();

/// Registers a temporary file, or a folder of such files, for these signals; keepOnSignals() ends that.
void removeOnSignals(const std::string& temporary);
void keepOnSignals(const std::string& temporary);

/// Removes the temporary files that are being written. Their writers fail.
void removeUnfinishedFiles();

/// Extension in lower case, with the dot; empty if there is none.
std::string fileExtension(const std::string& path);

/// Writes a text, completely or not at all. @throws Error
void writeText(OutputFile& file, const std::string& text);

/// A file that a command reads or writes.
struct NamedFile {
    const char* name;  ///< of the option: "--stats"
    std::string path;  ///< empty: none; "-": the standard stream
    bool written = false;
};

/// Refuses to write over a file that is read or written, also by another name, link or stream.
/// @throws std::invalid_argument that names both
void checkApart(std::span<const NamedFile> files);

}  // namespace nacre::app
