#include <vulkan/vulkan_core.h>

#include <ostream>
#include <string>
#include <vector>

#include "app/cli/commands.h"
#include "app/cli/progress.h"
#include "app/files/cache_folder.h"
#include "app/files/device_report.h"
#include "app/files/json_text.h"
#include "engine/error.h"
#include "engine/renderer.h"
#include "engine/self_test.h"
#include "nacre_commit.h"

namespace nacre::app {
namespace {

std::string versionText(std::uint32_t version) {
    return std::to_string(VK_API_VERSION_MAJOR(version)) + "." + std::to_string(VK_API_VERSION_MINOR(version)) + "." +
           std::to_string(VK_API_VERSION_PATCH(version));
}

std::string describe(const DeviceInfo& device) {
    return device.name + " (" + device.type + ", Vulkan " + device.apiVersion + ", " + device.driver + ")";
}

}  // namespace

void devicesCommand(const DevicesOptions& options, std::ostream& out) {
    std::vector<DeviceInfo> devices = listDevices();
    std::vector<CountedTraffic> traffic(devices.size());
    const std::string folder = cacheFolder(options.cache, "devices");
    Progress progress;
    for (std::size_t i = 0; i < devices.size(); ++i) {
        if (options.selfTest) {
            DeviceOptions device{.device = std::to_string(i), .selfTests = folder};
            forgetSelfTest(folder, devices[i].driverKey);
            progress.begin("testing device " + std::to_string(i));
            devices[i].selfTest = describe(testPaths(device, devices[i]));
            traffic[i] = queryTraffic(devices[i], device);
        }
        // A software device uses the path of its caps.
        if (devices[i].type != "software") addSelfTest(devices[i], folder);
    }
    if (!options.json) {
        for (std::size_t i = 0; i < devices.size(); ++i) {
            out << i << "  " << describe(devices[i]) << '\n'
                << "   visibility " << devices[i].visibility << ": " << devices[i].why << "; "
                << devices[i].motionSamples << (devices[i].motionSamples == 1 ? " sample" : " samples")
                << " per pixel in motion; encoded depth " << devices[i].encodedFormat << "; lazy memory "
                << (devices[i].lazyMemory ? "yes" : "no") << "; timestamps " << (devices[i].timestamps ? "yes" : "no")
                << "; merge feedback " << (devices[i].mergeFeedback ? "yes" : "no") << "; render passes by "
                << (devices[i].localRead ? "dynamic rendering with local reads" : "VkRenderPass") << '\n';
            if (devices[i].bundled) out << "   driver of nacre's package: no other Vulkan driver has a device\n";
            if (!devices[i].selfTest.empty()) out << "   self-test: " << devices[i].selfTest << '\n';
            if (options.selfTest) out << "   memory traffic: " << describe(traffic[i]) << '\n';
            if (!devices[i].knownAs.empty())
                out << "   known as " << devices[i].capabilitySet << ": " << devices[i].knownAs << " ("
                    << devices[i].knownBy << ")\n";
        }
        if (devices.empty()) out << "no Vulkan device\n";
        return;
    }
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < devices.size(); ++i) {
        nlohmann::ordered_json device{{"number", i}};
        device.update(deviceJson(devices[i]));
        if (options.selfTest) device["counted_traffic"] = trafficJson(traffic[i]);
        list.push_back(device);
    }
    out << jsonText(list);
}

void versionCommand(std::ostream& out) {
    out << "nacre " << NACRE_VERSION << " (" << NACRE_COMMIT << ")\n"
        << "Vulkan headers " << versionText(VK_HEADER_VERSION_COMPLETE) << '\n'
        << "captures "
        << (capturesBuilt() ? "by RenderDoc, where it is installed" : "none: built without renderdoc_app.h") << '\n';
    try {
        const std::vector<DeviceInfo> devices = listDevices();
        out << "device " << (devices.empty() ? "none" : describe(devices.front())) << '\n';
    } catch (const Error& error) {
        // A machine without a driver still reports a version.
        out << "device none: " << error.what() << '\n';
    }
}

}  // namespace nacre::app
