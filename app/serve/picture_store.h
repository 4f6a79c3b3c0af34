#pragma once
// Pictures that were sent once, on disk, within a bound.

#include <cstdint>
#include <mutex>
#include <optional>
#include <string>

namespace nacre::app {

/// What bytes are known by: 32 hexadecimal digits of their XXH3.
std::string contentKey(const std::string& bytes);

class PictureStore {
public:
    /// @param folder  empty: nothing is kept  @param bytes  that it holds at most
    PictureStore(std::string folder, std::uint64_t bytes);

    std::optional<std::string> find(const std::string& name) const;
    /// What cannot be kept is not kept. Those that were asked for least recently make room.
    void keep(const std::string& name, const std::string& picture);

private:
    void makeRoom();

    const std::string folder_;
    const std::uint64_t most_;
    std::mutex turn_;
    std::uint64_t held_ = 0;
};

}  // namespace nacre::app
