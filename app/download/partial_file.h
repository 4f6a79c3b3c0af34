#pragma once

#include <memory>
#include <string>

#include "app/download/http.h"
#include "engine/storage/disk_cache.h"

namespace nacre::app {

/// A download under way, in the cache: NAME.part, and beside it in NAME.tag what version of which address it is. Stays
/// when the transfer breaks off or the process is killed, so that the next one goes on where it ended. Locked: where
/// another process is at the same entry, this one writes a file of its own that is gone with it.
class PartialFile : public HttpBody {
public:
    /// @throws Error if no file can be made
    PartialFile(const DiskCache& cache, const std::string& name, const std::string& url);
    ~PartialFile() override;

    std::uint64_t size() const override { return size_; }
    std::string validator() const override { return validator_; }
    void restart(const std::string& validator) override;
    void append(std::string_view bytes) override;

    /// All that is there. @throws Error
    std::string content() const;
    /// Makes it the entry, on disk before it has its name. @throws Error
    void commit();
    /// Removes it: it is of no use to a later attempt.
    void discard();

private:
    void openShared();
    void openOwn();
    void readTag();
    [[noreturn]] void fail() const;

    const DiskCache& cache_;
    std::string name_, url_, path_, tagPath_;
    int file_ = -1;
    bool shared_ = false, done_ = false;
    std::uint64_t size_ = 0;
    std::string validator_;
};

}  // namespace nacre::app
