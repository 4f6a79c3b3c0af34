#include "engine/counted_traffic.h"

#include <algorithm>
#include <cctype>
#include <initializer_list>
#include <string_view>

#include "engine/devices.h"
#include "engine/frame/geometry.h"
#include "engine/frame/scene_frames.h"
#include "engine/gpu/performance_counters.h"
#include "engine/gpu/region_counters.h"
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
TrafficWay findWay(std::string text) {
    constexpr std::string_view kUnit = "load/store";  // of a shader core, and no direction
    for (std::size_t at; (at = text.find(kUnit)) != std::string::npos;) text.erase(at, kUnit.size());
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
    void countRegions(gpu::RegionCounters* counters) { executor_.countRegions(counters); }

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

void add(CountedTraffic& traffic, TrafficWay way, std::uint64_t bytes) {
    if (way == TrafficWay::read) traffic.read = traffic.read.value_or(0) + bytes;
    if (way == TrafficWay::written) traffic.written = traffic.written.value_or(0) + bytes;
}

void countByQueries(const gpu::Device& device, CountedFrame& frame, CountedTraffic& traffic) {
    const gpu::ByteCounters counters(device);
    for (const gpu::ByteCounter& counter : counters.counters()) {
        const std::optional<std::uint64_t> bytes =
            counters.count(counter, [&](gpu::CommandBuffer& c) { frame.record(c); });
        if (!bytes) continue;
        traffic.counters.push_back({counter.name, counter.category, *bytes});
        add(traffic, trafficWay(counter.name, counter.category, counter.description), *bytes);
    }
}

/// They count what the shader cores ask of memory. Where queries tell of the memory itself, those hold.
void countByRegions(const gpu::Device& device, CountedFrame& frame, CountedTraffic& traffic) {
    gpu::RegionCounters counters(device);
    frame.countRegions(&counters);
    const std::vector<std::uint64_t> sums = counters.count([&](gpu::CommandBuffer& c) { frame.record(c); });
    frame.countRegions(nullptr);
    const bool told = traffic.read || traffic.written;
    for (std::size_t i = 0; i < sums.size(); ++i) {
        const std::string& name = counters.names()[i];
        const std::optional<std::uint64_t> bytes = countedBytes(name, sums[i]);
        traffic.regions.push_back({name, sums[i], bytes});
        if (bytes && !told) add(traffic, trafficWay(name, "", ""), *bytes);
    }
}

std::string formatMegabytes(std::uint64_t bytes) {
    const std::uint64_t tenths = (bytes + 50'000) / 100'000;
    return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10);
}

}  // namespace

std::optional<std::uint64_t> countedBytes(const std::string& name, std::uint64_t sum) {
    constexpr std::uint64_t kBeatBytes = 16;  // Arm's performance counters: a beat is 128 bits
    const std::string text = lowered(name);
    if (mentions(text, {"byte"})) return sum;
    if (mentions(text, {"beat"})) return kBeatBytes * sum;
    return {};
}

TrafficWay trafficWay(const std::string& name, const std::string& category, const std::string& description) {
    const std::string names = lowered(name), texts = lowered(description);
    const std::string all = names + "\n" + lowered(category) + "\n" + texts;
    if (!mentions(all, {"external", "memory", "dram", "ddr", "vbif"}) ||
        mentions(all, {"cache", "tile", "local", "shared"}))
        return TrafficWay::neither;
    const TrafficWay way = findWay(names);
    return way == TrafficWay::neither ? findWay(texts) : way;
}

CountedTraffic countTraffic(const DeviceOptions& options) {
    CountedTraffic traffic;
    DeviceOptions alone = options;
    alone.surface = {};
    gpu::Device device(alone);
    const bool queries = gpu::hasPerformanceCounters(device.physical());
    const bool regions = gpu::hasRegionCounters(device.physical(), options.validate);
    if (!queries && !regions) {
        traffic.lacks = kNoCounters;
        return traffic;
    }
    takeTestedPath(device, options.selfTests);
    CountedFrame frame(device);
    frame.tellPlan(traffic, device.caps().plan.geometry);
    device.submitAndWait([&](gpu::CommandBuffer& c) { frame.record(c); });  // makes pipelines and images
    if (queries) countByQueries(device, frame, traffic);
    if (regions) countByRegions(device, frame, traffic);
    if (traffic.counters.empty() && traffic.regions.empty()) traffic.lacks = "no counter of the driver counts bytes";
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
