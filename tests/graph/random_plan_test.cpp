// Hundreds of small graphs, planned for every kind of device, and each plan walked through by an independent checker.

#include <gtest/gtest.h>

#include "engine/graph/capability_sets.h"
#include "tests/graph/plan_checker.h"
#include "tests/graph/random_graph.h"

namespace nacre::graph {
namespace {

constexpr std::uint32_t kGraphs = 600;

std::vector<PlanCaps> kindsOfDevices() {
    std::vector<PlanCaps> kinds;
    for (const CapabilitySet& set : capabilitySets()) kinds.push_back(set.plan);
    PlanCaps small = capabilitySet("mali").plan;
    small.name = "small tile";
    small.tileBytesPerPixel = 16;
    kinds.push_back(small);
    PlanCaps alone = capabilitySet("mali").plan;
    alone.name = "unmerged";
    alone.merge = false;
    kinds.push_back(alone);
    PlanCaps stored = capabilitySet("powervr").plan;
    stored.name = "stored";
    stored.storeAll = true;
    kinds.push_back(stored);
    return kinds;
}

std::string listed(const std::vector<std::string>& faults) {
    std::string text;
    for (const std::string& fault : faults) text += fault + "\n";
    return text;
}

TEST(RandomPlans, AreCorrectOnEveryKindOfDevice) {
    std::size_t planned = 0, bad = 0;
    for (const PlanCaps& caps : kindsOfDevices())
        for (std::uint32_t seed = 0; seed < kGraphs && bad < 5; ++seed) {
            const test::DeclaredGraph declared =
                declare(test::randomGraph(seed, seed % 2 == 1, caps.rasterOrder != RasterOrder::none));
            const Plan plan = compile(declared.graph, caps);
            const auto faults = test::checkPlan(declared.graph, plan, caps);
            EXPECT_TRUE(faults.empty()) << caps.name << ", seed " << seed << "\n"
                                        << listed(faults) << describe(declared.graph, plan);
            bad += !faults.empty();
            ++planned;
        }
    EXPECT_GT(planned, 5000u);
}

TEST(RandomPlans, MergeWhereTheTileAllowsIt) {
    std::size_t merged = 0, unmerged = 0, subpasses = 0, inputs = 0, transients = 0, culled = 0;
    std::uint64_t traffic = 0, apart = 0;
    PlanCaps caps = capabilitySet("mali").plan;
    for (std::uint32_t seed = 0; seed < kGraphs; ++seed) {
        const test::DeclaredGraph declared = declare(test::randomGraph(seed, false));
        caps.merge = true;
        const Plan plan = compile(declared.graph, caps);
        caps.merge = false;
        const Plan alone = compile(declared.graph, caps);
        merged += plan.steps.size();
        unmerged += alone.steps.size();
        traffic += plan.total.loaded + plan.total.stored;
        apart += alone.total.loaded + alone.total.stored;
        EXPECT_LE(plan.total.loaded + plan.total.stored, alone.total.loaded + alone.total.stored) << seed;
        for (const Step& step : plan.steps)
            for (const Subpass& s : step.renderPass.subpasses) {
                subpasses += &s != step.renderPass.subpasses.data();
                inputs += s.inputs.size();
            }
        for (const PlannedImage& image : plan.images) transients += image.transient;
        for (const bool c : plan.culled) culled += c;
    }
    // The graphs are such that every rule is met often.
    EXPECT_LT(merged * 10, unmerged * 9);
    EXPECT_LT(traffic, apart);
    EXPECT_GT(subpasses, 100u);
    EXPECT_GT(inputs, 50u);
    EXPECT_GT(transients, 100u);
    EXPECT_GT(culled, 100u);
}

/// What the checker is worth: it finds what is taken out of a plan. One barrier alone may be covered by others; all
/// that a step waits for is not.
TEST(PlanChecker, FindsWhatIsTakenAway) {
    struct Count {
        std::size_t taken = 0, found = 0;
    } steps, barriers, dependencies, preserves, layouts;
    const PlanCaps caps = capabilitySet("mali").plan;
    for (std::uint32_t seed = 0; seed < 150; ++seed) {
        const test::DeclaredGraph d = declare(test::randomGraph(seed, seed % 2 == 1));
        const Plan plan = compile(d.graph, caps);
        const auto without = [&](Count& count, const auto& takeAway) {
            Plan less = plan;
            takeAway(less);
            if (less == plan) return;
            ++count.taken;
            count.found += !test::checkPlan(d.graph, less, caps).empty();
        };
        for (std::size_t s = 0; s < plan.steps.size(); ++s) {
            const RenderPassPlan& pass = plan.steps[s].renderPass;
            without(steps, [&](Plan& p) {
                p.steps[s].before.clear();
                p.steps[s].renderPass.dependencies.clear();
            });
            for (std::size_t b = 0; b < plan.steps[s].before.size(); ++b)
                without(barriers,
                        [&](Plan& p) { p.steps[s].before.erase(p.steps[s].before.begin() + std::ptrdiff_t(b)); });
            for (std::size_t b = 0; b < pass.dependencies.size(); ++b)
                without(dependencies, [&](Plan& p) {
                    auto& list = p.steps[s].renderPass.dependencies;
                    list.erase(list.begin() + std::ptrdiff_t(b));
                });
            for (std::size_t b = 0; b < pass.subpasses.size(); ++b)
                without(preserves, [&](Plan& p) { p.steps[s].renderPass.subpasses[b].preserve.clear(); });
            for (std::size_t a = 0; a < pass.attachments.size(); ++a)
                without(layouts, [&](Plan& p) {
                    p.steps[s].renderPass.attachments[a].initialLayout = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL;
                });
        }
    }
    EXPECT_GT(steps.taken, 300u);
    EXPECT_GT(preserves.taken, 10u);
    EXPECT_EQ(steps.found, steps.taken);
    EXPECT_EQ(preserves.found, preserves.taken);
    EXPECT_GT(layouts.found * 20, layouts.taken * 19);  // a few are in that layout already
    EXPECT_GT(barriers.found * 10, barriers.taken * 8);
    EXPECT_GT(dependencies.found * 10, dependencies.taken * 8);
}

}  // namespace
}  // namespace nacre::graph
