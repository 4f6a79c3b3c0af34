// Passes over the primitives, and how their vertex outputs fit a device's limit per render pass.

#include <algorithm>

#include "engine/frame/chooser.h"
#include "engine/frame/frame.h"

namespace nacre {

using passes::chooseShapes;
using passes::computeCost;
using passes::countBytes;
using passes::Handed;
using passes::PassCost;
using passes::PrimitiveCounts;
using passes::SphereShapes;

/// A pass over the primitives: its rounds in VertexOutputs, and its vertex outputs.
struct GeometryWork {
    Rounds VertexOutputs::*rounds = nullptr;
    PassCost cost;
};

/// The passes of a path, in order. Does not allocate.
class GeometryWorks {
public:
    void add(const GeometryWork& work) { works_.at(count_++) = work; }
    const GeometryWork* begin() const { return works_.data(); }
    const GeometryWork* end() const { return works_.data() + count_; }

private:
    std::array<GeometryWork, 5> works_{};  // prepass, nearest, three targets
    std::size_t count_ = 0;
};

namespace {

/// Render passes beyond the first.
std::uint32_t begun(const Rounds& rounds) { return rounds.count - (rounds.apart ? 0 : 1); }

}  // namespace

/// Render passes that a path by triangles takes where compute draws the frame in its place; 0: it does not.
std::uint32_t Chooser::renderPassesBeyond() const {
    const bool asked = device_.visibility != Visibility::automatic || choice_.debug != DebugView::none || rims() ||
                       (choice_.attachmentSamples() > 1 && device_.multisampling == Multisampling::four);
    if (asked || device_.tested.tilesFail || request_.headset || choice_.path == Visibility::tiles) return 0;
    const std::uint32_t count = countRenderPasses(choice_, fitted(choice_.path));
    return count > 1 ? count : 0;
}

/// 0: no limit.
std::uint64_t Chooser::mostVertexBytes() const {
    const std::uint64_t asked = settings_.tuning.mostVertexBytes;
    return asked > 0 ? asked : device_.plan.geometry.mostVertexBytes;
}

/// Rounds of a pass that keep each one's vertex outputs within the limit.
Rounds Chooser::planRounds(const PassCost& cost, const PrimitiveCounts& counts) const {
    const std::uint64_t all = countBytes(cost, counts) * choice_.views, most = mostVertexBytes();
    Rounds rounds;
    if (all <= most) return rounds;
    rounds.bytes = countBytes(cost);
    // Shares are of whole primitives: each may have one more.
    const std::uint64_t one = std::uint64_t{*std::ranges::max_element(rounds.bytes)} * choice_.views;
    const std::uint64_t room = most > 2 * one ? most - one : one;
    rounds.count = static_cast<std::uint32_t>((all + room - 1) / room);
    return rounds;
}

/// The passes of a path over the primitives, in order.
GeometryWorks Chooser::planGeometry(Visibility path, const SphereShapes& shapes) const {
    const bool stores = device_.plan.geometry.storesVaryings, fetched = stores && !request_.counted;
    const auto cost = [&](Handed handed) { return computeCost(handed, stores, shapes); };
    GeometryWorks passes;
    if (path == Visibility::tiles) return passes;
    if (needsPrepass(path, shapes.plates)) passes.add({&VertexOutputs::plating, cost(Handed::plates)});
    const std::span<const ScreenTarget> targets = screenTargets(choice_);
    if (path == Visibility::deferred) passes.add({&VertexOutputs::nearest, cost(Handed::number)});
    if (path == Visibility::encoded || (path == Visibility::rasterOrder && !settlesWhileShading(targets)))
        passes.add({&VertexOutputs::nearest, cost(Handed::depth)});
    if (path == Visibility::deferred && !rims()) return passes;
    for (const ScreenTarget& target : targets) {
        const bool colour = target.output == passes::Output::color;
        const Handed handed = path == Visibility::deferred ? Handed::number
                              : colour && fetched          ? Handed::shadingFetched
                                                           : Handed::shading;
        passes.add({&VertexOutputs::shading, cost(handed)});
        if (path == Visibility::deferred) break;
    }
    return passes;
}

/// Shapes and rounds that keep vertex outputs of each render pass within the limit: first fewer corners, then no
/// plates, then more render passes.
VertexOutputs Chooser::fitted(Visibility path) const {
    const graph::GeometryCaps& caps = device_.plan.geometry;
    PrimitiveCounts counts = scene_;
    counts.flat = counts.flat || choice_.attachmentSamples() > 1;
    const FrameTuning& tuning = settings_.tuning;
    const std::uint64_t most = mostVertexBytes();
    if (most == 0) return {};
    const auto fit = [&](VertexOutputs outputs) {
        const bool usual = outputs == VertexOutputs();
        const SphereShapes shapes = chooseShapes(usual ? tuning.plates : outputs.plates,
                                                 usual ? tuning.impostor : outputs.impostor, caps, counts);
        std::uint64_t sum = 0;
        std::uint32_t renderPasses = 1;
        for (const auto& [rounds, cost] : planGeometry(path, shapes)) {
            Rounds made = planRounds(cost, counts);
            const std::uint64_t bytes = countBytes(cost, counts) * choice_.views / made.count;
            made.apart = sum > 0 && (made.count > 1 || sum + bytes > most);
            sum = made.apart || made.count > 1 ? bytes : sum + bytes;
            renderPasses += begun(made);
            // Passes of several targets share the rounds.
            Rounds& kept = outputs.*rounds;
            for (std::size_t kind = 0; kind < kept.bytes.size(); ++kind)
                kept.bytes[kind] = std::max(kept.bytes[kind], made.bytes[kind]);
            kept.count = std::max(kept.count, made.count);
            kept.apart = kept.apart || made.apart;
        }
        return std::pair(outputs, renderPasses);
    };
    auto [best, renderPasses] = fit({});
    const bool free = tuning.plates == PlateShape::automatic && tuning.impostor == ImpostorShape::automatic;
    for (const PlateShape plates : {PlateShape::square, PlateShape::none}) {
        if (!free || debugs() || renderPasses == 1) break;
        VertexOutputs fewer;
        fewer.plates = plates, fewer.impostor = ImpostorShape::square;
        const auto [outputs, begun] = fit(fewer);
        if (begun < renderPasses) best = outputs, renderPasses = begun;
    }
    return best;
}

void Chooser::chooseVertices() {
    choice_.vertices = fitted(choice_.path);
    if (choice_.vertices.plates == PlateShape::none) choice_.prepass = needsPrepass(choice_.path, PlateShape::none);
    Overflow& overflow = choice_.overflow;
    if (choice_.drawnByTiles()) {
        overflow.vertices = fitted(overflow.path);
        if (overflow.vertices.plates == PlateShape::none)
            overflow.prepass = needsPrepass(overflow.path, PlateShape::none);
    }
    if (mostVertexBytes() == 0) return;
    const graph::GeometryCaps& caps = device_.plan.geometry;
    const FrameTuning& tuning = settings_.tuning;
    const SphereShapes ofLight = chooseShapes(PlateShape::none, tuning.impostor, caps, scene_.light);
    const PassCost ofLayers =
        computeCost(Handed::number, false, chooseShapes(PlateShape::none, tuning.impostor, caps, scene_.layers));
    for (VertexOutputs* outputs : {&choice_.vertices, &overflow.vertices}) {
        outputs->light = planRounds(computeCost(Handed::depth, caps.storesVaryings, ofLight), scene_.light);
        outputs->layers = planRounds(ofLayers, scene_.layers);
    }
    if (!reasons_ || choice_.vertices == VertexOutputs()) return;
    PrimitiveCounts counts = scene_;
    counts.flat = counts.flat || choice_.attachmentSamples() > 1;
    std::uint64_t all = 0;
    for (const GeometryWork& pass :
         planGeometry(choice_.path, chooseShapes(tuning.plates, tuning.impostor, caps, counts)))
        all += countBytes(pass.cost, counts) * choice_.views;
    constexpr std::uint64_t kMega = 1'000'000;
    const auto text = [&](std::uint64_t bytes) {
        return bytes < kMega ? std::to_string(bytes) + " B" : std::to_string((bytes + kMega / 2) / kMega) + " MB";
    };
    because("vertex outputs",
            "they would be " + text(all) + ", and a render pass gets at most " + text(mostVertexBytes()));
    if (choice_.vertices.plates == PlateShape::none)
        for (Decision& decision : *reasons_)
            if (decision.what == "prepass") decision.why = "plates would take vertex outputs beyond the limit";
}

std::vector<graph::Share> Rounds::shares() const {
    std::vector<graph::Share> shares;
    for (std::uint32_t i = 0; i < count; ++i) shares.push_back({i, count, bytes, apart || i > 0});
    return shares;
}

std::uint32_t countRenderPasses(const FrameChoice& choice, const VertexOutputs& v) {
    const auto targets =
        static_cast<std::uint32_t>(choice.path == Visibility::deferred ? 1 : screenTargets(choice).size());
    return 1 + begun(v.plating) + begun(v.nearest) + targets * begun(v.shading);
}

}  // namespace nacre
