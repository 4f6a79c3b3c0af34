#pragma once
// A file written sequentially, with every failure reported.

#include <cstddef>
#include <cstdint>
#include <string>

#include "app/files/output_file.h"

namespace nacre::app {

class CheckedStream {
public:
    /// @param extension  of a temporary file for standard output @throws Error
    explicit CheckedStream(const std::string& path, const std::string& extension = {});
    ~CheckedStream();
    CheckedStream(const CheckedStream&) = delete;
    CheckedStream& operator=(const CheckedStream&) = delete;

    /// Appends. @throws Error
    void write(const void* bytes, std::size_t count);
    /// Overwrites existing bytes. @throws Error
    void writeAt(std::uint64_t offset, const void* bytes, std::size_t count);
    /// Closes the file and moves it to its place. @throws Error
    void commit();
    const std::string& path() const { return file_.path(); }

private:
    OutputFile file_;
    int stream_ = -1;
    std::uint64_t size_ = 0;
};

}  // namespace nacre::app
