#include "engine/graph/graph.h"

#include <atomic>

namespace nacre::graph {

Graph::Graph(std::string name) : name_(std::move(name)) {
    static std::atomic<std::uint32_t> next{1};
    id_ = next++;
}

void Graph::check(std::uint32_t graph, std::uint32_t index, std::size_t count, const char* kind,
                  const std::string& user) const {
    if (graph == id_ && index < count) return;
    throw GraphError("graph '" + name_ + "', " + user + ": stale " + kind + " handle " + std::to_string(index) +
                     " (made by another graph, or never made)");
}

Image Graph::image(std::string name, const ImageDesc& desc) {
    images_.push_back({std::move(name), desc, std::nullopt, false, false});
    return {static_cast<std::uint32_t>(images_.size() - 1), id_};
}

Image Graph::importImage(std::string name, const ImageDesc& desc, const State& state, bool undefined) {
    images_.push_back({std::move(name), desc, state, undefined, false});
    return {static_cast<std::uint32_t>(images_.size() - 1), id_};
}

Buffer Graph::importBuffer(std::string name, VkDeviceSize size, const State& state) {
    buffers_.push_back({std::move(name), size, state, false});
    return {static_cast<std::uint32_t>(buffers_.size() - 1), id_};
}

void Graph::output(Image image) {
    check(image.graph, image.index, images_.size(), "image", "output");
    images_[image.index].output = true;
}

void Graph::output(Buffer buffer) {
    check(buffer.graph, buffer.index, buffers_.size(), "buffer", "output");
    buffers_[buffer.index].output = true;
}

PassBuilder Graph::pass(std::string name, PassKind kind) {
    passes_.push_back({std::move(name), kind, {}, {}, false});
    return PassBuilder(*this, static_cast<std::uint32_t>(passes_.size() - 1));
}

PassBuilder& PassBuilder::use(Verb verb, Image image, std::optional<Clear> clear) {
    PassDecl& pass = graph_.passes_[pass_];
    graph_.check(image.graph, image.index, graph_.images_.size(), "image", "pass '" + pass.name + "'");
    pass.uses.push_back({verb, true, image.index, clear});
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

PassBuilder& PassBuilder::record(Work work) {
    graph_.passes_[pass_].work = std::move(work);
    return *this;
}

}  // namespace nacre::graph
