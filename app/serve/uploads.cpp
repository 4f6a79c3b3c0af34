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
    std::erase(names_, name);
    names_.push_back(name);
    while (names_.size() > kMost) {
        std::remove((folder_ + "/" + names_.front()).c_str());
        names_.pop_front();
    }
    return "upload:" + name;
}

}  // namespace nacre::app
