#include "engine/storage/own_folder.h"

#include <dlfcn.h>

#include <system_error>

namespace nacre {

std::filesystem::path ownFolder() {
    Dl_info info{};
    if (!dladdr(reinterpret_cast<const void*>(&ownFolder), &info) || !info.dli_fname) return {};
    // A program found along PATH is known only by the name that was typed.
    const std::filesystem::path name = info.dli_fname, program = "/proc/self/exe";
    std::error_code error;
    std::filesystem::path file = std::filesystem::canonical(name.has_parent_path() ? name : program, error);
    // After an update the running program's file is gone, but its companions may still be there.
    if (error) file = std::filesystem::read_symlink(program, error);
    return file.parent_path();
}

}  // namespace nacre
