#include "engine/gpu/bundled_driver.h"

#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <system_error>

#include "engine/storage/own_folder.h"

namespace nacre::gpu {
namespace {

constexpr std::array kVariables{"VK_DRIVER_FILES", "VK_ICD_FILENAMES"};
std::atomic<bool> driverTaken{false};

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

BundledDriver::BundledDriver() {
    for (std::size_t i = 0; i < before_.size(); ++i) {
        if (const char* value = std::getenv(kVariables[i])) before_[i] = value;
        setenv(kVariables[i], bundledManifest().c_str(), 1);
    }
    driverTaken = true;
}

BundledDriver::~BundledDriver() {
    for (std::size_t i = 0; i < before_.size(); ++i)
        if (before_[i])
            setenv(kVariables[i], before_[i]->c_str(), 1);
        else
            unsetenv(kVariables[i]);
}

bool BundledDriver::taken() { return driverTaken; }

}  // namespace nacre::gpu
