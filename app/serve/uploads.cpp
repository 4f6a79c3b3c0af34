#include "app/serve/uploads.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "app/files/output_file.h"
#include "app/serve/picture_store.h"
#include "app/serve/problem.h"
#include "engine/error.h"

namespace nacre::app {

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
