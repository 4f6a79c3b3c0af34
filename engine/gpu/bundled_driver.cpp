#include "engine/gpu/bundled_driver.h"

#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <system_error>

#include "engine/storage/own_folder.h"

namespace nacre::gpu {
namespace {

std::atomic<bool> taken{false};

/// The driver's manifest; empty if there is none.
const std::string& bundledManifest() {
    static const std::string manifest = [] {
        const std::filesystem::path folder = ownFolder(), file = folder / "vk_swiftshader_icd.json";
        std::error_code error;
        return !folder.empty() && std::filesystem::exists(file, error) ? file.string() : std::string();
    }();
    return manifest;
}

}  // namespace

bool hasBundledDriver() { return !bundledManifest().empty(); }

void takeBundledDriver() {
    for (const char* name : {"VK_DRIVER_FILES", "VK_ICD_FILENAMES"}) setenv(name, bundledManifest().c_str(), 1);
    taken = true;
}

bool bundledDriverTaken() { return taken; }

}  // namespace nacre::gpu
