#include "engine/graph/plan.h"

namespace nacre::graph {
namespace {

struct FormatInfo {
    VkFormat format;
    const char* name;
    std::uint32_t bytes;
    bool depth;
};
constexpr FormatInfo kFormats[] = {
    {VK_FORMAT_R8_UNORM, "R8", 1, false},
    {VK_FORMAT_R8G8_UNORM, "RG8", 2, false},
    {VK_FORMAT_R8G8B8A8_UNORM, "RGBA8", 4, false},
    {VK_FORMAT_R8G8B8A8_SRGB, "RGBA8 sRGB", 4, false},
    {VK_FORMAT_B8G8R8A8_UNORM, "BGRA8", 4, false},
    {VK_FORMAT_B8G8R8A8_SRGB, "BGRA8 sRGB", 4, false},
    {VK_FORMAT_A2B10G10R10_UNORM_PACK32, "A2B10G10R10", 4, false},
    {VK_FORMAT_R16_SFLOAT, "R16F", 2, false},
    {VK_FORMAT_R16G16_SFLOAT, "RG16F", 4, false},
    {VK_FORMAT_R16G16B16A16_SFLOAT, "RGBA16F", 8, false},
    {VK_FORMAT_R32_SFLOAT, "R32F", 4, false},
    {VK_FORMAT_R32_UINT, "R32_UINT", 4, false},
    {VK_FORMAT_R32G32_UINT, "RG32_UINT", 8, false},
    {VK_FORMAT_R32G32B32A32_SFLOAT, "RGBA32F", 16, false},
    {VK_FORMAT_D16_UNORM, "D16", 2, true},
    {VK_FORMAT_D32_SFLOAT, "D32F", 4, true},
};

const FormatInfo& info(VkFormat format) {
    for (const FormatInfo& f : kFormats)
        if (f.format == format) return f;
    throw GraphError("format " + std::to_string(format) + " is not one that the renderer uses");
}

}  // namespace

std::uint32_t bytesPerTexel(VkFormat format) { return info(format).bytes; }
bool isDepthFormat(VkFormat format) { return info(format).depth; }
std::string formatName(VkFormat format) { return info(format).name; }

}  // namespace nacre::graph
