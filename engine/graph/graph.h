#pragma once
// The frame, declared: what each pass does to each image and buffer. Nothing here calls Vulkan (its enums are used).
//
//   Graph g("screen");
//   auto depth = g.image("depth", {VK_FORMAT_D32_SFLOAT, extent});
//   g.graphics("opaque prepass").depth(depth, Clear{1.0f}).record(plates);
//   g.graphics("impostor colour").depthTest(depth).color(picture, Clear{0, 0, 0, 1}).record(shade);
//   g.output(picture);
//   Plan plan = compile(g, caps);   // plan.h

#include <vulkan/vulkan_core.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace nacre::gpu {   // engine/gpu/execute.h
struct PassContext;      // passed to a pass when it records
struct PipelineContext;  // everything that its pipelines depend on
}  // namespace nacre::gpu

namespace nacre::graph {

using Record = std::function<void(gpu::PassContext&)>;
/// Work of a pass: a function that records it, and one that requests its pipelines ahead; or empty.
struct Work {
    Record record{};
    std::function<void(gpu::PipelineContext&)> want{};
};

struct Extent {
    std::uint32_t width = 0, height = 0;
    friend bool operator==(const Extent&, const Extent&) = default;
};

struct ImageDesc {
    VkFormat format = VK_FORMAT_UNDEFINED;
    Extent extent;
    std::uint32_t samples = 1;
    std::uint32_t layers = 1;
    std::uint32_t depth = 1;  ///< above 1: a three-dimensional texture
    friend bool operator==(const ImageDesc&, const ImageDesc&) = default;
};

/// Handles are valid for the graph that made them. Use in another graph is an error that names pass and resource.
/// A pass that writes an image updates the handle that it is given: copies made before are of an older version, and
/// their use is an error. So no pass reads an image as it was before another wrote it.
struct Image {
    std::uint32_t index = 0, graph = 0, version = 0;
};
struct Buffer {
    std::uint32_t index = 0, graph = 0;
};

/// Clear value of an attachment. One number clears depth or all channels.
struct Clear {
    std::array<float, 4> value{};
    constexpr Clear(float all) : value{all, all, all, all} {}
    constexpr Clear(float r, float g, float b, float a) : value{r, g, b, a} {}
    friend bool operator==(const Clear&, const Clear&) = default;
};

enum class PassKind : std::uint8_t { graphics, compute, transfer };
enum class Verb : std::uint8_t {
    depth,       // attachment, tested and written
    depthTest,   // attachment, tested only
    color,       // attachment, written (and blended)
    ordered,     // attachment, read and written at the pixel's own place, fragment after fragment in raster order
    resolve,     // one-sample attachment; the subpass writes the mean of its first colour's samples to it
    input,       // read at the pixel's own place
    density,     // map of how many fragments each part of the picture gets, read as the pass is recorded
    samples,     // texture
    stores,      // image that compute writes, each pixel at most once in a graph
    reads,       // buffer: storage or uniform, read
    writes,      // buffer: storage, read and written
    vertices,    // buffer: vertex streams
    copiesFrom,  // transfer source
    copiesTo,    // transfer target
};
constexpr bool isWrite(Verb verb) {
    return verb == Verb::depth || verb == Verb::color || verb == Verb::ordered || verb == Verb::resolve ||
           verb == Verb::stores || verb == Verb::writes || verb == Verb::copiesTo;
}
/// Whether a pass uses it pixel by pixel, on the tile.
constexpr bool isAttachment(Verb verb) { return verb <= Verb::input; }
const char* verbName(Verb verb);

/// State of a resource between frames.
struct State {
    VkPipelineStageFlags stages = VK_PIPELINE_STAGE_TOP_OF_PIPE_BIT;
    VkAccessFlags access = 0;
    VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;
    friend bool operator==(const State&, const State&) = default;
};

struct Use {
    Verb verb{};
    bool isImage = true;
    std::uint32_t resource = 0;
    std::optional<Clear> clear;
    friend bool operator==(const Use&, const Use&) = default;
};

/// Where something was declared, for errors.
struct SourceLine {
    const char* file = "";
    int line = 0;
    /// The line of the caller. (Clang 14 has no std::source_location.)
    static constexpr SourceLine here(const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
        return {file, line};
    }
    /// " (declared at engine/frame/frame.cpp:12)"
    std::string text() const;
};

/// The part of the scene's primitives that a pass draws. Several passes, each with a share, draw all of them in order:
/// first spheres, then cylinders, then triangles.
struct Share {
    std::uint32_t index = 0, count = 1;
    std::array<std::uint32_t, 3> bytes{};  ///< weight of a primitive of each kind; needed if count > 1
    bool apart = false;                    ///< begins a render pass

    /// First and end of a kind's primitives. @param all  number of each kind
    std::array<std::uint64_t, 2> range(std::size_t kind, const std::array<std::uint64_t, 3>& all) const;
    friend bool operator==(const Share&, const Share&) = default;
};

struct PassDecl {
    std::string name;
    PassKind kind{};
    SourceLine line{};
    std::vector<Use> uses;
    Work work;
    bool sideEffect = false;  ///< kept even if nothing reads its results
    Share share{};

    bool has(Verb verb) const {
        return std::any_of(uses.begin(), uses.end(), [&](const Use& use) { return use.verb == verb; });
    }
};

struct ImageDecl {
    std::string name;
    ImageDesc desc;
    std::optional<State> imported;  ///< imported: the state before and after execution
    bool undefined = false;         ///< imported without contents
    bool output = false;            ///< read after the graph has executed
    friend bool operator==(const ImageDecl&, const ImageDecl&) = default;
};

struct BufferDecl {
    std::string name;
    VkDeviceSize size = 0;
    State imported;       ///< the state before and after execution
    bool output = false;  ///< read by the host after the graph has executed
    friend bool operator==(const BufferDecl&, const BufferDecl&) = default;
};

class Graph;

/// Declares one pass. Every method returns the pass, so that calls chain.
class PassBuilder {
public:
    PassBuilder& depth(Image& image, std::optional<Clear> clear = {}) { return write(Verb::depth, image, clear); }
    PassBuilder& depthTest(Image image) { return use(Verb::depthTest, image); }
    PassBuilder& color(Image& image, std::optional<Clear> clear = {}) { return write(Verb::color, image, clear); }
    PassBuilder& ordered(Image& image, std::optional<Clear> clear = {}) { return write(Verb::ordered, image, clear); }
    PassBuilder& resolve(Image& image) { return write(Verb::resolve, image); }
    PassBuilder& input(Image image) { return use(Verb::input, image); }
    /// Imported, with contents: they are read before the graph executes.
    PassBuilder& density(Image map) { return use(Verb::density, map); }
    PassBuilder& samples(Image image) { return use(Verb::samples, image); }
    PassBuilder& stores(Image& image) { return write(Verb::stores, image, {}); }
    PassBuilder& copiesFrom(Image image) { return use(Verb::copiesFrom, image); }
    PassBuilder& copiesTo(Image& image) { return write(Verb::copiesTo, image); }
    PassBuilder& copiesFrom(Buffer buffer) { return use(Verb::copiesFrom, buffer); }
    PassBuilder& copiesTo(Buffer buffer) { return use(Verb::copiesTo, buffer); }
    PassBuilder& reads(Buffer buffer) { return use(Verb::reads, buffer); }
    PassBuilder& writes(Buffer buffer) { return use(Verb::writes, buffer); }
    PassBuilder& vertices(Buffer buffer) { return use(Verb::vertices, buffer); }
    PassBuilder& sideEffect();
    PassBuilder& share(const Share& share);
    PassBuilder& record(Record recorded) { return record(Work{std::move(recorded), {}}); }
    PassBuilder& record(Work work);

private:
    friend class Graph;
    PassBuilder(Graph& graph, std::uint32_t pass) : graph_(graph), pass_(pass) {}
    PassBuilder& use(Verb verb, Image image, std::optional<Clear> clear = {});
    PassBuilder& write(Verb verb, Image& image, std::optional<Clear> clear = {});
    PassBuilder& use(Verb verb, Buffer buffer);
    Graph& graph_;
    std::uint32_t pass_;
};

class Graph {
public:
    /// @param views  drawn at once by its passes: each of its own images has a layer per view
    explicit Graph(std::string name, std::uint32_t views = 1);

    /// An image that lives inside one execution. The plan decides memory and usage.
    Image image(std::string name, const ImageDesc& desc);
    /// An image from outside, in `state` before and after. It has contents unless `undefined`.
    Image importImage(std::string name, const ImageDesc& desc, const State& state, bool undefined = false);
    /// A buffer; all buffers are imported.
    Buffer importBuffer(std::string name, VkDeviceSize size, const State& state = {});

    PassBuilder graphics(std::string name, SourceLine line = SourceLine::here()) {
        return pass(std::move(name), PassKind::graphics, line);
    }
    PassBuilder compute(std::string name, SourceLine line = SourceLine::here()) {
        return pass(std::move(name), PassKind::compute, line);
    }
    PassBuilder transfer(std::string name, SourceLine line = SourceLine::here()) {
        return pass(std::move(name), PassKind::transfer, line);
    }

    /// Marks contents that are read after the graph has executed.
    void output(Image image);
    void output(Buffer buffer);

    const std::string& name() const { return name_; }
    std::uint32_t views() const { return views_; }
    const std::vector<PassDecl>& passes() const { return passes_; }
    const std::vector<ImageDecl>& images() const { return images_; }
    const std::vector<BufferDecl>& buffers() const { return buffers_; }

private:
    friend class PassBuilder;
    PassBuilder pass(std::string name, PassKind kind, SourceLine line);
    void check(std::uint32_t graph, std::uint32_t index, std::size_t count, const char* kind,
               const std::string& user) const;
    void check(Image image, const std::string& user) const;
    std::uint32_t writer(std::uint32_t image) const;

    std::string name_;
    std::uint32_t views_ = 1;
    std::uint32_t id_;
    std::vector<PassDecl> passes_;
    std::vector<ImageDecl> images_;
    std::vector<std::uint32_t> versions_;  ///< of the images
    std::vector<BufferDecl> buffers_;
};

/// A graph that cannot be planned: a bug in the program. The message names pass and resource.
class GraphError : public std::logic_error {
public:
    using std::logic_error::logic_error;
};

}  // namespace nacre::graph
