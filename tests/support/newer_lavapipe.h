#pragma once
// The lavapipe that tools/newer_lavapipe unpacks beside the system's.

#include <cstdlib>
#include <filesystem>
#include <string>

namespace nacre::test {

/// Vulkan programs of this process that start while this lives take that driver, if it is there.
class NewerLavapipe {
public:
    NewerLavapipe() {
        if (!there()) return;
        for (const char* name : kNames) {
            before_[name == kNames[1]] = std::getenv(name) ? std::getenv(name) : "";
            setenv(name, file().c_str(), 1);
        }
    }
    ~NewerLavapipe() {
        if (!there()) return;
        for (const char* name : kNames) setenv(name, before_[name == kNames[1]].c_str(), 1);
    }
    NewerLavapipe(const NewerLavapipe&) = delete;

    static std::string file() { return NACRE_SOURCE_DIR "/build/lavapipe25/lvp_icd.json"; }
    static bool there() { return std::filesystem::exists(file()); }
    static constexpr const char* kAbsent =
        "no newer lavapipe here: tools/newer_lavapipe unpacks it into build/lavapipe25";

private:
    static constexpr const char* kNames[] = {"VK_DRIVER_FILES", "VK_ICD_FILENAMES"};
    std::string before_[2];
};

/// Render passes of devices that are made while this lives are VkRenderPasses.
struct RenderPassesOfOld {
    RenderPassesOfOld() { setenv("NACRE_NO_DYNAMIC_RENDERING", "1", 1); }
    ~RenderPassesOfOld() { unsetenv("NACRE_NO_DYNAMIC_RENDERING"); }
};

}  // namespace nacre::test
