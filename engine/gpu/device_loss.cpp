#include "engine/gpu/device_loss.h"

#include <algorithm>
#include <cstdio>
#include <vector>

#include "engine/gpu/instance.h"

namespace nacre::gpu {
namespace {

std::string hex(std::uint64_t value) {
    char text[24];
    std::snprintf(text, sizeof text, "0x%llx", static_cast<unsigned long long>(value));
    return text;
}

/// Bits of the address below the precision, a power of two, are undefined.
std::string addressText(const VkDeviceFaultAddressInfoEXT& a) {
    std::string kind = vk::to_string(static_cast<vk::DeviceFaultAddressTypeEXT>(a.addressType));
    const VkDeviceAddress size = std::max<VkDeviceAddress>(a.addressPrecision, 1);
    return kind + " at " + hex(a.reportedAddress & ~(size - 1)) + " to " + hex(a.reportedAddress | (size - 1));
}

template <std::size_t size>
std::string toString(const char (&text)[size]) {
    return {text, std::find(text, text + size, '\0')};
}

}  // namespace

std::string& SubmissionLog::recording() {
    static thread_local std::string work;
    return work;
}

void SubmissionLog::submitted() {
    if (recording().empty()) recording() = "unnamed work";
    const std::lock_guard lock(turn_);
    std::rotate(submitted_.begin(), submitted_.end() - 1, submitted_.end());
    std::swap(submitted_.front(), recording());
    recording().clear();
}

std::string SubmissionLog::text() const {
    const std::lock_guard lock(turn_);
    std::string text;
    for (const std::string& work : submitted_)
        if (!work.empty()) text += (text.empty() ? "" : ", before it ") + ("[" + work + "]");
    return text;
}

bool tellsOfFaults(const vk::raii::PhysicalDevice& device) {
    for (const auto& e : listExtensions(device))
        if (std::string_view(e.extensionName.data()) == VK_EXT_DEVICE_FAULT_EXTENSION_NAME)
            return device.getFeatures2<vk::PhysicalDeviceFeatures2, vk::PhysicalDeviceFaultFeaturesEXT>()
                .get<vk::PhysicalDeviceFaultFeaturesEXT>()
                .deviceFault;
    return false;
}

std::string faultText(const vk::raii::Device& device) {
    const auto ask = device.getDispatcher()->vkGetDeviceFaultInfoEXT;
    VkDeviceFaultCountsEXT counts{VK_STRUCTURE_TYPE_DEVICE_FAULT_COUNTS_EXT, nullptr, 0, 0, 0};
    if (!ask || ask(*device, &counts, nullptr) != VK_SUCCESS) return "";
    std::vector<VkDeviceFaultAddressInfoEXT> addresses(counts.addressInfoCount);
    std::vector<VkDeviceFaultVendorInfoEXT> vendor(counts.vendorInfoCount);
    counts.vendorBinarySize = 0;  // only for the vendor's tools
    VkDeviceFaultInfoEXT info{};
    info.sType = VK_STRUCTURE_TYPE_DEVICE_FAULT_INFO_EXT;
    info.pAddressInfos = addresses.data();
    info.pVendorInfos = vendor.data();
    if (ask(*device, &counts, &info) < 0) return "";
    addresses.resize(std::min<std::size_t>(addresses.size(), counts.addressInfoCount));
    vendor.resize(std::min<std::size_t>(vendor.size(), counts.vendorInfoCount));
    std::string text = toString(info.description);
    for (const auto& a : addresses) text += (text.empty() ? "" : ", ") + addressText(a);
    for (const auto& v : vendor)
        text += (text.empty() ? "" : ", ") + toString(v.description) + " (code " + hex(v.vendorFaultCode) + ", data " +
                hex(v.vendorFaultData) + ")";
    return inOneLine(text);
}

std::string inOneLine(std::string text) {
    for (char& c : text)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
    return text;
}

}  // namespace nacre::gpu
