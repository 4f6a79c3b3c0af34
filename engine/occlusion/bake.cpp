#include "engine/occlusion/bake.h"

#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>

#include "engine/error.h"
#include "engine/occlusion/directions.h"
#include "engine/occlusion/pipelines.h"
#include "engine/passes/read_back.h"
#include "engine/passes/view_constants.h"

namespace nacre::occlusion {
namespace {

using Usage = vk::BufferUsageFlagBits;
using Type = vk::DescriptorType;
constexpr std::uint32_t kGroup = 64;            // local_size_x
constexpr std::uint32_t kGroupsPerRow = 32768;  // of a dispatch; the floor allows 65,535
constexpr std::uint64_t kBytesPerTexel = 2;     // of the atlas: the texel, and the byte that is copied into it
constexpr std::uint64_t kBytesPerOpen = 4 + 8;  // list entry, sums
// A primitive on a map, in units: some forty vertices and as many fragments, against a texture read and its arithmetic.
constexpr double kUnitsOfInstance = 20;
// Parts of a direction are no smaller: a submission costs time of its own.
constexpr std::uint64_t kLeastInstances = 256;
constexpr std::size_t kLeastTexels = 8192;
// So many directions tell which texels lie so deep that no light will come to matter: they stay dark, unasked.
constexpr int kTellsDeepTexels = 32;

/// Texels that a bake takes on, whatever the memory: its time goes with them. With few directions their noise outweighs
/// what finer patches bring.
std::uint64_t mostTexels(std::uint64_t primitives, int directions) {
    const double share = std::clamp(directions / 128.0, 0.5, 4.0);
    return static_cast<std::uint64_t>(share * (700'000.0 + 40.0 * static_cast<double>(primitives)));
}

constexpr graph::State kComputeBuffer{
    VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_SHADER_WRITE_BIT, {}};

std::uint64_t bytesOf(const OcclusionLayout& layout, std::uint64_t openTexels, std::uint64_t words) {
    return std::uint64_t{layout.width} * layout.height * kBytesPerTexel + openTexels * kBytesPerOpen +
           words * sizeof(AtlasWord);
}

/// Directions of one group of copies; a multiple of the floor's uniform buffer offset alignment, 256.
constexpr vk::DeviceSize kGroupBytes = sizeof(layout::Direction) * DepthMaps::kMostPerBatch;

void bind(const gpu::Device& device, vk::DescriptorSet set, std::uint32_t binding, Type type, vk::Buffer buffer,
          vk::DeviceSize offset = 0, vk::DeviceSize size = VK_WHOLE_SIZE) {
    const vk::DescriptorBufferInfo info(buffer, offset, size);
    device->updateDescriptorSets(vk::WriteDescriptorSet(set, binding, 0, type, {}, info), {});
}

void dispatch(const vk::raii::CommandBuffer& commands, std::uint64_t invocations) {
    const auto groups = static_cast<std::uint32_t>((invocations + kGroup - 1) / kGroup);
    const std::uint32_t wide = std::min(groups, kGroupsPerRow);
    if (groups) commands.dispatch(wide, (groups + wide - 1) / wide, 1);
}

std::uint32_t batchFor(std::uint32_t directions) { return directions > 4 ? 16 : directions > 1 ? 4 : 1; }

/// The finest patches of which everything fits.
BakePreparation prepared(const gpu::Caps& caps, const Representation& representation, const BakeOptions& options,
                         std::uint64_t mapBytes, const std::stop_token& stop) {
    const std::uint64_t budgetBytes = options.budgetBytes - std::min(mapBytes, options.budgetBytes);
    const std::size_t spheres = representation.spheres.size(), cylinders = representation.cylinders.size();
    const PrimitiveTree tree(representation);
    BakePreparation result;
    std::uint64_t least = 0;
    const std::size_t vertices = representation.meshVertices.size();
    for (const OcclusionLayout& layout : occlusionLayouts(spheres, cylinders, vertices, caps.maxImageSize)) {
        if (stop.stop_requested()) return result;
        if (layout.sphereEdge > options.detail) continue;
        // Guessed from a sample first: looking at every texel takes its time.
        least = bytesOf(layout, 0, 0);
        if (least > budgetBytes) continue;
        const double share = openShare(layout, representation, tree);
        const auto guess = static_cast<std::uint64_t>(share * static_cast<double>(layout.patchTexels()));
        least = bytesOf(layout, guess + 2 * vertices, (guess + 2 * vertices) / 4);
        if (least > budgetBytes ||
            (layout.sphereEdge > 1 && guess > mostTexels(spheres + cylinders, options.directions)))
            continue;
        result.open = openTexels(layout, representation, tree, stop);
        least = bytesOf(layout, result.open.texels.size(), result.open.words.size());
        if (least > budgetBytes) continue;
        result.layout = layout;
        return result;
    }
    throw Error("not enough memory for ambient occlusion", "",
                std::to_string(spheres + cylinders) + " primitives need " + std::to_string((least >> 20) + 1) +
                    " MB beside " + std::to_string(mapBytes >> 20) + " MB of depth maps, and " +
                    std::to_string(budgetBytes >> 20) + " MB are left of the budget (raise --occlusion-memory, or " +
                    "render with --occlusion off)");
}

}  // namespace

BakePreparation prepareBake(const gpu::Caps& caps, const Representation& representation, const BakeOptions& options,
                            const std::stop_token& stop) {
    const std::uint64_t maps =
        DepthMapSizes(caps, representation, options.path, options.budgetBytes / 2, options.detail).bytes;
    BakePreparation result = prepared(caps, representation, options, maps, stop);
    if (!stop.stop_requested()) result.copies = occlusionCopies(representation, result.layout, result.open.texels);
    return result;
}

Bake::Bake(const gpu::Device& device, const passes::SceneBuffers& scene, const Representation& representation,
           const BakeOptions& options, BakePreparation&& preparation)
    : device_(device),
      scene_(scene),
      directions_(occlusionDirections(options.directions)),
      maps_(device, scene, representation, options.path, options.budgetBytes / 2, options.detail),
      layout_(preparation.layout),
      copies_(std::move(preparation.copies)),
      doneOf_(maps_.models(), 0),
      budgetBytes_(options.budgetBytes) {
    makeBuffers(preparation.open);
}

Bake::Bake(const gpu::Device& device, gpu::Executor& executor, const passes::SceneBuffers& scene,
           const Representation& representation, const BakeOptions& options, const FinishedOcclusion& finished)
    : device_(device),
      scene_(scene),
      directions_(occlusionDirections(options.directions)),
      maps_(device, scene, representation, options.path, 0),
      layout_(finished.layout),
      texelCount_(finished.openTexels),
      seenSpheres_(finished.seenSpheres),
      doneOf_(1, options.directions),
      budgetBytes_(options.budgetBytes) {
    maps_.release();
    makeCells(finished.atlas);
    atlas_ = passes::makeTexture(device, executor, {VK_FORMAT_R8_UNORM, {layout_.width, layout_.height}},
                                 finished.atlas, "occlusion atlas");
    atlasDefined_ = true;
}

std::vector<std::uint8_t> Bake::atlasTexels() const {
    bytes_.invalidate();
    const auto* texels = reinterpret_cast<const std::uint8_t*>(bytes_.mapped);
    return {texels, texels + std::size_t{layout_.width} * layout_.height};
}

void Bake::makeBuffers(const OpenTexels& open) {
    texelCount_ = open.texels.size();
    wordCount_ = open.words.size();
    firstOfSphere_ = open.firstOfSphere;
    batchDirections_ = gpu::makeBuffer(device_, kGroupBytes * copies_.groups.size(),
                                       Usage::eUniformBuffer | Usage::eUniformTexelBuffer, gpu::Access::upload,
                                       "occlusion directions");
    if (maps_.tiles() && maps_.tiles()->texels())
        directionTexels_ =
            gpu::makeTexelView(device_, batchDirections_, vk::Format::eR32G32B32A32Sfloat, "occlusion directions");
    // The host reads all four: the first three to drop deep texels, the last to keep the atlas on disk.
    const auto shared = [&](std::uint64_t bytes, vk::BufferUsageFlags usage, const char* name) {
        return gpu::makeBuffer(device_, bytes, usage, gpu::Access::readback, name);
    };
    const std::size_t listBytes = texelCount_ * sizeof(std::uint32_t), wordBytes = wordCount_ * sizeof(AtlasWord);
    list_ = shared(listBytes, Usage::eStorageBuffer, "occlusion texels");
    if (listBytes) std::memcpy(list_.mapped, open.texels.data(), listBytes);
    words_ = shared(wordBytes, Usage::eStorageBuffer, "occlusion words");
    if (wordBytes) std::memcpy(words_.mapped, open.words.data(), wordBytes);
    sums_ = shared(texelCount_ * 8, Usage::eStorageBuffer, "occlusion sums");
    std::memset(sums_.mapped, 0, sums_.size);
    bytes_ = shared(std::uint64_t{layout_.width} * layout_.height, Usage::eStorageBuffer | Usage::eTransferSrc,
                    "occlusion bytes");
    std::memset(bytes_.mapped, 0, bytes_.size);
    for (const gpu::Buffer* buffer : {&list_, &words_, &sums_, &bytes_}) buffer->flush();
    atlas_ = gpu::makeImage(device_, {VK_FORMAT_R8_UNORM, {layout_.width, layout_.height}},
                            vk::ImageUsageFlagBits::eSampled | vk::ImageUsageFlagBits::eTransferDst, false,
                            "occlusion atlas");
}

int Bake::directionsDone() const { return *std::min_element(doneOf_.begin(), doneOf_.end()); }

std::uint64_t Bake::mapsDone() const {
    std::uint64_t sum = 0;
    for (const int done : doneOf_) sum += static_cast<std::uint64_t>(done);
    return sum;
}

std::size_t Bake::texelsOf(std::uint32_t model) const {
    std::size_t sum = 0;
    for (const OcclusionCopies::Run& run : copies_.runs) sum += run.model == model ? run.count : 0;
    return sum;
}

std::uint64_t Bake::bytes() const { return bytesOf(layout_, texelCount_, wordCount_) + maps_.bytes(); }

void Bake::release() {
    sums_.invalidate();
    bytes_.invalidate();
    const auto* sums = reinterpret_cast<const float*>(sums_.mapped);
    seenSpheres_.assign(layout_.sphereCount, false);
    for (std::size_t i = 0; i < seenSpheres_.size(); ++i)
        for (std::size_t k = firstOfSphere_[i]; k < firstOfSphere_[i + 1] && !seenSpheres_[i]; ++k)
            seenSpheres_[i] = sums[2 * k] > 0;
    maps_.release();
    directionTexels_ = nullptr;
    batchDirections_ = {};
    list_ = {};
    words_ = {};
    sums_ = {};
    makeCells({reinterpret_cast<const std::uint8_t*>(bytes_.mapped), std::size_t{layout_.width} * layout_.height});
    bytes_ = {};
    firstOfSphere_.clear();
}

/// What lies between four texels of a patch, as one word: those of spheres row by row, then those of cylinders.
void Bake::makeCells(std::span<const std::uint8_t> texels) {
    const OcclusionLayout& l = layout_;
    if (!device_.caps().tiles.shade || l.sphereEdge < 2) return;
    const std::uint64_t cells = std::uint64_t{l.sphereCount} * (l.sphereEdge - 1) * (l.sphereEdge - 1) +
                                std::uint64_t{l.cylinderCount} * (l.around - 1) * (l.along - 1) +
                                (std::uint64_t{l.vertexCount} + 1) / 2;
    const std::uint64_t bytes = cells * sizeof(std::uint32_t);
    if (bytes + 2 * texels.size() > budgetBytes_ || bytes > device_.caps().maxStorageBufferBytes) return;
    cells_ = gpu::makeBuffer(device_, bytes, Usage::eUniformTexelBuffer, gpu::Access::upload, "occlusion cells");
    cellTexels_ = gpu::makeTexelView(device_, cells_, vk::Format::eR32Uint, "occlusion cells");
    auto* cell = reinterpret_cast<std::uint32_t*>(cells_.mapped);
    const auto add = [&](std::uint32_t patch, std::uint32_t inRow, std::uint32_t top, std::uint32_t across,
                         std::uint32_t down) {
        const std::uint8_t* corner =
            texels.data() + (top + std::size_t{patch / inRow} * down) * l.width + std::size_t{patch % inRow} * across;
        for (std::uint32_t y = 0; y + 1 < down; ++y)
            for (std::uint32_t x = 0; x + 1 < across; ++x) {
                const std::uint8_t *here = corner + std::size_t{y} * l.width + x, *below = here + l.width;
                *cell++ = here[0] | std::uint32_t{here[1]} << 8 | std::uint32_t{below[0]} << 16 |
                          std::uint32_t{below[1]} << 24;
            }
    };
    for (std::uint32_t i = 0; i < l.sphereCount; ++i) add(i, l.spherePatches(), 0, l.sphereEdge, l.sphereEdge);
    for (std::uint32_t i = 0; i < l.cylinderCount; ++i) add(i, l.cylinderPatches(), l.sphereRows, l.around, l.along);
    if (l.vertexCount > 0)
        std::memcpy(cell, texels.data() + std::size_t{l.sphereRows + l.cylinderRows} * l.width,
                    2 * std::size_t{l.vertexCount});
}

layout::OcclusionConstants Bake::constants() const {
    const View view = maps_.view(glm::dmat3(1));
    const layout::ViewConstants v = passes::viewConstants(view, 0.0f, 0, 0);
    layout::OcclusionConstants c{};
    c.mapPixels = static_cast<int>(maps_.pixels());
    c.apart = static_cast<int>(maps_.tiles() ? maps_.tiles()->apart() : maps_.pixels());
    c.pitch = static_cast<int>(maps_.tiles() ? maps_.tiles()->pitch() : 0);
    c.pixelsPerAngstrom = static_cast<float>(view.pixelsPerAngstrom);
    c.pixel = static_cast<float>(1.0 / view.pixelsPerAngstrom);
    c.depthAt0 = (v.origin - v.depthStart) * v.perRange;
    c.depthPerPixel = c.pixel * v.perRange;
    c.sphereEdge = layout_.sphereEdge;
    c.around = layout_.around;
    c.along = layout_.along;
    c.spheres = layout_.sphereCount;
    c.firstVertex = scene_.sphereCount + 2 * scene_.cylinderCount + scene_.triangleCount;
    c.firstVertexTexel = static_cast<std::uint32_t>(layout_.patchTexels());
    return c;
}

float Bake::spreadOfTaps() const {
    // A few sticks among full atoms must not cost these four times the time.
    if (2 * std::uint64_t{layout_.cylinderCount} <= layout_.sphereCount) return 0;
    return widestTaps();
}

float Bake::widestTaps() const { return static_cast<float>(std::min(2.0 * std::sqrt(128.0 / directions()), 2.5)); }

float Bake::spreadOfVertices() const {
    // Of a cartoon of 4HHB (62,000 vertices) they take the RMS from 0.042 to 0.037. Surfaces have few thin parts, and
    // many vertices.
    constexpr std::uint32_t kMost = 200'000;
    return layout_.vertexCount <= kMost ? widestTaps() : spreadOfTaps();
}

vk::DescriptorSet Bake::accumulationSet(gpu::PassContext& context, std::optional<graph::Image> maps,
                                        std::uint32_t group) {
    const vk::DescriptorSet set =
        context.descriptors.allocate(accumulationLayout(context, !maps).set, "occlusion accumulation");
    bind(device_, set, 0, Type::eStorageBuffer, *scene_.shapes.handle);
    bind(device_, set, 2, Type::eStorageBuffer, *list_.handle);
    bind(device_, set, 3, Type::eStorageBuffer, *sums_.handle);
    if (!maps && maps_.tiles()->texels()) {
        const vk::BufferView heights = maps_.tiles()->texels(), directions = *directionTexels_;
        const vk::WriteDescriptorSet writes[] = {{set, 1, 0, 1, Type::eUniformTexelBuffer, {}, {}, &directions},
                                                 {set, 4, 0, 1, Type::eUniformTexelBuffer, {}, {}, &heights}};
        device_->updateDescriptorSets(writes, {});
        return set;
    }
    bind(device_, set, 1, Type::eUniformBuffer, *batchDirections_.handle, group * kGroupBytes, kGroupBytes);
    if (!maps) {
        bind(device_, set, 4, Type::eStorageBuffer, *maps_.tiles()->buffer().handle);
        return set;
    }
    const vk::DescriptorImageInfo info(context.pipelines.sampler(vk::Filter::eNearest), context.view(*maps),
                                       vk::ImageLayout::eShaderReadOnlyOptimal);
    device_->updateDescriptorSets(vk::WriteDescriptorSet(set, 4, 0, Type::eCombinedImageSampler, info), {});
    return set;
}

void Bake::recordAccumulation(gpu::PassContext& context, std::optional<graph::Image> maps, std::uint32_t batch,
                              std::uint32_t model, std::size_t first, std::size_t end) {
    constexpr auto kCompute = vk::PipelineBindPoint::eCompute;
    const vk::PipelineLayout pipelineLayout = *accumulationLayout(context, !maps).pipeline;
    const Texels spheres = layout_.sphereEdge == 1 ? Texels::wholeSpheres : Texels::spheres;
    layout::OcclusionConstants c = constants();
    std::vector<vk::DescriptorSet> sets(copies_.groups.size());
    std::size_t at = 0;  // of the model's texels
    for (const OcclusionCopies::Run& run : copies_.runs) {
        if (run.model != model) continue;
        const std::size_t from = std::clamp(first, at, at + run.count) - at;
        const std::size_t to = std::clamp(end, at, at + run.count) - at;
        at += run.count;
        if (from == to) continue;
        if (!sets[run.group]) sets[run.group] = accumulationSet(context, maps, run.group);
        c.firstDirection = run.group * static_cast<std::uint32_t>(kGroupBytes / sizeof(glm::vec4));
        c.firstEntry = static_cast<std::uint32_t>(run.first + from);
        c.entries = static_cast<std::uint32_t>(to - from);
        using Of = OcclusionCopies::Run::Of;
        const bool vertices = run.of == Of::vertices;
        c.step = run.step;
        const Accumulation what{vertices                  ? Texels::vertices
                                : run.of == Of::cylinders ? Texels::cylinders
                                                          : spheres,
                                batch,
                                maps_.encoded(),
                                !maps,
                                maps_.across(batch),
                                vertices ? spreadOfVertices() : spreadOfTaps()};
        context.commands.bindPipeline(kCompute, accumulationPipeline(context, what));
        context.commands.bindDescriptorSets(kCompute, pipelineLayout, 0, sets[run.group], {});
        context.commands.pushConstants<layout::OcclusionConstants>(pipelineLayout, vk::ShaderStageFlagBits::eCompute, 0,
                                                                   c);
        dispatch(context.commands, to - from);
    }
}

/// The directions of a batch as each group of copies meets them: the copy that a direction asks about is moved to its
/// place first. Of those that a batch lacks all is zero. Lengths are a map's pixels, its rows run downwards.
/// @param first  number of the batch's first direction
void Bake::writeDirections(std::span<const glm::dmat3> frames, int first) {
    auto* direction = reinterpret_cast<layout::Direction*>(batchDirections_.mapped);
    const double scale = maps_.view(glm::dmat3(1)).pixelsPerAngstrom, middle = maps_.pixels() / 2.0;
    const glm::dmat3 toPixels(scale, 0, 0, 0, -scale, 0, 0, 0, scale);
    for (const std::vector<glm::dmat4x3>& places : copies_.groups)
        for (std::size_t i = 0; i < DepthMaps::kMostPerBatch; ++i, ++direction) {
            *direction = {};
            if (i >= frames.size()) continue;
            const glm::dmat4x3& place = places[(static_cast<std::size_t>(first) + i) % places.size()];
            const glm::dmat3 frame = toPixels * frames[i];
            const glm::dmat3 rows = glm::transpose(frame * glm::dmat3(place[0], place[1], place[2]));
            const glm::dvec3 shift = frame * place[3] + glm::dvec3(middle, middle, 0);
            *direction = {glm::vec4(rows[0], shift.x), glm::vec4(rows[1], shift.y), glm::vec4(rows[2], shift.z)};
        }
}

void Bake::step(gpu::Executor& executor, std::uint32_t most) {
    do {
        graph::Graph g("occlusion");
        gpu::Imports imports;
        if (declareSlice(g, imports, {most}) == 0) return;
        executor.run(g, imports);
        sliceDone();
    } while (work_);
}

/// Directions that nobody has begun. None are left: of none.
Bake::Work Bake::nextWork(const Allowance& allowance) const {
    const auto behind = std::min_element(doneOf_.begin(), doneOf_.end());
    Work work;
    work.model = static_cast<std::uint32_t>(behind - doneOf_.begin());
    work.first = *behind;
    work.instances = maps_.instances(work.model);
    work.texels = texelsOf(work.model);
    const double each = static_cast<double>(work.instances) * kUnitsOfInstance + static_cast<double>(work.texels);
    const std::uint32_t left = static_cast<std::uint32_t>(directions()) - static_cast<std::uint32_t>(work.first);
    const double fit = std::clamp(allowance.units / std::max(each, 1.0), 1.0, double{DepthMaps::kMostPerBatch});
    work.count = std::min({left, allowance.directions, maps_.perBatch(), static_cast<std::uint32_t>(fit)});
    // The next smaller size of a batch whose maps are drawn at once.
    while (work.count > 1 && work.count * work.instances > maps_.mostInstances()) work.count = work.count > 4 ? 4 : 1;
    // However the directions are dealt out: deep texels are dropped after the same one, and the sums come out the same.
    if (work.first < kTellsDeepTexels)
        work.count = std::min(work.count, static_cast<std::uint32_t>(kTellsDeepTexels - work.first));
    return work;
}

double Bake::declareSlice(graph::Graph& g, gpu::Imports& imports, const Allowance& allowance) {
    if (!work_) {
        const Work next = nextWork(allowance);
        if (next.count == 0) return 0;
        work_ = next;
        writeDirections(std::span(directions_.data() + next.first, next.count), next.first);
    }
    Work& w = *work_;
    const std::uint32_t batch = batchFor(w.count);
    const std::span<const glm::dmat3> frames(directions_.data() + w.first, w.count);
    const auto sums = g.importBuffer("occlusion sums", sums_.size, kComputeBuffer);
    imports.bind(sums, sums_);
    const auto accumulate = [&](const DrawnMaps& drawn) {
        graph::PassBuilder pass = g.compute("occlusion accumulation");
        if (drawn.image) pass.samples(*drawn.image);
        if (drawn.heights) pass.reads(*drawn.heights);
        pass.writes(sums).record([=, this, maps = drawn.image, model = w.model, first = w.asked, end = w.askedThen](
                                     gpu::PassContext& c) { recordAccumulation(c, maps, batch, model, first, end); });
        g.output(sums);  // the host drops deep texels by them
    };
    const double drawing = static_cast<double>(w.instances) * kUnitsOfInstance;
    const double whole = w.count * (drawing + static_cast<double>(w.texels));
    if (w.drawn == 0 && (w.count > 1 || (whole <= allowance.units && w.instances <= maps_.mostInstances()))) {
        w.drawnThen = w.instances;
        w.askedThen = w.texels;
        accumulate(maps_.declare(g, imports, frames, batch, w.model));
        return std::max(whole, 1.0);
    }
    // Parts of one direction: first all primitives are drawn, then all texels asked.
    if (w.drawn < w.instances) {
        const auto most = static_cast<std::uint64_t>(
            std::min(allowance.units / kUnitsOfInstance, static_cast<double>(maps_.mostInstances())));
        w.drawnThen = std::min(w.drawn + std::max(most, std::min(kLeastInstances, maps_.mostInstances())), w.instances);
        w.askedThen = 0;
        maps_.declarePart(g, imports, frames, w.model, w.drawn, w.drawnThen);
        return static_cast<double>(w.drawnThen - w.drawn) * kUnitsOfInstance;
    }
    w.askedThen =
        std::min(w.asked + std::max(static_cast<std::size_t>(std::min(allowance.units, 1e15)), kLeastTexels), w.texels);
    accumulate(maps_.drawnParts(g, imports));
    return static_cast<double>(std::max<std::size_t>(w.askedThen - w.asked, 1));
}

double Bake::leastUnits() const {
    if (complete()) return 0;
    const Work w = work_ ? *work_ : nextWork({1});
    const double draw = static_cast<double>(std::min(kLeastInstances, w.instances - w.drawn)) * kUnitsOfInstance;
    return draw > 0 ? draw : static_cast<double>(std::min(kLeastTexels, w.texels - w.asked));
}

void Bake::sliceDone() {
    work_->drawn = work_->drawnThen;
    work_->asked = work_->askedThen;
    if (work_->drawn < work_->instances || work_->asked < work_->texels) return;
    const Work w = *work_;
    work_.reset();
    asked_ += std::uint64_t{w.count} * w.texels;
    doneOf_[w.model] += static_cast<int>(w.count);
    if (w.first < kTellsDeepTexels && directionsDone() == kTellsDeepTexels) dropDeepTexels();
}

/// Takes the texels off the list that no direction has lit so far, and moves the others up.
void Bake::dropDeepTexels() {
    sums_.invalidate();  // the other two only the host writes
    auto* list = reinterpret_cast<std::uint32_t*>(list_.mapped);
    auto* sums = reinterpret_cast<glm::vec2*>(sums_.mapped);
    std::vector<std::uint32_t> keptBefore(texelCount_ + 1);
    std::uint32_t kept = 0;
    for (std::size_t i = 0; i < texelCount_; ++i) {
        keptBefore[i] = kept;
        if (sums[i].x == 0) continue;
        list[kept] = list[i];
        sums[kept++] = sums[i];
    }
    keptBefore[texelCount_] = kept;
    auto* words = reinterpret_cast<AtlasWord*>(words_.mapped);
    for (std::size_t i = 0; i < wordCount_; ++i) {
        const std::uint32_t base = words[i].base;
        words[i].base = keptBefore[base];
        const auto follow = [&](std::uint16_t& entry) {
            if (entry == AtlasWord::kNone) return;
            const std::uint32_t before = keptBefore[base + entry];
            entry = keptBefore[base + entry + 1] == before ? AtlasWord::kNone  // dropped
                                                           : static_cast<std::uint16_t>(before - words[i].base);
        };
        for (AtlasWord::Source& source : words[i].sources) {
            follow(source.entry);
            follow(source.beyond);
        }
    }
    for (std::uint32_t& first : firstOfSphere_) first = keptBefore[first];
    for (OcclusionCopies::Run& run : copies_.runs) {
        const std::uint32_t end = keptBefore[run.first + run.count];
        run.first = keptBefore[run.first];
        run.count = end - run.first;
    }
    texelCount_ = kept;
    for (const gpu::Buffer* buffer : {&list_, &sums_, &words_}) buffer->flush();
}

void Bake::finish(gpu::Executor& executor) {
    graph::Graph g("occlusion finish");
    gpu::Imports imports;
    declareFinish(g, imports);
    executor.run(g, imports);
}

void Bake::declareFinish(graph::Graph& g, gpu::Imports& imports) {
    const auto sums = g.importBuffer("occlusion sums", sums_.size, kComputeBuffer);
    const auto bytes = g.importBuffer("occlusion bytes", bytes_.size, kComputeBuffer);
    const auto atlas = g.importImage("occlusion atlas", atlas_.desc, passes::kTextureState, !atlasDefined_);
    g.compute("occlusion finish").reads(sums).writes(bytes).record([this](gpu::PassContext& c) {
        const vk::DescriptorSet set = c.descriptors.allocate(finishLayout(c).set, "occlusion finish");
        bind(device_, set, 0, Type::eStorageBuffer, *sums_.handle);
        bind(device_, set, 1, Type::eStorageBuffer, *words_.handle);
        bind(device_, set, 2, Type::eStorageBuffer, *bytes_.handle);
        c.commands.bindPipeline(vk::PipelineBindPoint::eCompute, finishPipeline(c));
        c.commands.bindDescriptorSets(vk::PipelineBindPoint::eCompute, *finishLayout(c).pipeline, 0, set, {});
        c.commands.pushConstants<std::uint32_t>(*finishLayout(c).pipeline, vk::ShaderStageFlagBits::eCompute, 0,
                                                static_cast<std::uint32_t>(wordCount_));
        dispatch(c.commands, wordCount_);
    });
    g.transfer("occlusion upload").copiesFrom(bytes).copiesTo(atlas).record([=, this](gpu::PassContext& c) {
        const vk::BufferImageCopy all(0, 0, 0, {vk::ImageAspectFlagBits::eColor, 0, 0, 1}, {},
                                      {layout_.width, layout_.height, 1});
        c.commands.copyBufferToImage(c.buffer(bytes), c.image(atlas), vk::ImageLayout::eTransferDstOptimal, all);
    });
    g.output(bytes);  // the host keeps them
    imports.bind(sums, sums_);
    imports.bind(bytes, bytes_);
    imports.bind(atlas, atlas_);
    atlasDefined_ = true;
}

}  // namespace nacre::occlusion
