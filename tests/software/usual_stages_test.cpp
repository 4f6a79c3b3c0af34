#include "engine/software/usual_stages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "shaders.h"

namespace nacre::passes {
namespace {

/// Ids of a stage's specialization constants: of OpDecorate ... SpecId.
std::set<int> specializationIds(gpu::ShaderWords words) {
    constexpr std::uint32_t kDecorate = 71, kSpecId = 1;
    std::set<int> ids;
    for (std::size_t at = 5; at < words.size(); at += std::max(words[at] >> 16, 1u))
        if ((words[at] & 0xffffu) == kDecorate && words[at + 2] == kSpecId) ids.insert(static_cast<int>(words[at + 3]));
    return ids;
}

std::size_t loopsIn(gpu::ShaderWords words) {
    constexpr std::uint32_t kLoopMerge = 246;
    std::size_t loops = 0;
    for (std::size_t at = 5; at < words.size(); at += std::max(words[at] >> 16, 1u))
        loops += (words[at] & 0xffffu) == kLoopMerge;
    return loops;
}

std::set<int> usualIds() {
    std::set<int> ids;
    for (const UsualConstant& c : kUsualConstants) ids.insert(c.id);
    return ids;
}

TEST(UsualStages, HaveAllOthersConstants) {
    const std::pair<gpu::ShaderWords, gpu::ShaderWords> stages[] = {
        {shaders::tileShadedSpheres, shaders::tileShadedSpheresUsual},
        {shaders::tileShadedCylinders, shaders::tileShadedCylindersUsual},
        {shaders::tileShadedTriangles, shaders::tileShadedTrianglesUsual},
        {shaders::tileNearestTexelsSpheres, shaders::tileNearestTexelsSpheresUsual},
        {shaders::tileNearestTexelsCylinders, shaders::tileNearestTexelsCylindersUsual},
        {shaders::tileNearestTexelsTriangles, shaders::tileNearestTexelsTrianglesUsual},
        {shaders::tileRimmedSpheres, shaders::tileRimmedSpheresUsual},
        {shaders::tileRimmedCylinders, shaders::tileRimmedCylindersUsual},
        {shaders::tileRimmedTriangles, shaders::tileRimmedTrianglesUsual},
        {shaders::tileEdgesTexelsSpheres, shaders::tileEdgesTexelsSpheresUsual},
        {shaders::tileEdgesTexelsCylinders, shaders::tileEdgesTexelsCylindersUsual},
        {shaders::tileEdgesTexelsTriangles, shaders::tileEdgesTexelsTrianglesUsual},
    };
    const std::set<int> usual = usualIds();
    for (const auto& [stage, usualStage] : stages) {
        std::set<int> others;
        std::ranges::set_difference(specializationIds(stage), usual, std::inserter(others, others.end()));
        EXPECT_TRUE(std::ranges::includes(others, specializationIds(usualStage)));
        // Those over the pixels of a lane are unrolled.
        EXPECT_LT(loopsIn(usualStage), loopsIn(stage) * 2 / 3);
    }
}

TEST(UsualStages, OfMeshesAskForNoSpheresAndCylinders) {
    for (const gpu::ShaderWords stage : {shaders::tileShadedMeshesUsual, shaders::tileEdgesTexelsMeshesUsual}) {
        const std::set<int> ids = specializationIds(stage);
        for (const int id : {layout::kSpheresId, layout::kCylindersId, layout::kTrianglesId})
            EXPECT_FALSE(ids.contains(id)) << id;
    }
}

TEST(UsualStages, ArePicturesWithoutOtherValues) {
    gpu::Specialization constants;
    constants.set(layout::kSeededId, 1);  // any
    EXPECT_TRUE(isUsual(constants));
    for (const UsualConstant& c : kUsualConstants) constants.set(c.id, c.value);
    EXPECT_TRUE(isUsual(constants));
    for (const UsualConstant& c : kUsualConstants) {
        constants.change(c.id, c.value + 1);
        EXPECT_FALSE(isUsual(constants)) << c.id;
        constants.change(c.id, c.value);
    }
    EXPECT_FALSE(isUsual(constants, true));
    constants.change(layout::kContoursId, 1u);  // rims are outlines
    EXPECT_TRUE(isUsual(constants, true));
}

}  // namespace
}  // namespace nacre::passes
