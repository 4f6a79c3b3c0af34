#pragma once
// Uploaded structures: files without names; the oldest are removed to make room.

#include <deque>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>

#include "app/files/opened_file.h"

namespace nacre::app {

class Uploads {
public:
    static constexpr std::string_view kPrefix = "upload:";

    /// @returns its input name, "upload:9f0c..." @throws Problem
    std::string keep(const UnnamedFile& body);
    /// Null: not stored.
    std::shared_ptr<const OpenedFile> find(const std::string& name) const;

private:
    struct Kept {
        std::shared_ptr<const OpenedFile> file;
        std::uint64_t bytes;
    };
    static constexpr std::size_t kMost = 32;
    static constexpr std::uint64_t kMostBytes = std::uint64_t{512} << 20;
    mutable std::mutex turn_;
    std::deque<Kept> kept_;
    std::uint64_t bytes_ = 0;  ///< of all uploads
};

}  // namespace nacre::app
