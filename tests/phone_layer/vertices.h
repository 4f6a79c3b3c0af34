#pragma once
// Vertex outputs of each render pass, which Mali keeps in memory of a fixed size: phones of Arm's make end the program
// where a render pass hands on more than NACRE_PHONE_VERTEX_BYTES, or 150 MB. Counted are the corners of each draw, in
// all views, times the position and the outputs of the vertex stage that is bound, as its SPIR-V declares them. An
// indexed draw is of pyramids, whose corners are shaded once each.

#include <vulkan/vulkan.h>

#include <bit>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <mutex>
#include <span>

#include "engine/passes/corners.h"
#include "tests/phone_layer/below.h"
#include "tests/phone_layer/counters.h"
#include "tests/support/vertex_outputs.h"

namespace nacre::phone {

struct VertexOutputs {
    std::uint64_t sum = 0;  ///< of the render pass
    std::uint32_t each = 0, views = 1;
};

inline std::mutex verticesMutex;  // of what follows
inline std::map<VkShaderModule, std::uint32_t> shaderOutputs;
inline std::map<VkPipeline, std::uint32_t> vertexBytes;  ///< of a vertex
inline std::map<VkCommandBuffer, VertexOutputs> vertexOutputs;

inline void noteShader(VkShaderModule shader, const VkShaderModuleCreateInfo& info) {
    const std::lock_guard lock(verticesMutex);
    shaderOutputs[shader] = test::outputBytes({info.pCode, info.codeSize / 4});
}

inline void notePipeline(VkPipeline pipeline, const VkGraphicsPipelineCreateInfo& info) {
    constexpr std::uint32_t kPosition = 16;
    const std::lock_guard lock(verticesMutex);
    for (const VkPipelineShaderStageCreateInfo& stage : std::span(info.pStages, info.stageCount))
        if (stage.stage == VK_SHADER_STAGE_VERTEX_BIT) vertexBytes[pipeline] = kPosition + shaderOutputs[stage.module];
}

/// A render pass begins.
inline void beginVertices(VkCommandBuffer commands, std::uint32_t viewMask) {
    const std::lock_guard lock(verticesMutex);
    vertexOutputs[commands] = {0, 0, std::max(1u, static_cast<std::uint32_t>(std::popcount(viewMask)))};
}

inline void handOn(VkCommandBuffer commands, std::uint64_t vertices) {
    const std::lock_guard lock(verticesMutex);
    VertexOutputs& outputs = vertexOutputs[commands];
    const std::uint64_t bytes = vertices * outputs.views * outputs.each;
    throughMemory(commands, bytes, bytes);
    outputs.sum += bytes;
    const char* asked = std::getenv("NACRE_PHONE_VERTEX_BYTES");
    const std::uint64_t most = asked ? std::strtoull(asked, nullptr, 10) : 150'000'000;
    if (outputs.sum <= most || !arm()) return;
    std::fprintf(stderr, "phone: a render pass of more than %llu bytes of vertex outputs\n",
                 static_cast<unsigned long long>(most));
    std::abort();
}

inline VKAPI_ATTR void VKAPI_CALL CmdBindPipeline(VkCommandBuffer commands, VkPipelineBindPoint point,
                                                  VkPipeline pipeline) {
    nextCmdBindPipeline(commands, point, pipeline);
    if (point != VK_PIPELINE_BIND_POINT_GRAPHICS) return;
    const std::lock_guard lock(verticesMutex);
    vertexOutputs[commands].each = vertexBytes[pipeline];
}

}  // namespace nacre::phone
