#include "app/serve/picture_store.h"

#include <xxhash.h>

#include <cstdio>

namespace nacre::app {
namespace {

constexpr const char* kPrefix = "picture-";

}  // namespace

std::string contentKey(const std::string& bytes) {
    const XXH128_hash_t hash = XXH3_128bits(bytes.data(), bytes.size());
    char text[33];
    std::snprintf(text, sizeof text, "%016llx%016llx", static_cast<unsigned long long>(hash.high64),
                  static_cast<unsigned long long>(hash.low64));
    return text;
}

PictureStore::PictureStore(std::string folder, std::uint64_t bytes)
    : slack_(bytes / 16), cache_(std::move(folder), bytes - slack_, {kPrefix}) {
    cache_.trim();  // the bound may have been another
}

std::optional<std::string> PictureStore::find(const std::string& name) const { return cache_.read(kPrefix + name); }

void PictureStore::keep(const std::string& name, const std::string& picture) {
    const std::string_view part = picture;
    if (picture.size() > slack_ || !cache_.write(kPrefix + name, {&part, 1}, false)) return;
    const std::lock_guard lock(turn_);
    added_ += picture.size();
    if (added_ <= slack_) return;
    cache_.trim();
    added_ = 0;
}

SharedPictures::Shared SharedPictures::get(const std::string& name, const std::function<ServedPicture()>& draw) {
    std::promise<Shared> promise;
    const std::shared_future<Shared> own = promise.get_future().share();
    std::shared_future<Shared> others;
    {
        const std::lock_guard lock(turn_);
        const auto [at, first] = drawn_.try_emplace(name, own);
        if (!first) others = at->second;
    }
    if (others.valid()) return others.get();
    try {
        promise.set_value(std::make_shared<const ServedPicture>(draw()));
    } catch (...) {
        promise.set_exception(std::current_exception());
    }
    {
        const std::lock_guard lock(turn_);
        drawn_.erase(name);
    }
    return own.get();
}

}  // namespace nacre::app
