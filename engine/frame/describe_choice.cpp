// The decisions of a choice in words, for `nacre plan`, --stats and `nacre devices`.

#include <algorithm>

#include "engine/frame/choose.h"

namespace nacre {
namespace {

/// A name by its place in a list.
template <typename Enum, std::size_t n>
std::string nameIn(const char* const (&names)[n], Enum value) {
    return names[static_cast<std::size_t>(value)];
}

std::string samplesText(const FrameChoice& choice) {
    const std::string count = std::to_string(choice.samples.count);
    switch (choice.refinement) {
        case Refinement::none:
            return count + (choice.drawsEdges() ? " at edges" : " per pixel");
        case Refinement::edges:
            return "1 per pixel, then 16 at edges";
        case Refinement::blocks:
            return "1 per pixel, then 16 in blocks where colours change";
        case Refinement::everywhere:
            break;
    }
    return "16 per pixel, in blocks";
}

/// "3 render passes without plates, shadow map in 2"
std::string verticesText(const FrameChoice& choice) {
    const VertexOutputs& v = choice.vertices;
    const std::uint32_t count = countRenderPasses(choice, v);
    std::string text = std::to_string(count) + (count == 1 ? " render pass" : " render passes");
    if (v.plates == PlateShape::none)
        text += " without plates";
    else if (v.impostor == ImpostorShape::square)
        text += " of squares";
    if (v.light.count > 1) text += ", shadow map in " + std::to_string(v.light.count);
    if (v.layers.count > 1) text += ", each translucent layer in " + std::to_string(v.layers.count);
    return text;
}

std::string effectsText(const EffectList& effects) {
    std::string text;
    for (const Effect& e : effects) {
        text += (text.empty() ? "" : ", ") + nameIn(kEffectNames, e.kind);
        if (e.size > 0) text += " " + std::to_string(e.size);
    }
    return text.empty() ? "none" : text;
}

}  // namespace

std::vector<Decision> describe(const FrameChoice& choice) {
    constexpr const char* kShading[] = {"fragments", "fragments, by an image of numbers", "compute",
                                        "fragments of the picture"};
    constexpr const char* kGeometry[] = {"instanced", "fetched by fragments", "lists of the host",
                                         "lists of the device"};
    constexpr const char* kHost[] = {"nothing", "hidden spheres", "front spheres"};
    constexpr const char* kEndings[] = {"left on the device",
                                        "read back",
                                        "picture",
                                        "picture, read back",
                                        "lens, read back",
                                        "window",
                                        "copied to the window",
                                        "scaled to the window",
                                        "first sample of a window",
                                        "sample of a window",
                                        "sum of samples"};
    std::vector<Decision> decisions{{"path", visibilityName(choice.path), {}},
                                    {"shading", nameIn(kShading, choice.shading), {}},
                                    {"samples", samplesText(choice), {}},
                                    {"effects", effectsText(choice.effects), {}},
                                    {"geometry", nameIn(kGeometry, choice.geometry), {}},
                                    {"host", nameIn(kHost, choice.host), {}},
                                    {"prepass", choice.prepass && !choice.drawnByTiles() ? "on" : "off", {}},
                                    {"ending", nameIn(kEndings, choice.ending), {}}};
    if (choice.overflow.longestList > 0)
        decisions.push_back({"long lists", choice.drawsEdges() ? "blocks" : visibilityName(choice.overflow.path), {}});
    if (choice.vertices != VertexOutputs()) decisions.push_back({"vertex outputs", verticesText(choice), {}});
    if (choice.foveated) decisions.push_back({"foveation", "by a fragment density map", {}});
    if (choice.views > 1) decisions.push_back({"views", "both eyes in one frame", {}});
    return decisions;
}

std::vector<Decision> explain(const FrameRequest& request, const SceneFacts& scene, const graph::FrameCaps& device) {
    std::vector<Decision> reasons;
    const FrameChoice choice = choose(request, scene, device, &reasons);
    std::vector<Decision> decisions = describe(choice);
    if (request.headset && !choice.foveated) decisions.push_back({"foveation", "a fragment per pixel", {}});
    if (request.eyes && choice.views == 1) decisions.push_back({"views", "a frame for each eye", {}});
    for (Decision& decision : decisions) {
        const auto found = std::ranges::find(reasons, decision.what, &Decision::what);
        if (found != reasons.end()) decision.why = found->why;
    }
    return decisions;
}

std::vector<Decision> explain(const FrameRequest& request, const SceneFacts& scene, const graph::FrameCaps& device,
                              const FrameChoice& drawn) {
    std::vector<Decision> decisions = describe(drawn);
    const std::vector<Decision> chosen = explain(request, scene, device);
    for (Decision& decision : decisions) {
        const auto same = std::ranges::find(chosen, decision.what, &Decision::what);
        const bool kept = same != chosen.end() && same->how == decision.how;
        decision.why = kept ? same->why : "a tile's list is too long";
    }
    if (request.eyes && drawn.views == 1) decisions.push_back(chosen.back());  // why each eye has a frame
    return decisions;
}

}  // namespace nacre
