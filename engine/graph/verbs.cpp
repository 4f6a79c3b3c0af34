#include <algorithm>
#include <iterator>

#include "engine/graph/plan_internal.h"

namespace nacre::graph {
namespace {

constexpr VkPipelineStageFlags kTests =
    VK_PIPELINE_STAGE_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_LATE_FRAGMENT_TESTS_BIT;
constexpr VkPipelineStageFlags kOutput = VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT;
constexpr VkPipelineStageFlags kFragments = VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT;
constexpr VkAccessFlags kDepthRead = VK_ACCESS_DEPTH_STENCIL_ATTACHMENT_READ_BIT;
constexpr VkAccessFlags kColor = VK_ACCESS_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT;

struct VerbRow {
    Verb verb;
    const char* name;
    State state;  ///< of graphics passes
    VkImageUsageFlags usage;
};
constexpr VerbRow kVerbs[] = {
    {Verb::depth,
     "depth write",
     {kTests, kDepthRead | VK_ACCESS_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT,
      VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL},
     VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT},
    {Verb::depthTest,
     "depth test",
     {kTests, kDepthRead, VK_IMAGE_LAYOUT_DEPTH_STENCIL_READ_ONLY_OPTIMAL},
     VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT},
    {Verb::color,
     "write",
     {kOutput, kColor, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL},
     VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT},
    {Verb::ordered,
     "ordered read and write",
     {kOutput | kFragments, kColor | VK_ACCESS_INPUT_ATTACHMENT_READ_BIT, VK_IMAGE_LAYOUT_GENERAL},
     VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_INPUT_ATTACHMENT_BIT},
    {Verb::resolve,
     "resolve",
     {kOutput, kColor, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL},
     VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT},
    {Verb::input,
     "input",
     {kFragments, VK_ACCESS_INPUT_ATTACHMENT_READ_BIT, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL},
     VK_IMAGE_USAGE_INPUT_ATTACHMENT_BIT},
    {Verb::density,
     "density map",
     {VK_PIPELINE_STAGE_FRAGMENT_DENSITY_PROCESS_BIT_EXT, VK_ACCESS_FRAGMENT_DENSITY_MAP_READ_BIT_EXT,
      VK_IMAGE_LAYOUT_FRAGMENT_DENSITY_MAP_OPTIMAL_EXT},
     VK_IMAGE_USAGE_FRAGMENT_DENSITY_MAP_BIT_EXT},
    {Verb::samples,
     "sample",
     {kFragments, VK_ACCESS_SHADER_READ_BIT, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL},
     VK_IMAGE_USAGE_SAMPLED_BIT},
    {Verb::stores,
     "store",
     {kFragments, VK_ACCESS_SHADER_WRITE_BIT, VK_IMAGE_LAYOUT_GENERAL},
     VK_IMAGE_USAGE_STORAGE_BIT},
    {Verb::reads, "read", {kFragments, VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_UNIFORM_READ_BIT, {}}, 0},
    {Verb::writes, "storage", {kFragments, VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_SHADER_WRITE_BIT, {}}, 0},
    {Verb::vertices, "vertices", {VK_PIPELINE_STAGE_VERTEX_INPUT_BIT, VK_ACCESS_VERTEX_ATTRIBUTE_READ_BIT, {}}, 0},
    {Verb::copiesFrom,
     "copy from",
     {VK_PIPELINE_STAGE_TRANSFER_BIT, VK_ACCESS_TRANSFER_READ_BIT, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL},
     VK_IMAGE_USAGE_TRANSFER_SRC_BIT},
    {Verb::copiesTo,
     "copy to",
     {VK_PIPELINE_STAGE_TRANSFER_BIT, VK_ACCESS_TRANSFER_WRITE_BIT, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL},
     VK_IMAGE_USAGE_TRANSFER_DST_BIT}};

const VerbRow& findRow(Verb verb) {
    return *std::find_if(std::begin(kVerbs), std::end(kVerbs), [&](const VerbRow& row) { return row.verb == verb; });
}

}  // namespace

const char* verbName(Verb verb) { return findRow(verb).name; }

VkImageUsageFlags usageFlag(Verb verb) { return findRow(verb).usage; }

State verbState(Verb verb, PassKind kind) {
    State state = findRow(verb).state;
    if (kind == PassKind::compute && state.stages == kFragments && verb != Verb::input)
        state.stages = VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT;
    return state;
}

}  // namespace nacre::graph
