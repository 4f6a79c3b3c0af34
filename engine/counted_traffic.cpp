#include "engine/counted_traffic.h"

#include <algorithm>
#include <cctype>
#include <initializer_list>
#include <string_view>

#include "engine/devices.h"
#include "engine/error.h"
#include "engine/frame/geometry.h"
#include "engine/frame/scene_frames.h"
#include "engine/gpu/performance_counters.h"
#include "engine/self_test.h"
#include "engine/self_test/scenes.h"

namespace nacre {
namespace {

constexpr std::uint32_t kCountedPixels = 720;

std::string lowered(std::string text) {
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

bool mentions(const std::string& text, std::initializer_list<std::string_view> words) {
    return std::ranges::any_of(words, [&](std::string_view word) { return text.find(word) != std::string::npos; });
}

/// The direction in the text; `neither` unless it names exactly one.
TrafficWay trafficWay(const std::string& text) {
    const bool reads = mentions(text, {"read", "load"}), writes = mentions(text, {"writ", "stor"});
    return reads == writes ? TrafficWay::neither : reads ? TrafficWay::read : TrafficWay::written;
}

/// A frame that can be recorded repeatedly.
class CountedFrame {
public:
    explicit CountedFrame(const gpu::Device& device)
        : executor_(device), frames_(device, executor_, scene_), declared_(device.caps().plan) {
        const TimedScene timed = timedScenes().back();
        scene_ = std::make_shared<Scene>(makeScene(device, timed.representation));
        RenderSettings settings = testSettings(scene_->representation, timed.projection,
                                               std::min(kCountedPixels, device.caps().maxImageSize));
        settings.lighting = true;
        const passes::Atlas none;
        prepared_ = frames_.prepare({settings, Part::whole, Ending::left}, {none, settings.view, "counted"});
        frame_ = declared_.of(prepared_.shape, [&](Frame& frame) {
            if (prepared_.shape.choice.shadedByCompute()) frame.graph.output(frame.numbers);
            for (const graph::Image target : frame.targets) frame.graph.output(target);
        });
        SceneFrames::bind(*frame_, prepared_);
    }

    /// Only for commands that are waited for.
    void record(gpu::CommandBuffer& commands) { executor_.record(commands, *frame_->recording, frame_->imports); }

    void tellPlan(CountedTraffic& traffic, const graph::GeometryCaps& caps) const {
        traffic.visibility = visibilityName(prepared_.choice().path);
        traffic.pixels = prepared_.shape.extent.width;
        const passes::SceneView& view = *prepared_.view;
        const std::vector<PassGeometry> geometry =
            describeGeometry(frame_->frame.graph, prepared_.counts, caps, view.plates, view.impostor);
        const std::uint64_t vertices = caps.storesVaryings ? sumGeometry(geometry).varyingBytes : 0;
        traffic.plannedRead = frame_->plan.total.loaded + vertices;
        traffic.plannedWritten = frame_->plan.total.stored + vertices;
    }

private:
    gpu::Executor executor_;
    std::shared_ptr<const Scene> scene_;
    SceneFrames frames_;
    DeclaredFrames declared_;
    PreparedFrame prepared_;
    std::shared_ptr<DeclaredFrame> frame_;
};

/// Draws by the path that a self-test chose, like this device's pictures.
void takeTestedPath(gpu::Device& device, const std::string& selfTests) {
    const std::optional<SelfTest> test = keptSelfTest(selfTests, device.caps().driverKey);
    if (!test || !isAutomatic(device.caps().visibility)) return;
    const graph::TestedPath byCaps = choosePath(device.caps());
    device.choose(choosePath(*test, byCaps.visibility, byCaps.why));
}

std::string formatMegabytes(std::uint64_t bytes) {
    const std::uint64_t tenths = (bytes + 50'000) / 100'000;
    return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10);
}

}  // namespace

TrafficWay trafficWay(const std::string& name, const std::string& category, const std::string& description) {
    const std::string names = lowered(name), texts = lowered(description);
    const std::string all = names + "\n" + lowered(category) + "\n" + texts;
    if (!mentions(all, {"external", "memory", "dram", "ddr", "vbif"}) ||
        mentions(all, {"cache", "tile", "local", "shared"}))
        return TrafficWay::neither;
    const TrafficWay way = trafficWay(names);
    return way == TrafficWay::neither ? trafficWay(texts) : way;
}

CountedTraffic countTraffic(const DeviceOptions& options) {
    CountedTraffic traffic;
    DeviceOptions alone = options;
    alone.surface = {};
    gpu::Device device(alone);
    if (!gpu::hasPerformanceCounters(device.physical())) {
        traffic.lacks = "the driver has no VK_KHR_performance_query";
        return traffic;
    }
    takeTestedPath(device, options.selfTests);
    const gpu::ByteCounters counters(device);
    CountedFrame frame(device);
    frame.tellPlan(traffic, device.caps().plan.geometry);
    const auto record = [&](gpu::CommandBuffer& c) { frame.record(c); };
    device.submitAndWait(record);  // makes pipelines and images
    for (const gpu::ByteCounter& counter : counters.counters()) {
        const std::optional<std::uint64_t> bytes = counters.count(counter, record);
        if (!bytes) continue;
        traffic.counters.push_back({counter.name, counter.category, *bytes});
        const TrafficWay way = trafficWay(counter.name, counter.category, counter.description);
        if (way == TrafficWay::read) traffic.read = traffic.read.value_or(0) + *bytes;
        if (way == TrafficWay::written) traffic.written = traffic.written.value_or(0) + *bytes;
    }
    if (traffic.counters.empty()) traffic.lacks = "no counter of the driver counts bytes";
    return traffic;
}

std::string describe(const CountedTraffic& traffic) {
    if (!traffic.lacks.empty()) return "not counted: " + traffic.lacks;
    const auto way = [](const char* name, const std::optional<std::uint64_t>& counted, std::uint64_t planned) {
        return (counted ? formatMegabytes(*counted) + " MB " + name : std::string("nothing counts what is ") + name) +
               ", planned " + formatMegabytes(planned);
    };
    const std::string side = std::to_string(traffic.pixels);
    return traffic.visibility + " at " + side + "x" + side + ": " + way("read", traffic.read, traffic.plannedRead) +
           "; " + way("written", traffic.written, traffic.plannedWritten);
}

}  // namespace nacre
