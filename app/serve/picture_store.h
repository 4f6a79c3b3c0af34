#pragma once
// What a server keeps: sent pictures on disk, limited in size; one drawing for all requests that ask for the same
// picture at the same time; uploaded structures, files of this process, whose oldest are removed to make room.

#include <cstdint>
#include <deque>
#include <functional>
#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "app/serve/workers.h"
#include "engine/storage/disk_cache.h"

namespace nacre::app {

/// Key of some bytes: 32 hexadecimal digits of their XXH3.
std::string contentKey(const std::string& bytes);

class PictureStore {
public:
    /// @param folder  empty: no cache  @param bytes  maximum size
    PictureStore(std::string folder, std::uint64_t bytes);

    std::optional<std::string> find(const std::string& name) const;
    /// Stores a picture, if possible. The least recently used ones are removed to make room.
    void keep(const std::string& name, const std::string& picture);

private:
    const std::uint64_t slack_;  ///< bytes that are kept before those are looked for that make room
    const DiskCache cache_;
    std::mutex turn_;
    std::uint64_t added_ = 0;  ///< bytes since then
};

class SharedPictures {
public:
    using Shared = std::shared_ptr<const ServedPicture>;

    /// The picture of this name: of `draw`, or of the thread that draws it now. @throws what that `draw` throws
    Shared get(const std::string& name, const std::function<ServedPicture()>& draw);

private:
    std::mutex turn_;
    std::map<std::string, std::shared_future<Shared>> drawn_;  ///< at the moment
};

class Uploads {
public:
    Uploads();
    ~Uploads();
    Uploads(const Uploads&) = delete;

    const std::string& folder() const { return folder_; }
    /// @returns its input name, "upload:9f0c..." @throws Problem
    std::string keep(const std::string& body);

private:
    struct Kept {
        std::string name;
        std::size_t bytes;
    };
    static constexpr std::size_t kMost = 32;
    static constexpr std::size_t kMostBytes = std::size_t{512} << 20;
    std::string folder_;
    std::mutex turn_;
    std::deque<Kept> kept_;
    std::size_t bytes_ = 0;  ///< of all of them
};

}  // namespace nacre::app
