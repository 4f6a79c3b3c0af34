#include "app/serve/uploads.h"

#include <algorithm>

#include "app/files/unnamed_file.h"
#include "app/serve/picture_store.h"
#include "app/serve/problem.h"
#include "engine/error.h"

namespace nacre::app {

std::string Uploads::keep(const UnnamedFile& body) {
    const std::uint64_t bytes = body.size();
    std::string name = std::string(kPrefix) + contentKey(body);
    const std::lock_guard lock(turn_);
    const auto known = std::ranges::find_if(kept_, [&](const Kept& one) { return one.file->name() == name; });
    if (known != kept_.end()) {
        std::rotate(known, known + 1, kept_.end());
        return name;
    }
    try {
        UnnamedFile file(UnnamedFile::Place::disk);
        body.eachPiece([&](std::string_view piece) { file.append(piece); });
        kept_.push_back({OpenedFile::of(name, file), bytes});
    } catch (const Error&) {
        throw Problem(503, "no room for the structure");
    }
    bytes_ += bytes;
    while (kept_.size() > kMost || bytes_ > kMostBytes) {
        bytes_ -= kept_.front().bytes;
        kept_.pop_front();
    }
    return name;
}

std::shared_ptr<const OpenedFile> Uploads::find(const std::string& name) const {
    const std::lock_guard lock(turn_);
    const auto known = std::ranges::find_if(kept_, [&](const Kept& one) { return one.file->name() == name; });
    return known == kept_.end() ? nullptr : known->file;
}

}  // namespace nacre::app
