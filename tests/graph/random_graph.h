#pragma once
// Small graphs by chance, the same for the same seed: what the planner is judged on, on paper and on a device.

#include <algorithm>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "engine/graph/graph.h"

namespace nacre::test {

struct RandomUse {
    graph::Verb verb{};
    bool isImage = true;
    std::uint32_t resource = 0;
    bool clear = false;
};

struct RandomPass {
    graph::PassKind kind{};
    std::vector<RandomUse> uses;
    std::uint32_t seed = 0;  ///< of what it writes
    bool half = false;       ///< writes the left half of the pixels alone
    float z = 0.5f;          ///< of everything that it draws

    const RandomUse* find(graph::Verb verb, std::size_t skip = 0) const {
        for (const RandomUse& use : uses)
            if (use.verb == verb && skip-- == 0) return &use;
        return nullptr;
    }
};

struct RandomGraph {
    std::vector<graph::ImageDesc> images;
    std::vector<bool> imported;  ///< by images
    std::uint32_t buffers = 2;   ///< of kBufferWords words
    std::vector<RandomPass> passes;
    std::vector<bool> outputs;  ///< by images
};

constexpr std::uint32_t kBufferWords = 16 * 16 * 2;
constexpr graph::State kImportedState{VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT, VK_ACCESS_SHADER_READ_BIT,
                                      VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
constexpr graph::State kBufferState{
    VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_SHADER_WRITE_BIT, {}};

class RandomGraphMaker {
public:
    RandomGraphMaker(std::uint32_t seed, bool imports, bool ordered) : random_(seed), ordered_(ordered) {
        constexpr VkFormat kFormats[] = {VK_FORMAT_D32_SFLOAT,  VK_FORMAT_R32_UINT,    VK_FORMAT_R32_UINT,
                                         VK_FORMAT_R32G32_UINT, VK_FORMAT_R32G32_UINT, VK_FORMAT_D32_SFLOAT,
                                         VK_FORMAT_R32_UINT};
        const std::uint32_t count = 3 + below(5);
        for (std::uint32_t i = 0; i < count; ++i) {
            const std::uint32_t side = chance(1, 8) ? 8 : 16;
            graph_.images.push_back({kFormats[i], {side, side}});
            graph_.imported.push_back(imports && !isDepth(i) && chance(1, 4));
        }
        defined_ = graph_.imported;
        const std::uint32_t passes = 3 + below(8);
        for (std::uint32_t p = 0; p < passes; ++p) addPass();
        for (std::uint32_t i = 0; i < count; ++i) graph_.outputs.push_back(defined_[i] && !isDepth(i) && chance(1, 2));
    }
    const RandomGraph& graph() const { return graph_; }

private:
    std::uint32_t below(std::uint32_t n) { return static_cast<std::uint32_t>(random_() % n); }
    bool chance(std::uint32_t of, std::uint32_t in) { return below(in) < of; }
    bool isDepth(std::uint32_t image) const { return graph_.images[image].format == VK_FORMAT_D32_SFLOAT; }

    /// Any image that fits; none: the number of images.
    std::uint32_t pick(const RandomPass& pass, const std::function<bool(std::uint32_t)>& fits) {
        std::vector<std::uint32_t> list;
        for (std::uint32_t i = 0; i < graph_.images.size(); ++i) {
            const bool used = std::any_of(pass.uses.begin(), pass.uses.end(),
                                          [&](const RandomUse& use) { return use.isImage && use.resource == i; });
            if (!used && fits(i)) list.push_back(i);
        }
        return list.empty() ? static_cast<std::uint32_t>(graph_.images.size())
                            : list[below(static_cast<std::uint32_t>(list.size()))];
    }
    bool use(RandomPass& pass, graph::Verb verb, std::uint32_t image, bool clear = false) {
        if (image >= graph_.images.size()) return false;
        pass.uses.push_back({verb, true, image, clear});
        return true;
    }

    void addPass() {
        RandomPass pass;
        pass.seed = static_cast<std::uint32_t>(random_());
        pass.half = chance(1, 2);
        pass.z = 0.1f + 0.1f * static_cast<float>(below(8));
        const std::uint32_t kind = below(10);
        if (kind < 7)
            graphics(pass);
        else if (kind < 8)
            compute(pass);
        else
            transfer(pass);
        if (pass.uses.empty()) return;
        for (const RandomUse& u : pass.uses)
            if (u.isImage && graph::isWrite(u.verb)) defined_[u.resource] = true;
        graph_.passes.push_back(std::move(pass));
    }

    void graphics(RandomPass& pass) {
        pass.kind = graph::PassKind::graphics;
        const graph::Extent extent = chance(1, 8) ? graph::Extent{8, 8} : graph::Extent{16, 16};
        const auto here = [&](std::uint32_t i) { return graph_.images[i].extent == extent; };
        const auto color = [&](std::uint32_t i) { return here(i) && !isDepth(i); };
        if (chance(2, 3)) {
            const std::uint32_t depth = pick(pass, [&](std::uint32_t i) { return here(i) && isDepth(i); });
            if (depth < graph_.images.size()) {
                const bool writes = !defined_[depth] || chance(1, 2);
                use(pass, writes ? graph::Verb::depth : graph::Verb::depthTest, depth,
                    !defined_[depth] || (writes && chance(1, 4)));
            }
        }
        if (chance(1, 2)) use(pass, graph::Verb::input, pick(pass, [&](auto i) { return color(i) && defined_[i]; }));
        if (chance(1, 3))
            use(pass, graph::Verb::samples, pick(pass, [&](auto i) { return !isDepth(i) && defined_[i]; }));
        if (chance(1, 5))
            use(pass, graph::Verb::samples, pick(pass, [&](auto i) { return isDepth(i) && defined_[i]; }));
        if (chance(1, 5)) pass.uses.push_back({graph::Verb::reads, false, below(graph_.buffers), false});
        const std::uint32_t colors = below(3);
        for (std::uint32_t c = 0; c < colors; ++c) {
            const std::uint32_t image = pick(pass, color);
            if (image >= graph_.images.size()) continue;
            const bool clear = chance(1, 2);
            if (!defined_[image] && !clear) pass.half = false;  // or pixels would have no value
            use(pass, ordered_ && chance(1, 5) ? graph::Verb::ordered : graph::Verb::color, image, clear);
        }
        const bool draws =
            pass.find(graph::Verb::color) || pass.find(graph::Verb::ordered) || pass.find(graph::Verb::depth);
        if (!draws) pass.uses.clear();
        // What a depth test rejects would have no value either.
        const bool tests = pass.find(graph::Verb::depth) || pass.find(graph::Verb::depthTest);
        for (RandomUse& u : pass.uses)
            if (!defined_[u.resource] &&
                (u.verb == graph::Verb::ordered || (u.verb == graph::Verb::color && (pass.half || tests))))
                u.clear = true;
    }

    void compute(RandomPass& pass) {
        pass.kind = graph::PassKind::compute;
        if (chance(1, 2))
            use(pass, graph::Verb::samples, pick(pass, [&](auto i) { return !isDepth(i) && defined_[i]; }));
        const std::uint32_t target = below(graph_.buffers);
        pass.uses.push_back({graph::Verb::writes, false, target, false});
        if (chance(1, 2)) pass.uses.push_back({graph::Verb::reads, false, (target + 1) % graph_.buffers, false});
    }

    void transfer(RandomPass& pass) {
        pass.kind = graph::PassKind::transfer;
        const std::uint32_t from = pick(pass, [&](auto i) { return !isDepth(i) && defined_[i]; });
        const bool toImage = chance(2, 3);
        if (from >= graph_.images.size()) return;
        if (!toImage) {
            use(pass, graph::Verb::copiesFrom, from);
            pass.uses.push_back({graph::Verb::copiesTo, false, below(graph_.buffers), false});
            return;
        }
        const std::uint32_t to =
            pick(pass, [&](auto i) { return i != from && graph_.images[i] == graph_.images[from]; });
        if (to < graph_.images.size()) {
            use(pass, graph::Verb::copiesFrom, from);
            use(pass, graph::Verb::copiesTo, to);
        }
    }

    std::mt19937 random_;
    bool ordered_;
    RandomGraph graph_;
    std::vector<bool> defined_;
};

/// @param imports  some images come from outside
/// @param ordered  some attachments are read in raster order
inline RandomGraph randomGraph(std::uint32_t seed, bool imports, bool ordered = false) {
    return RandomGraphMaker(seed, imports, ordered).graph();
}

/// The graph, declared, and its handles.
struct DeclaredGraph {
    graph::Graph graph{"random"};
    std::vector<graph::Image> images;
    std::vector<graph::Buffer> buffers;
};

inline DeclaredGraph declare(const RandomGraph& random,
                             const std::function<graph::Record(std::size_t pass, const DeclaredGraph&)>& record = {}) {
    DeclaredGraph d;
    for (std::size_t i = 0; i < random.images.size(); ++i) {
        const std::string name = "image " + std::to_string(i);
        d.images.push_back(random.imported[i] ? d.graph.importImage(name, random.images[i], kImportedState)
                                              : d.graph.image(name, random.images[i]));
    }
    for (std::uint32_t b = 0; b < random.buffers; ++b)
        d.buffers.push_back(d.graph.importBuffer("buffer " + std::to_string(b), kBufferWords * 4, kBufferState));
    for (std::size_t p = 0; p < random.passes.size(); ++p) {
        const RandomPass& pass = random.passes[p];
        const std::string name = "pass " + std::to_string(p);
        graph::PassBuilder builder = pass.kind == graph::PassKind::graphics  ? d.graph.graphics(name)
                                     : pass.kind == graph::PassKind::compute ? d.graph.compute(name)
                                                                             : d.graph.transfer(name);
        for (const RandomUse& use : pass.uses) {
            const std::optional<graph::Clear> clear = use.clear ? std::optional<graph::Clear>(1.0f) : std::nullopt;
            switch (use.verb) {
                case graph::Verb::depth:
                    builder.depth(d.images[use.resource], clear);
                    break;
                case graph::Verb::depthTest:
                    builder.depthTest(d.images[use.resource]);
                    break;
                case graph::Verb::color:
                    builder.color(d.images[use.resource], clear);
                    break;
                case graph::Verb::ordered:
                    builder.ordered(d.images[use.resource], clear);
                    break;
                case graph::Verb::resolve:
                    builder.resolve(d.images[use.resource]);
                    break;
                case graph::Verb::input:
                    builder.input(d.images[use.resource]);
                    break;
                case graph::Verb::density:
                    builder.density(d.images[use.resource]);
                    break;
                case graph::Verb::samples:
                    builder.samples(d.images[use.resource]);
                    break;
                case graph::Verb::stores:
                    builder.stores(d.images[use.resource]);
                    break;
                case graph::Verb::reads:
                    builder.reads(d.buffers[use.resource]);
                    break;
                case graph::Verb::writes:
                    builder.writes(d.buffers[use.resource]);
                    break;
                case graph::Verb::vertices:
                    builder.vertices(d.buffers[use.resource]);
                    break;
                case graph::Verb::copiesFrom:
                    builder.copiesFrom(d.images[use.resource]);
                    break;
                case graph::Verb::copiesTo:
                    use.isImage ? builder.copiesTo(d.images[use.resource]) : builder.copiesTo(d.buffers[use.resource]);
                    break;
            }
        }
        if (record) builder.record(record(p, d));
    }
    for (std::size_t i = 0; i < random.images.size(); ++i)
        if (random.outputs[i]) d.graph.output(d.images[i]);
    return d;
}

}  // namespace nacre::test
