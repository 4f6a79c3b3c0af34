#pragma once
// Pictures that several requests share: a cache of sent ones on disk, limited in size, and those that are drawn now.

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include "app/serve/workers.h"
#include "engine/storage/disk_cache.h"

namespace nacre::app {

class UnnamedFile;

/// Key of some bytes: 32 hexadecimal digits of their XXH3.
std::string contentKey(std::string_view bytes);
/// Of a file's bytes. @throws Error
std::string contentKey(const UnnamedFile& file);

class PictureStore {
public:
    /// @param folder  empty: no cache  @param bytes  maximum size
    PictureStore(std::string folder, std::uint64_t bytes);

    /// One that is not as it was stored is removed.
    std::optional<std::string> find(const std::string& name) const;
    /// Stores a picture, if possible. The least recently used ones are removed to make room.
    void keep(const std::string& name, const std::string& picture);

private:
    const std::uint64_t slack_;  ///< bytes that are kept before those are looked for that make room
    const DiskCache cache_;
    std::mutex turn_;
    std::uint64_t added_ = 0;  ///< bytes since then
};

/// One drawing for all requests that ask for the same picture at the same time.
class SharedPictures {
public:
    using Shared = std::shared_ptr<const ServedPicture>;

    /// The picture of this name: of `draw`, or of the thread that draws it now. @throws what that `draw` throws
    Shared get(const std::string& name, const std::function<ServedPicture()>& draw);

private:
    std::mutex turn_;
    std::map<std::string, std::shared_future<Shared>> drawn_;  ///< at the moment
};

}  // namespace nacre::app
