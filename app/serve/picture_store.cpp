#include "app/serve/picture_store.h"

#include <xxhash.h>

#include <cstdio>

#include "app/files/unnamed_file.h"

namespace nacre::app {
namespace {

constexpr const char* kPrefix = "picture-";

std::string toDigits(const XXH128_hash_t& hash) {
    char text[33];
    std::snprintf(text, sizeof text, "%016llx%016llx", static_cast<unsigned long long>(hash.high64),
                  static_cast<unsigned long long>(hash.low64));
    return text;
}

/// Head of an entry: the picture's name, length and hash. Its size depends on the name alone.
std::string makeHead(const std::string& name, std::string_view picture) {
    char length[17];
    std::snprintf(length, sizeof length, "%016llx", static_cast<unsigned long long>(picture.size()));
    return "nacre picture " + name + " " + length + " " + contentKey(picture) + "\n";
}

}  // namespace

std::string contentKey(std::string_view bytes) { return toDigits(XXH3_128bits(bytes.data(), bytes.size())); }

std::string contentKey(const UnnamedFile& file) {
    const std::unique_ptr<XXH3_state_t, XXH_errorcode (*)(XXH3_state_t*)> state(XXH3_createState(), XXH3_freeState);
    XXH3_128bits_reset(state.get());
    file.eachPiece([&](std::string_view piece) { XXH3_128bits_update(state.get(), piece.data(), piece.size()); });
    return toDigits(XXH3_128bits_digest(state.get()));
}

PictureStore::PictureStore(std::string folder, std::uint64_t bytes)
    : slack_(bytes / 16), cache_(std::move(folder), bytes - slack_, {kPrefix}) {
    cache_.trim();  // the limit may have changed
}

std::optional<std::string> PictureStore::find(const std::string& name) const {
    std::optional<std::string> entry = cache_.read(kPrefix + name);
    if (!entry) return std::nullopt;
    const std::size_t head = makeHead(name, {}).size();
    if (entry->size() >= head && entry->compare(0, head, makeHead(name, std::string_view(*entry).substr(head))) == 0) {
        entry->erase(0, head);
        return entry;
    }
    cache_.remove(kPrefix + name);
    return std::nullopt;
}

void PictureStore::keep(const std::string& name, const std::string& picture) {
    const std::string head = makeHead(name, picture);
    const std::string_view parts[] = {head, picture};
    if (picture.size() > slack_ || !cache_.write(kPrefix + name, parts, false)) return;
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
