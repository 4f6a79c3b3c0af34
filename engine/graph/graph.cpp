#include "engine/graph/graph.h"

#include <atomic>
#include <string_view>

namespace nacre::graph {

std::string SourceLine::text() const {
    std::string_view path = file;
    // Path from the root of the source tree, wherever it was built.
    for (const char* top : {"/engine/", "/tests/", "/app/"})
        if (const std::size_t at = path.rfind(top); at != std::string_view::npos) path.remove_prefix(at + 1);
    return line == 0 ? "" : " (declared at " + std::string(path) + ":" + std::to_string(line) + ")";
}

std::array<std::uint64_t, 2> Share::range(std::size_t kind, const std::array<std::uint64_t, 3>& all) const {
    if (count == 1) return {0, all[kind]};
    std::uint64_t before = 0, total = 0;
    for (std::size_t k = 0; k < all.size(); ++k) {
        if (k == kind) before = total;
        total += all[k] * bytes[k];
    }
    const auto at = [&](std::uint64_t i) {
        if (bytes[kind] == 0) return i == 0 ? 0 : all[kind];
        const std::uint64_t border = total * i / count;
        return std::min((border - std::min(border, before)) / bytes[kind], all[kind]);
    };
    return {at(index), at(std::uint64_t{index} + 1)};
}

Graph::Graph(std::string name, std::uint32_t views) : name_(std::move(name)), views_(views) {
    static std::atomic<std::uint32_t> next{1};
    id_ = next++;
}

void Graph::check(std::uint32_t graph, std::uint32_t index, std::size_t count, const char* kind,
                  const std::string& user) const {
    if (graph == id_ && index < count) return;
    throw GraphError("graph '" + name_ + "', " + user + ": stale " + kind + " handle " + std::to_string(index) +
                     " (made by another graph, or never made)");
}

/// The last pass that wrote an image.
std::uint32_t Graph::writer(std::uint32_t image) const {
    for (std::size_t p = passes_.size(); p-- > 0;)
        for (const Use& use : passes_[p].uses)
            if (use.isImage && use.resource == image && isWrite(use.verb)) return static_cast<std::uint32_t>(p);
    return 0;
}

void Graph::check(Image image, const std::string& user) const {
    check(image.graph, image.index, images_.size(), "image", user);
    if (image.version == versions_[image.index]) return;
    const PassDecl& pass = passes_[writer(image.index)];
    throw GraphError("graph '" + name_ + "', " + user + ", image '" + images_[image.index].name +
                     "': a stale handle, of the image as it was before pass '" + pass.name + "' wrote it" +
                     pass.line.text());
}

Image Graph::image(std::string name, const ImageDesc& desc) {
    images_.push_back({std::move(name), desc, std::nullopt, false, false});
    images_.back().desc.layers = std::max(desc.layers, views_);
    versions_.push_back(0);
    return {static_cast<std::uint32_t>(images_.size() - 1), id_};
}

Image Graph::importImage(std::string name, const ImageDesc& desc, const State& state, bool undefined) {
    images_.push_back({std::move(name), desc, state, undefined, false});
    versions_.push_back(0);
    return {static_cast<std::uint32_t>(images_.size() - 1), id_};
}

Buffer Graph::importBuffer(std::string name, VkDeviceSize size, const State& state) {
    buffers_.push_back({std::move(name), size, state, false});
    return {static_cast<std::uint32_t>(buffers_.size() - 1), id_};
}

void Graph::output(Image image) {
    check(image, "output");
    images_[image.index].output = true;
}

void Graph::output(Buffer buffer) {
    check(buffer.graph, buffer.index, buffers_.size(), "buffer", "output");
    buffers_[buffer.index].output = true;
}

PassBuilder Graph::pass(std::string name, PassKind kind, SourceLine line) {
    passes_.push_back({std::move(name), kind, line, {}, {}, false, {}});
    return PassBuilder(*this, static_cast<std::uint32_t>(passes_.size() - 1));
}

PassBuilder& PassBuilder::use(Verb verb, Image image, std::optional<Clear> clear) {
    PassDecl& pass = graph_.passes_[pass_];
    graph_.check(image, "pass '" + pass.name + "'" + pass.line.text());
    pass.uses.push_back({verb, true, image.index, clear});
    return *this;
}

PassBuilder& PassBuilder::write(Verb verb, Image& image, std::optional<Clear> clear) {
    use(verb, image, clear);
    image.version = ++graph_.versions_[image.index];
    return *this;
}

PassBuilder& PassBuilder::use(Verb verb, Buffer buffer) {
    PassDecl& pass = graph_.passes_[pass_];
    graph_.check(buffer.graph, buffer.index, graph_.buffers_.size(), "buffer", "pass '" + pass.name + "'");
    pass.uses.push_back({verb, false, buffer.index, std::nullopt});
    return *this;
}

PassBuilder& PassBuilder::sideEffect() {
    graph_.passes_[pass_].sideEffect = true;
    return *this;
}

PassBuilder& PassBuilder::share(const Share& share) {
    graph_.passes_[pass_].share = share;
    return *this;
}

PassBuilder& PassBuilder::record(Work work) {
    graph_.passes_[pass_].work = std::move(work);
    return *this;
}

}  // namespace nacre::graph
