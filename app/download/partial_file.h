#pragma once

#include <string>

#include "app/download/http.h"
#include "engine/storage/disk_cache.h"

namespace nacre::app {

/// A download in progress, in the cache: NAME.part, with NAME.tag for its version and address. Stays if the transfer
/// fails or the process is killed, so that the next one can resume. Locked: if another process downloads the same
/// entry, this one writes a temporary file instead.
class PartialFile : public HttpBody {
public:
    /// @throws Error if no file can be made
    PartialFile(const DiskCache& cache, const std::string& name, const std::string& url);
    ~PartialFile() override;

    std::uint64_t size() const override { return size_; }
    std::string validator() const override { return validator_; }
    void restart(const std::string& validator) override;
    void append(std::string_view bytes) override;

    /// All bytes present. @throws Error
    std::string content() const;
    /// Makes it the entry, written to disk before it is renamed. @throws Error
    void commit();
    /// Removes it: a later attempt cannot use it.
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
