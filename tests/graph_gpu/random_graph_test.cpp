// Random graphs, carried out: merged equals unmerged, and transient equals stored, bit for bit, without a word from the
// validation layer.

#include "tests/graph/random_graph.h"

#include <gtest/gtest.h>

#include <deque>
#include <numeric>
#include <optional>

#include "engine/gpu/execute.h"
#include "tests/support/newer_lavapipe.h"

namespace nacre::test {
namespace {

namespace shaders {
#include "randomComp.h"
#include "randomFrag0.h"
#include "randomFrag0Input.h"
#include "randomFrag0Sampled.h"
#include "randomFrag1.h"
#include "randomFrag1Input.h"
#include "randomFrag1Sampled.h"
#include "randomFrag2.h"
#include "randomFrag2Input.h"
#include "randomFrag2Sampled.h"
#include "randomVert.h"
}  // namespace shaders

using graph::Verb;
using Words = std::span<const std::uint32_t>;
using Type = vk::DescriptorType;

struct Push {
    float z;
    std::uint32_t seed, reads;
};
constexpr auto kStages = vk::ShaderStageFlagBits::eVertex | vk::ShaderStageFlagBits::eFragment;
constexpr auto kTextureLayout = vk::ImageLayout::eShaderReadOnlyOptimal;

Words fragmentShader(std::size_t outputs, bool input, bool sampled) {
    const Words plain[] = {shaders::randomFrag0, shaders::randomFrag1, shaders::randomFrag2};
    const Words onTile[] = {shaders::randomFrag0Input, shaders::randomFrag1Input, shaders::randomFrag2Input};
    const Words inMemory[] = {shaders::randomFrag0Sampled, shaders::randomFrag1Sampled, shaders::randomFrag2Sampled};
    return !input ? plain[outputs] : sampled ? inMemory[outputs] : onTile[outputs];
}

/// Carries out random graphs on one device.
class Runner {
public:
    /// @param validate  what the installed validation layer knows
    explicit Runner(bool validate = true)
        : device(DeviceOptions{validate, "", Visibility::automatic, EncodedDepth::automatic}) {
        plain_ = layout(Type::eCombinedImageSampler, kStages);
        onTile_ = layout(Type::eInputAttachment, kStages);
        compute_ = layout(Type::eStorageBuffer, vk::ShaderStageFlagBits::eCompute);
        constexpr auto kUsage = vk::ImageUsageFlagBits::eSampled | vk::ImageUsageFlagBits::eColorAttachment;
        noColor_ = gpu::makeImage(device, {VK_FORMAT_R32_UINT, {1, 1}}, kUsage, false, "no colour");
        noDepth_ = gpu::makeImage(device, {VK_FORMAT_R32_SFLOAT, {1, 1}}, kUsage, false, "no depth");
        noBuffer_ = buffer("no buffer");
        graph::Graph g("nothing to read");
        auto color = g.importImage("no colour", noColor_.desc, kImportedState, true);
        auto depth = g.importImage("no depth", noDepth_.desc, kImportedState, true);
        g.graphics("clear").color(color, graph::Clear{0.0f}).color(depth, graph::Clear{0.0f});
        gpu::Imports imports;
        imports.bind(color, noColor_);
        imports.bind(depth, noDepth_);
        gpu::Executor executor(device);
        plan = compile(g, device.caps().plan);
        device.submitAndWait([&](gpu::CommandBuffer& c) { executor.record(c, g, plan, imports); });
    }

    /// All outputs and buffers after one execution.
    std::vector<std::uint32_t> run(const RandomGraph& random, const graph::PlanCaps& caps) {
        pipelines_.clear();
        DeclaredGraph d = declare(random, [&](std::size_t p, const DeclaredGraph& declared) -> graph::Record {
            const RandomPass& pass = random.passes[p];
            std::vector<graph::Image> images = declared.images;
            std::vector<graph::Buffer> buffers = declared.buffers;
            return [this, &random, &pass, images, buffers](gpu::PassContext& c) {
                if (pass.kind == graph::PassKind::graphics) draw(c, random, pass, images, buffers);
                if (pass.kind == graph::PassKind::compute) dispatch(c, random, pass, images, buffers);
                if (pass.kind == graph::PassKind::transfer) copy(c, random, pass, images, buffers);
            };
        });
        gpu::Imports imports;
        std::deque<gpu::Buffer> memory;
        for (const graph::Buffer b : d.buffers) {
            memory.push_back(buffer("buffer"));
            auto* words = reinterpret_cast<std::uint32_t*>(memory.back().mapped);
            std::iota(words, words + kBufferWords, 77u);
            imports.bind(b, memory.back());
            d.graph.output(b);
        }
        for (std::uint32_t i = 0; i < random.images.size(); ++i) {
            if (!random.outputs[i]) continue;
            memory.push_back(buffer("output"));
            std::memset(memory.back().mapped, 0, kBufferWords * 4);
            const auto host = d.graph.importBuffer("output " + std::to_string(i), kBufferWords * 4);
            imports.bind(host, memory.back());
            d.graph.output(host);
            graph::Image image = d.images[i];
            const graph::ImageDesc desc = random.images[i];
            d.graph.transfer("read back " + std::to_string(i))
                .copiesFrom(image)
                .copiesTo(host)
                .record([image, host, desc](gpu::PassContext& c) {
                    c.commands.copyImageToBuffer(c.image(image), vk::ImageLayout::eTransferSrcOptimal, c.buffer(host),
                                                 wholeCopy(desc));
                });
        }
        gpu::Executor executor(device);
        plan = compile(d.graph, caps);
        executor.run(d.graph, plan, imports);
        std::vector<std::uint32_t> result;
        for (const gpu::Buffer& b : memory) {
            const auto* words = reinterpret_cast<const std::uint32_t*>(b.mapped);
            result.insert(result.end(), words, words + kBufferWords);
        }
        return result;
    }

    gpu::Device device;
    graph::Plan plan;  ///< of the last run

private:
    gpu::Layout layout(Type last, vk::ShaderStageFlags stages) {
        const Type bindings[] = {Type::eCombinedImageSampler, Type::eCombinedImageSampler, Type::eStorageBuffer, last};
        return gpu::makeLayout(device, {"random layout", bindings, stages, sizeof(Push)});
    }
    gpu::Buffer buffer(const char* name) {
        using Usage = vk::BufferUsageFlagBits;
        return gpu::makeBuffer(device, kBufferWords * 4,
                               Usage::eStorageBuffer | Usage::eTransferDst | Usage::eTransferSrc, gpu::Access::readback,
                               name);
    }
    static vk::BufferImageCopy wholeCopy(const graph::ImageDesc& desc) {
        return {0, 0, 0, {vk::ImageAspectFlagBits::eColor, 0, 0, 1}, {}, {desc.extent.width, desc.extent.height, 1}};
    }

    /// The set of a pass, with something to read at every binding.
    vk::DescriptorSet set(gpu::PassContext& c, const gpu::Layout& layout, const RandomGraph& random,
                          const RandomPass& pass, const std::vector<graph::Image>& images,
                          const std::vector<graph::Buffer>& buffers, Push& push) {
        vk::ImageView color = *noColor_.view, depth = *noDepth_.view;
        vk::Buffer words = *noBuffer_.handle;
        for (const RandomUse& use : pass.uses) {
            if (use.verb == Verb::samples) {
                const bool isDepth = random.images[use.resource].format == VK_FORMAT_D32_SFLOAT;
                (isDepth ? depth : color) = c.view(images[use.resource]);
                push.reads |= isDepth ? 2 : 1;
            }
            if (use.verb != Verb::reads) continue;
            words = c.buffer(buffers[use.resource]);
            push.reads |= 4;
        }
        const vk::DescriptorSet set = c.descriptors.allocate(layout.set, "random");
        const vk::DescriptorImageInfo colorInfo(*sampler_, color, kTextureLayout),
            depthInfo(*sampler_, depth, kTextureLayout);
        const vk::DescriptorBufferInfo bufferInfo(words, 0, VK_WHOLE_SIZE);
        device->updateDescriptorSets(vk::WriteDescriptorSet(set, 0, 0, Type::eCombinedImageSampler, colorInfo), {});
        device->updateDescriptorSets(vk::WriteDescriptorSet(set, 1, 0, Type::eCombinedImageSampler, depthInfo), {});
        device->updateDescriptorSets(vk::WriteDescriptorSet(set, 2, 0, Type::eStorageBuffer, {}, bufferInfo), {});
        return set;
    }

    void draw(gpu::PassContext& c, const RandomGraph& random, const RandomPass& pass,
              const std::vector<graph::Image>& images, const std::vector<graph::Buffer>& buffers) {
        const RandomUse* input = pass.find(Verb::input);
        const bool onTile = input && !c.inputIsSampled;
        const gpu::Layout& layout = onTile ? onTile_ : plain_;
        Push push{pass.z, pass.seed, 0};
        const vk::DescriptorSet textures = set(c, layout, random, pass, images, buffers, push);
        const vk::DescriptorImageInfo info(onTile ? vk::Sampler() : *sampler_,
                                           input ? c.view(images[input->resource]) : *noColor_.view,
                                           onTile ? c.inputLayout : kTextureLayout);
        device->updateDescriptorSets(
            vk::WriteDescriptorSet(textures, 3, 0, onTile ? Type::eInputAttachment : Type::eCombinedImageSampler, info),
            {});
        gpu::GraphicsPipeline p = c.pipeline();
        p.vertex = shaders::randomVert;
        p.colorsWritten = static_cast<std::uint32_t>(std::count_if(
            pass.uses.begin(), pass.uses.end(), [](const RandomUse& use) { return use.verb == Verb::color; }));
        p.fragment = fragmentShader(p.colorsWritten, input != nullptr, c.inputIsSampled);
        p.layout = *layout.pipeline;
        p.depth = pass.find(Verb::depth)       ? gpu::DepthUse::write
                  : pass.find(Verb::depthTest) ? gpu::DepthUse::test
                                               : gpu::DepthUse::none;
        pipelines_.push_back(gpu::makePipeline(device, p));
        c.commands.bindPipeline(vk::PipelineBindPoint::eGraphics, *pipelines_.back());
        c.commands.bindDescriptorSets(vk::PipelineBindPoint::eGraphics, *layout.pipeline, 0, textures, {});
        c.commands.pushConstants<Push>(*layout.pipeline, kStages, 0, push);
        if (pass.half) c.commands.setScissor(0, vk::Rect2D({0, 0}, {c.extent.width / 2, c.extent.height}));
        c.commands.draw(3, 1, 0, 0);
    }

    void dispatch(gpu::PassContext& c, const RandomGraph& random, const RandomPass& pass,
                  const std::vector<graph::Image>& images, const std::vector<graph::Buffer>& buffers) {
        Push push{0, pass.seed, 0};
        const vk::DescriptorSet textures = set(c, compute_, random, pass, images, buffers, push);
        const vk::DescriptorBufferInfo target(c.buffer(buffers[pass.find(Verb::writes)->resource]), 0, VK_WHOLE_SIZE);
        device->updateDescriptorSets(vk::WriteDescriptorSet(textures, 3, 0, Type::eStorageBuffer, {}, target), {});
        pipelines_.push_back(gpu::makePipeline(
            device, gpu::ComputePipeline{"random compute", shaders::randomComp, {}, *compute_.pipeline}));
        c.commands.bindPipeline(vk::PipelineBindPoint::eCompute, *pipelines_.back());
        c.commands.bindDescriptorSets(vk::PipelineBindPoint::eCompute, *compute_.pipeline, 0, textures, {});
        c.commands.pushConstants<Push>(*compute_.pipeline, vk::ShaderStageFlagBits::eCompute, 0, push);
        c.commands.dispatch(kBufferWords / 64, 1, 1);
    }

    static void copy(gpu::PassContext& c, const RandomGraph& random, const RandomPass& pass,
                     const std::vector<graph::Image>& images, const std::vector<graph::Buffer>& buffers) {
        const std::uint32_t from = pass.find(Verb::copiesFrom)->resource;
        const RandomUse& to = *pass.find(Verb::copiesTo);
        const graph::ImageDesc& desc = random.images[from];
        constexpr auto kFrom = vk::ImageLayout::eTransferSrcOptimal;
        if (!to.isImage) {
            c.commands.copyImageToBuffer(c.image(images[from]), kFrom, c.buffer(buffers[to.resource]), wholeCopy(desc));
            return;
        }
        const vk::ImageSubresourceLayers layers(vk::ImageAspectFlagBits::eColor, 0, 0, 1);
        c.commands.copyImage(c.image(images[from]), kFrom, c.image(images[to.resource]),
                             vk::ImageLayout::eTransferDstOptimal,
                             vk::ImageCopy(layers, {}, layers, {}, {desc.extent.width, desc.extent.height, 1}));
    }

    vk::raii::Sampler sampler_ = gpu::makeSampler(device, vk::Filter::eNearest, "nearest");
    gpu::Layout plain_, onTile_, compute_;
    gpu::Image noColor_, noDepth_;
    gpu::Buffer noBuffer_;
    std::deque<vk::raii::Pipeline> pipelines_;
};

struct Way {
    const char* name;
    bool merge, tileSubpasses, transient, storeAll;
};
constexpr Way kWays[] = {{"merged", true, true, true, false},
                         {"merged, stored", true, true, false, true},
                         {"merged, no transient", true, true, false, false},
                         {"one subpass each", true, false, true, false},
                         {"unmerged", false, true, true, false}};

void expectTheSameBits(std::uint32_t firstSeed, std::uint32_t endSeed) {
    Runner runner;
    std::size_t subpasses = 0, inputs = 0, transients = 0, different = 0;
    std::vector<std::uint32_t> before;
    for (std::uint32_t seed = firstSeed; seed < endSeed; ++seed) {
        const RandomGraph random = randomGraph(seed, false);
        graph::PlanCaps caps = runner.device.caps().plan;
        caps.merge = false;
        caps.transient = false;
        caps.storeAll = true;
        const std::vector<std::uint32_t> expected = runner.run(random, caps);
        different += expected != before;
        before = expected;
        for (const Way& way : kWays) {
            caps.merge = way.merge;
            caps.tileSubpasses = way.tileSubpasses;
            caps.transient = way.transient;
            caps.storeAll = way.storeAll;
            EXPECT_EQ(runner.run(random, caps), expected) << "seed " << seed << ", " << way.name;
            for (const graph::Step& step : runner.plan.steps)
                for (const graph::Subpass& s : step.renderPass.subpasses) {
                    subpasses += &s != step.renderPass.subpasses.data();
                    inputs += s.inputs.size();
                }
            for (const graph::PlannedImage& image : runner.plan.images) transients += image.transient;
        }
        ASSERT_EQ(runner.device.validationMessages(), std::vector<std::string>{}) << "seed " << seed;
    }
    EXPECT_GT(different, (endSeed - firstSeed) * 4 / 5);  // the graphs do draw something
    EXPECT_GT(subpasses, 5u);
    EXPECT_GT(inputs, 2u);
    EXPECT_GT(transients, 5u);
}

TEST(RandomGraphs, GiveTheSameBitsHoweverTheyAreCarriedOut) { expectTheSameBits(0, 50); }

/// The same graphs by render passes and by dynamic rendering, each merged and not, with nothing stored but what must
/// be.
TEST(NewerDriver, GivesTheSameBitsOfRandomGraphsByDynamicRendering) {
    if (!NewerLavapipe::there()) GTEST_SKIP() << NewerLavapipe::kAbsent;
    const NewerLavapipe newer;
    std::optional<Runner> old;
    {
        const RenderPassesOfOld switched;
        old.emplace(false);
    }
    Runner now(false);
    ASSERT_TRUE(now.device.caps().localRead);
    ASSERT_FALSE(old->device.caps().localRead);
    std::size_t inputs = 0;
    for (std::uint32_t seed = 0; seed < 50; ++seed) {
        const RandomGraph random = randomGraph(seed, false);
        graph::PlanCaps caps = now.device.caps().plan;
        for (const bool merge : {true, false}) {
            caps.merge = merge;
            EXPECT_EQ(now.run(random, caps), old->run(random, caps)) << "seed " << seed << ", merge " << merge;
            for (const graph::Step& step : now.plan.steps)
                for (const graph::Subpass& s : step.renderPass.subpasses) inputs += s.inputs.size();
        }
    }
    EXPECT_GT(inputs, 2u);
}

TEST(RandomGraphs, GiveTheSameBitsLong) { expectTheSameBits(50, 150); }

}  // namespace
}  // namespace nacre::test
