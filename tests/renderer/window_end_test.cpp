// What a window at rest shows: the mean of its samples in linear light, the same where the colour and the sum stay on
// the tile, where the colour alone goes through memory, and where both do. SwiftShader's samplers decode sRGB with 16
// bits, and its input attachments with more: there a level may differ.

#include "engine/frame/window_end.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <vector>

#include "engine/passes/read_back.h"
#include "engine/srgb.h"
#include "tests/renderer/scenes.h"

namespace nacre::test {
namespace {

constexpr graph::Extent kExtent{37, 23};
constexpr std::size_t kBytes = std::size_t{4} * kExtent.width * kExtent.height;
using Bytes = std::vector<std::uint8_t>;

/// A sample of each pixel: 8-bit sRGB, no two alike.
Bytes takeSample(std::uint32_t i) {
    Bytes bytes(kBytes);
    std::uint32_t state = 2463534242u + i;
    for (std::uint8_t& byte : bytes) {
        state ^= state << 13, state ^= state >> 17, state ^= state << 5;
        byte = static_cast<std::uint8_t>(state >> 24);
    }
    return bytes;
}

int largestDifference(const Bytes& a, const Bytes& b) {
    int most = a.size() == b.size() ? 0 : 255;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) most = std::max(most, std::abs(a[i] - b[i]));
    return most;
}

/// Shows sums of samples in an image that stands for the window's.
class Rest {
public:
    explicit Rest(const graph::PlanCaps& caps) : device_({}), executor_(device_), caps_(caps) {
        using Usage = vk::ImageUsageFlagBits;
        sum_ = gpu::makeImage(device_, {kSumFormat, kExtent},
                              Usage::eColorAttachment | Usage::eSampled | Usage::eInputAttachment, false, "sum");
        window_ = gpu::makeImage(device_, {VK_FORMAT_R8G8B8A8_UNORM, kExtent},
                                 Usage::eColorAttachment | Usage::eTransferSrc, false, "window");
        pixels_ =
            gpu::makeBuffer(device_, kBytes, vk::BufferUsageFlagBits::eTransferDst, gpu::Access::readback, "pixels");
    }

    /// The window after a frame. @param i  of the sample; none: the kept sum
    Bytes show(std::optional<std::uint32_t> i) {
        Frame frame;
        gpu::Imports imports;
        gpu::Image sample;
        FrameShape shape;
        shape.window = kExtent;
        shape.choice.ending = !i ? Ending::sumToWindow : *i == 0 ? Ending::firstSample : Ending::nextSample;
        if (i) {
            const graph::ImageDesc desc{VK_FORMAT_R8G8B8A8_SRGB, kExtent};
            sample = passes::makeTexture(device_, executor_, desc, takeSample(*i), "sample");
            const graph::Image drawn = frame.graph.importImage("drawn", desc, passes::kTextureState);
            frame.targets.push_back(frame.graph.image("colour", desc));
            frame.graph.graphics("scene").samples(drawn).color(frame.targets[0]).record([=](gpu::PassContext& c) {
                passes::resample(c, c.view(drawn), {1});
            });
            imports.bind(drawn, sample);
            samples_.share = 1.0f / static_cast<float>(*i + 1);
        }
        WindowEnd{window_.desc.format, &samples_}.declare(frame, shape);
        imports.bind(*frame.sum, sum_);
        imports.bind(frame.targets.back(), window_);
        const graph::Plan plan = graph::compile(frame.graph, caps_);
        renderPasses_ = plan.steps.size();
        executor_.run(frame.graph, plan, imports);
        executor_.forgetFramebuffers();
        return read();
    }
    std::size_t renderPasses() const { return renderPasses_; }
    bool samplesExactly() const { return device_.caps().driverName.find("SwiftShader") == std::string::npos; }

private:
    Bytes read() {
        graph::Graph g("read");
        const graph::Image image = g.importImage("window", window_.desc, kWindowState);
        const graph::Buffer buffer = g.importBuffer("pixels", kBytes);
        passes::readBack(g, image, window_.desc, buffer);
        g.output(buffer);
        gpu::Imports imports;
        imports.bind(image, window_);
        imports.bind(buffer, pixels_);
        executor_.run(g, imports);
        pixels_.invalidate();
        const auto* bytes = reinterpret_cast<const std::uint8_t*>(pixels_.mapped);
        return {bytes, bytes + kBytes};
    }

    gpu::Device device_;
    gpu::Executor executor_;
    const graph::PlanCaps caps_;
    gpu::Image sum_, window_;
    gpu::Buffer pixels_;
    WindowSamples samples_;
    std::size_t renderPasses_ = 0;
};

graph::PlanCaps makeTileCaps(std::uint32_t bytes, bool subpasses = true) {
    graph::PlanCaps caps;
    caps.tileBytesPerPixel = bytes;
    caps.tileSubpasses = subpasses;
    return caps;
}

TEST(WindowEnd, ShowsTheMeanOfItsSamplesHoweverMuchStaysOnTheTile) {
    Rest onTile(makeTileCaps(16)), colorApart(makeTileCaps(12)), apart(makeTileCaps(16, false));
    std::vector<double> sum(kBytes);
    constexpr std::uint32_t kSamples = 3;
    for (std::uint32_t i = 0; i < kSamples; ++i) {
        const Bytes shown = onTile.show(i), apartShown = apart.show(i);
        const int most = onTile.samplesExactly() ? 0 : 1;
        EXPECT_LE(largestDifference(colorApart.show(i), apartShown), most) << i;
        EXPECT_LE(largestDifference(shown, apartShown), most) << i;
        EXPECT_EQ(onTile.renderPasses(), 1u);
        EXPECT_EQ(colorApart.renderPasses(), 2u);
        EXPECT_EQ(apart.renderPasses(), 3u);
        const Bytes sample = takeSample(i);
        for (std::size_t b = 0; b < kBytes; ++b) {
            sum[b] += srgbToLinear(static_cast<float>(sample[b]) / 255.0f);
            const double mean = 255.0 * linearToSrgb(static_cast<float>(sum[b] / (i + 1)));
            if (b % 4 == 3)
                ASSERT_EQ(shown[b], 255);
            else
                ASSERT_NEAR(shown[b], mean, 1.6) << "sample " << i << ", byte " << b;
        }
    }
    const Bytes kept = onTile.show(std::nullopt);
    EXPECT_LE(largestDifference(kept, apart.show(std::nullopt)), onTile.samplesExactly() ? 0 : 1);
    EXPECT_EQ(kept, onTile.show(std::nullopt));
}

}  // namespace
}  // namespace nacre::test
