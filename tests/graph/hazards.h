#pragma once
// What may go wrong with one resource: stages, accesses and layouts, by the rules of the Vulkan specification.

#include <map>
#include <string>
#include <vector>

#include "engine/graph/graph.h"

namespace nacre::test {

using graph::PassKind;
using graph::Verb;
inline constexpr int kOutside = -1;  // of a render pass

struct Access {
    VkPipelineStageFlags stages = 0;
    VkAccessFlags access = 0;
    VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;
    bool writes = false;
};

/// How a verb touches memory, by the specification's tables of stages and accesses.
inline Access verbAccess(Verb verb, PassKind kind) {
    const VkPipelineStageFlags shader =
        kind == PassKind::compute ? VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT : VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT;
    constexpr VkPipelineStageFlags kTests =
        VK_PIPELINE_STAGE_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_LATE_FRAGMENT_TESTS_BIT;
    constexpr VkAccessFlags kDepthRead = VK_ACCESS_DEPTH_STENCIL_ATTACHMENT_READ_BIT;
    constexpr VkAccessFlags kColorRead = VK_ACCESS_COLOR_ATTACHMENT_READ_BIT;
    switch (verb) {
        case Verb::depth:
            return {kTests, kDepthRead | VK_ACCESS_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT,
                    VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL, true};
        case Verb::depthTest:
            return {kTests, kDepthRead, VK_IMAGE_LAYOUT_DEPTH_STENCIL_READ_ONLY_OPTIMAL, false};
        case Verb::color:
            return {VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT, kColorRead | VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT,
                    VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, true};
        case Verb::ordered:
            return {VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT | VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT,
                    kColorRead | VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT | VK_ACCESS_INPUT_ATTACHMENT_READ_BIT,
                    VK_IMAGE_LAYOUT_GENERAL, true};
        case Verb::resolve:
            return {VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT, kColorRead | VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT,
                    VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, true};
        case Verb::input:
            return {VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT, VK_ACCESS_INPUT_ATTACHMENT_READ_BIT,
                    VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL, false};
        case Verb::density:
            return {VK_PIPELINE_STAGE_FRAGMENT_DENSITY_PROCESS_BIT_EXT, VK_ACCESS_FRAGMENT_DENSITY_MAP_READ_BIT_EXT,
                    VK_IMAGE_LAYOUT_FRAGMENT_DENSITY_MAP_OPTIMAL_EXT, false};
        case Verb::samples:
            return {shader, VK_ACCESS_SHADER_READ_BIT, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL, false};
        case Verb::stores:
            return {shader, VK_ACCESS_SHADER_WRITE_BIT, VK_IMAGE_LAYOUT_GENERAL, true};
        case Verb::reads:
            return {shader, VK_ACCESS_SHADER_READ_BIT, {}, false};
        case Verb::writes:
            return {shader, VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_SHADER_WRITE_BIT, {}, true};
        case Verb::vertices:
            return {VK_PIPELINE_STAGE_VERTEX_INPUT_BIT, VK_ACCESS_VERTEX_ATTRIBUTE_READ_BIT, {}, false};
        case Verb::copiesFrom:
            return {VK_PIPELINE_STAGE_TRANSFER_BIT, VK_ACCESS_TRANSFER_READ_BIT, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
                    false};
        case Verb::copiesTo:
            return {VK_PIPELINE_STAGE_TRANSFER_BIT, VK_ACCESS_TRANSFER_WRITE_BIT, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                    true};
    }
    return {};
}

constexpr VkAccessFlags kWrites = VK_ACCESS_SHADER_WRITE_BIT | VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT |
                                  VK_ACCESS_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT | VK_ACCESS_TRANSFER_WRITE_BIT |
                                  VK_ACCESS_HOST_WRITE_BIT;

/// Something that happened to a resource, and which later work is known to come after it.
struct Event {
    bool write = false, available = false;
    VkPipelineStageFlags stages = 0;
    VkAccessFlags access = 0;
    int scope = kOutside;                         // subpass that did it
    std::map<int, VkPipelineStageFlags> ordered;  // by subpass; kOutside: everything later
    std::map<int, std::vector<std::pair<VkPipelineStageFlags, VkAccessFlags>>> visible;
    VkPipelineStageFlags inner = 0;  // the same, of the render pass that is not over yet
    VkPipelineStageFlags chain = 0;  // stages of any later work that comes after it
};

/// A dependency from work before (or a subpass) to work after (or a subpass).
struct Sync {
    VkPipelineStageFlags fromStages = 0, toStages = 0;
    VkAccessFlags fromAccess = 0, toAccess = 0;
    int from = kOutside, to = kOutside;
    bool barrier = true;  // from: all earlier work
};

struct Resource {
    std::string name;
    VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;
    std::vector<Event> events;

    static bool covers(const Sync& sync, const Event& e) {
        const bool all = e.stages && (e.stages & sync.fromStages) == e.stages;
        if (sync.barrier) return all || (e.chain & sync.fromStages);
        const auto at = [&](int scope) {
            const auto it = e.ordered.find(scope);
            return it == e.ordered.end() ? 0u : it->second;
        };
        if (e.scope == sync.from && all) return true;
        if (sync.from == kOutside && (e.chain & sync.fromStages)) return true;
        return ((at(sync.from) | at(kOutside)) & sync.fromStages) != 0;
    }

    void apply(const Sync& sync) {
        for (Event& e : events) {
            if (!covers(sync, e)) continue;
            e.ordered[sync.to] |= sync.toStages;
            (sync.barrier ? e.chain : e.inner) |= sync.toStages;
            if (!e.write) continue;
            e.available = e.available || ((e.access & kWrites) & ~sync.fromAccess) == 0;
            if (e.available) e.visible[sync.to].emplace_back(sync.toStages, sync.toAccess);
        }
    }

    static bool isOrdered(const Event& e, VkPipelineStageFlags stages, int scope) {
        VkPipelineStageFlags after = 0;
        for (const int s : {scope, kOutside})
            if (const auto it = e.ordered.find(s); it != e.ordered.end()) after |= it->second;
        return (stages & ~after) == 0;
    }
    static bool isVisible(const Event& e, const Access& a, int scope) {
        for (const int s : {scope, kOutside})
            if (const auto it = e.visible.find(s); it != e.visible.end())
                for (const auto& [stages, access] : it->second)
                    if ((a.stages & ~stages) == 0 && (a.access & ~access) == 0) return true;
        return false;
    }

    /// @param same  work of the same subpass on the same attachment is ordered by the rasteriser
    std::string touch(const Access& a, int scope, bool same) {
        std::string fault;
        for (const Event& e : events) {
            if (same && e.scope == scope && scope != kOutside) continue;
            if (!e.write && !a.writes) continue;
            if (!isOrdered(e, a.stages, scope))
                fault = e.write ? "does not wait for a write" : "does not wait for a read";
            else if (e.write && !isVisible(e, a, scope))
                fault = "does not see a write";
        }
        Event now;
        now.write = a.writes;
        now.stages = a.stages;
        now.access = a.access;
        now.scope = scope;
        if (a.writes) std::erase_if(events, [&](const Event& e) { return !same || e.scope != scope; });
        events.push_back(now);
        return fault;
    }

    /// A change of layout, by a barrier or between subpasses: a write between the two halves of the dependency.
    std::string change(VkImageLayout to, const Sync& sync) {
        std::string fault;
        for (const Event& e : events) {
            if (!covers(sync, e))
                fault = "changes layout while in use";
            else if (e.write && !e.available && ((e.access & kWrites) & ~sync.fromAccess))
                fault = "changes layout before a write is available";
        }
        Event now;
        now.write = now.available = true;
        now.scope = sync.to;
        now.ordered[sync.to] = sync.toStages;
        (sync.barrier ? now.chain : now.inner) = sync.toStages;
        now.visible[sync.to].emplace_back(sync.toStages, sync.toAccess);
        events = {now};
        layout = to;
        return fault;
    }

    void leaveRenderPass() {
        for (Event& e : events) {
            e.scope = kOutside;
            e.chain |= e.inner;
            e.inner = 0;
            std::erase_if(e.ordered, [](const auto& entry) { return entry.first != kOutside; });
            std::erase_if(e.visible, [](const auto& entry) { return entry.first != kOutside; });
        }
    }
};

}  // namespace nacre::test
