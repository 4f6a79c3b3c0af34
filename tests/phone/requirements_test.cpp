// The table of what the renderer requires, held against the least phone. No device is asked.

#include "engine/gpu/requirements.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/graph/encoded_format.h"
#include "tests/phone_layer/floor.h"

namespace nacre::test {
namespace {

TEST(Requirements, NoLimitIsAboveThePhones) {
    for (const gpu::RequiredLimit& required : gpu::requiredLimits()) {
        const auto floor = std::find_if(std::begin(phone::kLimits), std::end(phone::kLimits),
                                        [&](const auto& l) { return l.limit == required.limit; });
        ASSERT_NE(floor, std::end(phone::kLimits)) << required.name;
        EXPECT_LE(required.least, floor->value) << required.name << ": " << required.why;
    }
}

TEST(Requirements, NoFormatDoesMoreThanThePhones) {
    for (const gpu::RequiredFormat& required : gpu::requiredFormats())
        EXPECT_EQ(phone::floorFormat(required.format) & required.features, required.features) << required.why;
}

TEST(Requirements, EveryExtensionIsThere) {
    EXPECT_LE(gpu::kRequiredVulkan, VK_MAKE_API_VERSION(0, 1, 1, 106));
    for (const char* name : gpu::requiredExtensions()) EXPECT_TRUE(phone::isFloorExtension(name)) << name;
    EXPECT_TRUE(phone::isFloorExtension(VK_KHR_SWAPCHAIN_EXTENSION_NAME));
}

TEST(Requirements, HoldOnEveryProfileOfPhones) {
    for (const phone::Profile* profile : phone::kProfiles) {
        SCOPED_TRACE(profile->name);
        EXPECT_TRUE(profile->base || profile->limits.size() > 20u);
        EXPECT_LE(gpu::kRequiredVulkan, profile->vulkan);
        for (const phone::ProfileLimit& has : profile->limits)
            for (const gpu::RequiredLimit& required : gpu::requiredLimits())
                if (required.limit == has.limit) {
                    EXPECT_LE(required.least, has.least) << required.name << ": " << required.why;
                }
        for (const std::string_view name : gpu::requiredExtensions()) {
            const bool core =
                name == VK_KHR_CREATE_RENDERPASS_2_EXTENSION_NAME && profile->vulkan >= VK_API_VERSION_1_2;
            EXPECT_TRUE(core || profile->has(name)) << name;
        }
    }
}

// The least phone's list is written by hand. Where it says something else than the profile's data, it says less, for
// the reason that its file states.
TEST(Requirements, TheLeastPhoneIsThatOfTheProfile) {
    std::size_t same = 0;
    for (const phone::ProfileLimit& asked : phone::kAndroid2022.limits)
        for (const auto& [limit, value, name] : phone::kLimits)
            if (limit == asked.limit) {
                const bool lower = limit == &VkPhysicalDeviceLimits::maxFragmentCombinedOutputResources;
                EXPECT_EQ(value, lower ? 4u : asked.least) << name;
                EXPECT_LE(value, asked.least) << name;
                ++same;
            }
    EXPECT_GT(same, 30u);
}

TEST(Requirements, SomeRungOfEncodedDepthBlendsOnEveryPhone) {
    EXPECT_TRUE(std::any_of(graph::encodedFormats().begin(), graph::encodedFormats().end(), [](const auto& rung) {
        return phone::floorFormat(rung.format) & VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BLEND_BIT;
    }));
}

}  // namespace
}  // namespace nacre::test
