#include "app/serve/picture_store.h"

#include <xxhash.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "app/files/output_file.h"
#include "app/serve/problem.h"
#include "engine/error.h"

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

Uploads::Uploads() {
    std::string name = (std::filesystem::temp_directory_path() / "nacre-uploads-XXXXXX").string();
    if (mkdtemp(name.data())) folder_ = name;
}

Uploads::~Uploads() {
    std::error_code error;
    if (!folder_.empty()) std::filesystem::remove_all(folder_, error);
}

std::string Uploads::keep(const std::string& body) {
    if (body.empty()) throw Problem(400, "the body is empty: a structure is expected");
    if (folder_.empty()) throw Problem(503, "no room for the structure");
    const std::string name = contentKey(body);
    const std::lock_guard lock(turn_);
    try {
        OutputFile file(folder_ + "/" + name);
        writeText(file, body);
    } catch (const Error&) {
        throw Problem(503, "no room for the structure");
    }
    std::erase_if(kept_, [&](const Kept& one) {
        if (one.name == name) bytes_ -= one.bytes;
        return one.name == name;
    });
    kept_.push_back({name, body.size()});
    bytes_ += body.size();
    while (kept_.size() > kMost || bytes_ > kMostBytes) {
        std::remove((folder_ + "/" + kept_.front().name).c_str());
        bytes_ -= kept_.front().bytes;
        kept_.pop_front();
    }
    return "upload:" + name;
}

}  // namespace nacre::app
