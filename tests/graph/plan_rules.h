#pragma once

#include <gtest/gtest.h>

#include <string>

#include "engine/graph/capability_sets.h"
#include "tests/graph/plan_checker.h"

namespace nacre::graph {

inline constexpr Extent kExtent{100, 50};
inline constexpr ImageDesc kColor{VK_FORMAT_R8G8B8A8_UNORM, kExtent};
inline constexpr ImageDesc kWide{VK_FORMAT_R16G16B16A16_SFLOAT, kExtent};
inline constexpr ImageDesc kDepth{VK_FORMAT_D32_SFLOAT, kExtent};
inline constexpr State kTexture{VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT, VK_ACCESS_SHADER_READ_BIT,
                                VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};

struct Rules : testing::Test {
    PlanCaps caps = capabilitySet("mali-old").plan;  // 16 bytes a pixel
    Graph g{"test"};
    const Plan plan() const { return compile(g, caps); }
    std::size_t subpasses(std::size_t step = 0) const { return plan().steps.at(step).renderPass.subpasses.size(); }
    std::size_t steps() const { return plan().steps.size(); }
    /// Why the graph cannot be planned, without the line of the pass; empty: it can.
    std::string refusal() const {
        try {
            compile(g, caps);
        } catch (const GraphError& error) {
            const std::string what = error.what();
            return what.substr(0, what.find(" (declared at "));
        }
        return "";
    }
};

}  // namespace nacre::graph
