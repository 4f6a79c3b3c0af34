#include "engine/graph/plan_internal.h"

namespace nacre::graph {
namespace {

bool fits(Verb verb, PassKind kind) {
    switch (kind) {
        case PassKind::graphics:
            return verb != Verb::copiesFrom && verb != Verb::copiesTo && verb != Verb::stores;
        case PassKind::compute:
            return verb == Verb::samples || verb == Verb::stores || verb == Verb::reads || verb == Verb::writes;
        case PassKind::transfer:
            return verb == Verb::copiesFrom || verb == Verb::copiesTo;
    }
    return false;
}

/// @param written  images that have contents before the pass; adds those that it writes
void checkReads(const Graph& graph, std::size_t p, std::vector<bool>& written) {
    const PassDecl& pass = graph.passes()[p];
    const auto writtenLater = [&](const Use& read) {
        for (std::size_t later = p; later < graph.passes().size(); ++later)
            for (const Use& use : graph.passes()[later].uses)
                if (use.isImage && use.resource == read.resource && isWrite(use.verb))
                    return graph.passes()[later].name;
        return std::string();
    };
    for (const Use& use : pass.uses) {
        if (!use.isImage || isWrite(use.verb) || written[use.resource]) continue;
        const std::string writer = writtenLater(use);
        const std::string what = naming(graph, pass, use) + ": " + verbName(use.verb);
        throw GraphError(what + (writer.empty() ? " of contents that no pass writes"
                                                : " before pass '" + writer + "', which writes it, is declared"));
    }
    for (const Use& use : pass.uses)
        if (use.isImage && isWrite(use.verb)) written[use.resource] = true;
}

/// "100x50", plus every count above one.
std::string shapeText(const ImageDesc& desc) {
    std::string text = std::to_string(desc.extent.width) + "x" + std::to_string(desc.extent.height);
    if (desc.samples != 1) text += ", " + std::to_string(desc.samples) + " samples";
    if (desc.layers != 1) text += ", " + std::to_string(desc.layers) + " layers";
    return text;
}

/// Images are kept by their names from one execution to the next.
void checkImages(const Graph& graph) {
    for (std::size_t i = 0; i < graph.images().size(); ++i) {
        const ImageDecl& image = graph.images()[i];
        const std::string what = "graph '" + graph.name() + "', image '" + image.name + "': ";
        if (image.desc.extent.width == 0 || image.desc.extent.height == 0 || image.desc.samples == 0 ||
            image.desc.layers == 0)
            throw GraphError(what + "no pixels (" + shapeText(image.desc) + ")");
        bytesPerTexel(image.desc.format);
        for (std::size_t j = 0; j < i; ++j)
            if (graph.images()[j].name == image.name) throw GraphError(what + "two images of this name");
    }
}

/// @param color  the pass's first, null if none was declared before
void checkResolve(const Graph& graph, const PassDecl& pass, const Use& use, const ImageDesc* color) {
    const ImageDesc& desc = graph.images()[use.resource].desc;
    if (!color || color->samples == 1)
        throw GraphError(naming(graph, pass, use) + ": nothing of several samples stands before it");
    ImageDesc wanted = *color;
    wanted.samples = 1;
    if (desc != wanted)
        throw GraphError(naming(graph, pass, use) + ": " + formatName(desc.format) + " of " + shapeText(desc) +
                         " cannot take the mean of " + formatName(color->format) + " of " + shapeText(*color));
}

void checkAttachments(const Graph& graph, const PassDecl& pass, const PlanCaps& caps) {
    const ImageDesc *first = nullptr, *color = nullptr;
    std::uint32_t bytes = 0, colors = 0, inputs = 0;
    for (const Use& use : pass.uses) {
        if (!use.isImage || !isAttachment(use.verb)) continue;
        const ImageDesc& desc = graph.images()[use.resource].desc;
        if (use.verb == Verb::resolve) {
            checkResolve(graph, pass, use, color);
            continue;
        }
        if (!first) first = &desc;
        if (desc.extent != first->extent || desc.samples != first->samples || desc.layers != first->layers)
            throw GraphError(naming(graph, pass, use) + ": " + verbName(use.verb) + " attachment of " +
                             shapeText(desc) + " beside one of " + shapeText(*first));
        const bool depthVerb = use.verb == Verb::depth || use.verb == Verb::depthTest;
        if (depthVerb != isDepthFormat(desc.format))
            throw GraphError(naming(graph, pass, use) + ": " + formatName(desc.format) + " cannot be a " +
                             verbName(use.verb) + " attachment");
        if (use.verb == Verb::ordered && caps.rasterOrder == RasterOrder::none)
            throw GraphError(naming(graph, pass, use) + ": '" + caps.name +
                             "' cannot read an attachment in raster order");
        if (use.verb == Verb::color || use.verb == Verb::ordered) {
            if (!color) color = &desc;
            ++colors;
            bytes += bytesPerTexel(desc.format) * desc.samples;
        }
        if (use.verb == Verb::input || use.verb == Verb::ordered) ++inputs;
    }
    if (first && first->layers > caps.maxViews)
        throw GraphError("pass '" + pass.name + "': '" + caps.name + "' does not draw " +
                         std::to_string(first->layers) + " views at once");
    if (pass.kind == PassKind::graphics && !first)
        throw GraphError("pass '" + pass.name + "': a graphics pass needs an attachment");
    if (colors > caps.maxColorAttachments || inputs > caps.maxInputAttachments)
        throw GraphError("pass '" + pass.name + "': " + std::to_string(colors) + " colour and " +
                         std::to_string(inputs) + " input attachments exceed '" + caps.name + "' (" +
                         std::to_string(caps.maxColorAttachments) + " and " + std::to_string(caps.maxInputAttachments) +
                         ")");
    // Without a tile, one pass may have more; it shares no render pass then.
    if (bytes > caps.tileBytesPerPixel && caps.transient)
        throw GraphError("pass '" + pass.name + "': " + std::to_string(bytes) +
                         " bytes of colour per pixel exceed the tile budget of '" + caps.name + "' (" +
                         std::to_string(caps.tileBytesPerPixel) + ")");
}

/// The host reads a map while the pass is recorded, before anything that the graph does.
void checkMap(const Graph& graph, const PassDecl& pass, const PlanCaps& caps) {
    std::uint32_t views = 1;
    for (const Use& use : pass.uses)
        if (use.isImage && isAttachment(use.verb)) views = graph.images()[use.resource].desc.layers;
    for (const Use& use : pass.uses) {
        if (use.verb != Verb::density) continue;
        const ImageDecl& map = graph.images()[use.resource];
        if (caps.densityTexel == 0)
            throw GraphError(naming(graph, pass, use) + ": '" + caps.name + "' takes no density maps");
        if (!map.imported || map.undefined)
            throw GraphError(naming(graph, pass, use) + ": a density map is imported, with contents");
        const auto texels = [&](std::uint32_t pixels) { return (pixels + caps.densityTexel - 1) / caps.densityTexel; };
        for (const Use& drawn : pass.uses) {
            if (!drawn.isImage || !isAttachment(drawn.verb)) continue;
            const Extent extent = graph.images()[drawn.resource].desc.extent;
            if (map.desc.extent != Extent{texels(extent.width), texels(extent.height)} ||
                (map.desc.layers != 1 && map.desc.layers != views))
                throw GraphError(naming(graph, pass, use) + ": a map of " + shapeText(map.desc) + " for " +
                                 shapeText(graph.images()[drawn.resource].desc));
        }
    }
}

void checkUses(const Graph& graph, const PassDecl& pass) {
    for (std::size_t i = 0; i < pass.uses.size(); ++i) {
        const Use& use = pass.uses[i];
        if (!fits(use.verb, pass.kind) || (!use.isImage && isAttachment(use.verb)))
            throw GraphError(naming(graph, pass, use) + ": '" + verbName(use.verb) +
                             "' does not go with this kind of pass");
        for (std::size_t j = 0; j < i; ++j)
            if (pass.uses[j].isImage == use.isImage && pass.uses[j].resource == use.resource)
                throw GraphError(naming(graph, pass, use) + ": used twice by one pass");
    }
}

}  // namespace

void validate(const Graph& graph, const PlanCaps& caps) {
    checkImages(graph);
    std::vector<bool> written;
    for (const ImageDecl& image : graph.images()) written.push_back(image.imported && !image.undefined);
    for (std::size_t p = 0; p < graph.passes().size(); ++p) {
        const PassDecl& pass = graph.passes()[p];
        try {
            checkUses(graph, pass);
            checkAttachments(graph, pass, caps);
            checkMap(graph, pass, caps);
            checkReads(graph, p, written);
        } catch (const GraphError& error) {
            throw GraphError(error.what() + pass.line.text());
        }
    }
}

}  // namespace nacre::graph
