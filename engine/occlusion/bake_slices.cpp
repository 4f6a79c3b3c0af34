// Splits a bake into submissions: whole directions, or parts of one.
#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/occlusion/bake.h"

namespace nacre::occlusion {
namespace {

// Cost of drawing a primitive on a map, in units: about forty vertices and fragments, compared with one texture read
// and its arithmetic.
constexpr double kUnitsOfInstance = 20;
// Minimum size of a part: each submission has a fixed cost.
constexpr std::uint64_t kLeastInstances = 256;
constexpr std::size_t kLeastTexels = 8192;
// Limit of primitives that the host lists beside frames: 20 to 40 ns each, which GPU timestamps do not measure.
constexpr std::uint64_t kMostListed = 65536;
// After this many directions, texels that no light reached are dropped: they stay dark.
constexpr int kTellsDeepTexels = 32;

}  // namespace

void Bake::step(gpu::Executor& executor, std::uint32_t most) {
    do {
        graph::Graph g("occlusion");
        gpu::Imports imports;
        if (declareSlice(g, imports, {most}) == 0) return;
        executor.run(g, imports);
        sliceDone();
    } while (work_);
}

/// Primitives that a slice draws.
std::uint64_t Bake::mostInstances(const Allowance& allowance) const {
    const std::uint64_t most = maps_.mostInstances();
    const bool lists = maps_.tiles() && !device_.caps().tiles.lists;
    return lists && std::isfinite(allowance.units) ? std::min(most, kMostListed) : most;
}

/// The next directions to start; their count is 0 if all have started.
Bake::Work Bake::nextWork(const Allowance& allowance) const {
    const auto behind = std::min_element(doneOf_.begin(), doneOf_.end());
    Work work;
    work.model = static_cast<std::uint32_t>(behind - doneOf_.begin());
    work.first = *behind;
    work.instances = maps_.instances(work.model);
    work.texels = countTexels(work.model);
    const double each = static_cast<double>(work.instances) * kUnitsOfInstance + static_cast<double>(work.texels);
    const std::uint32_t left = static_cast<std::uint32_t>(directions()) - static_cast<std::uint32_t>(work.first);
    const double fit = std::clamp(allowance.units / std::max(each, 1.0), 1.0, double{DepthMaps::kMostPerBatch});
    work.count = std::min({left, allowance.directions, maps_.perBatch(), static_cast<std::uint32_t>(fit)});
    // The next smaller batch size whose maps can be drawn at once.
    const std::uint64_t most = mostInstances(allowance);
    while (work.count > 1 && work.count * work.instances > most) work.count = work.count > 4 ? 4 : 1;
    // Deep texels are dropped after the same direction in every split, so the sums do not depend on it.
    if (work.first < kTellsDeepTexels)
        work.count = std::min(work.count, static_cast<std::uint32_t>(kTellsDeepTexels - work.first));
    // Shaders expect pairs of opposite directions in a batch of several.
    if (work.first % 2 == 1) work.count = std::min(work.count, 1u);
    if (work.count > 1 && work.count < left) work.count -= work.count % 2;
    return work;
}

double Bake::countUnits(const Work& work) {
    return work.count * (static_cast<double>(work.instances) * kUnitsOfInstance + static_cast<double>(work.texels));
}

bool Bake::drawnAtOnce(const Work& work, const Allowance& allowance) const {
    return work.count > 1 || (countUnits(work) <= allowance.units && work.instances <= mostInstances(allowance));
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
        pass.writes(sums).record(
            [=, this, maps = drawn.image, work = w](gpu::PassContext& c) { recordAccumulation(c, maps, batch, work); });
        if (apart_)
            readSums(g, imports, sums);
        else
            g.output(sums);  // the host reads them to drop deep texels
    };
    const std::uint64_t most = mostInstances(allowance);
    if (w.drawn == 0 && drawnAtOnce(w, allowance)) {
        w.drawnThen = w.instances;
        w.askedThen = w.texels;
        accumulate(maps_.declare(g, imports, frames, batch, w.model));
        return std::max(countUnits(w), 1.0);
    }
    // Parts of one direction: first draws all primitives, then tests all texels.
    if (w.drawn < w.instances) {
        const auto fit =
            static_cast<std::uint64_t>(std::min(allowance.units / kUnitsOfInstance, static_cast<double>(most)));
        w.drawnThen = std::min(w.drawn + std::max(fit, std::min(kLeastInstances, most)), w.instances);
        w.askedThen = 0;
        maps_.declarePart(g, imports, frames, w.model, w.drawn, w.drawnThen);
        return static_cast<double>(w.drawnThen - w.drawn) * kUnitsOfInstance;
    }
    w.askedThen =
        std::min(w.asked + std::max(static_cast<std::size_t>(std::min(allowance.units, 1e15)), kLeastTexels), w.texels);
    // Where nothing casts occlusion, no part was drawn.
    accumulate(w.instances > 0 ? maps_.drawnParts(g, imports) : maps_.declare(g, imports, frames, batch, w.model));
    return static_cast<double>(std::max<std::size_t>(w.askedThen - w.asked, 1));
}

double Bake::leastUnits() const {
    if (complete()) return 0;
    const Work w = work_ ? *work_ : nextWork({1});
    const double draw = static_cast<double>(std::min(kLeastInstances, w.instances - w.drawn)) * kUnitsOfInstance;
    return draw > 0 ? draw : static_cast<double>(std::min(kLeastTexels, w.texels - w.asked));
}

/// Copies the sums to memory that the host reads fast, if it reads them after this part.
void Bake::readSums(graph::Graph& g, gpu::Imports& imports, graph::Buffer sums) const {
    const int done = work_->first + static_cast<int>(work_->count);
    if (!work_->ends() || (done != kTellsDeepTexels && done != directions())) return g.output(sums);
    const auto read = g.importBuffer("occlusion sums, read", sumsRead_.size);
    imports.bind(read, sumsRead_);
    g.transfer("occlusion sums to the host").copiesFrom(sums).copiesTo(read).record([=, this](gpu::PassContext& c) {
        c.commands.copyBuffer(c.buffer(sums), c.buffer(read), vk::BufferCopy(0, 0, sums_.size));
    });
    g.output(read);
}

/// @returns whether to drop deep texels
bool Bake::advance() {
    work_->drawn = work_->drawnThen;
    work_->asked = work_->askedThen;
    if (work_->drawn < work_->instances || work_->asked < work_->texels) return false;
    const Work w = *work_;
    work_.reset();
    asked_ += std::uint64_t{w.count} * w.texels;
    doneOf_[w.model] += static_cast<int>(w.count);
    return w.first < kTellsDeepTexels && directionsDone() == kTellsDeepTexels && !complete();
}

void Bake::sliceDone() {
    if (advance()) dropDeepTexels();
}

bool Bake::sliceRecorded() {
    deepTexelsDue_ = advance();
    return complete() && !deepTexelsDue_;
}

void Bake::submissionDone() {
    if (std::exchange(deepTexelsDue_, false)) dropDeepTexels();
}

void Bake::finish(gpu::Executor& executor) {
    graph::Graph g("occlusion finish");
    gpu::Imports imports;
    declareFinish(g, imports);
    executor.run(g, imports);
}

}  // namespace nacre::occlusion
