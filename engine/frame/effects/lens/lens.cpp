#include "engine/frame/effects/lens/lens.h"

#include <algorithm>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <limits>
#include <optional>

#include "engine/frame/resolve.h"
#include "engine/frame/scene.h"
#include "engine/passes/read_back.h"

namespace nacre {

using passes::LensStep;

namespace {

constexpr double kLargestShare = 1.0 / 16;  // of the picture's shorter side
constexpr double kLargestPixels = 128;

bool isPerspective(const View& view) { return view.projection == Projection::perspective; }

/// Z of the view's centre.
double centerDepth(const View& view) { return isPerspective(view) ? view.eyeDistance : view.radius; }

/// Z of the focus, in front of the eye.
double focusDepth(const RenderSettings& settings, const View& view) {
    constexpr double kNearest = 0.01;  // Å
    const double focus = centerDepth(view) + settings.effects.depthOfField.focus.value_or(0);
    return isPerspective(view) ? std::max(focus, kNearest) : focus;
}

/// Radius of a point's circle, pixels, as shaders/lens.frag has it.
float radiusAt(const passes::Lens& lens, float Z) {
    return std::abs(lens.pixels * (Z - lens.focus) * (lens.perspective > 0 ? 1 / Z : 1));
}

}  // namespace

double largestCircle(const RenderSettings& settings) {
    if (!hasLens(settings)) return 0;
    return std::clamp(kLargestShare * std::min(settings.view.width, settings.view.height), 1.0, kLargestPixels);
}

passes::Lens makeLens(const RenderSettings& settings, const View& view) {
    passes::Lens lens;
    lens.focus = static_cast<float>(focusDepth(settings, view));
    const double radius = 0.5 * settings.effects.depthOfField.strength * view.pixelsPerAngstrom;
    lens.pixels = static_cast<float>(radius * (isPerspective(view) ? view.eyeDistance : 1));
    lens.most = static_cast<float>(largestCircle(settings));
    lens.perspective = isPerspective(view) ? 1.0f : 0.0f;
    lens.rim = static_cast<float>(settings.effects.contours.width);
    lens.rimDepth = static_cast<float>(settings.effects.contours.depth);
    return lens;
}

namespace {

/// Replaces each value by the minimum of itself and its neighbours. @param step  from one to the next
void takeLeast(float* values, std::size_t count, std::size_t step) {
    for (std::size_t i = step; i < count; ++i) values[i - step] = std::min(values[i - step], values[i]);
    for (std::size_t i = count; i-- > step;) values[i] = std::min(values[i], values[i - step]);
}

}  // namespace

std::vector<std::uint8_t> sharpPlaces(const float* distances, graph::Extent extent, const passes::Lens& lens,
                                      double rim) {
    constexpr float kBlurred = 1.5f;  // pixels of radius: more samples there gain nothing
    constexpr float kNothing = std::numeric_limits<float>::infinity();
    std::vector<float> radii(std::size_t{extent.width} * extent.height);
    for (float& radius : radii) {
        const float Z = *distances++;
        radius = Z < kNoDistance ? radiusAt(lens, Z) : kNothing;
    }
    // Takes the smallest circle of the pixels around: sharp shapes keep samples at their edges and outlines.
    for (auto left = static_cast<std::size_t>(1 + std::ceil(rim)); left > 0; --left) {
        for (std::size_t y = 0; y < extent.height; ++y) takeLeast(radii.data() + y * extent.width, extent.width, 1);
        takeLeast(radii.data(), radii.size(), extent.width);
    }
    std::vector<std::uint8_t> sharp(radii.size());
    std::ranges::transform(radii, sharp.begin(), [](float radius) -> std::uint8_t {
        return radius < kBlurred || radius == kNothing ? 0xff : 0;
    });
    return sharp;
}

View throughLens(const RenderSettings& settings, View view, glm::dvec2 point) {
    // The scene turns about its centre, and the image plane shifts so that the focus stays in place.
    const double focus = focusDepth(settings, view), center = centerDepth(view);
    const double scale = isPerspective(view) ? focus / center : 1;
    const glm::dvec2 turn = 0.5 * settings.effects.depthOfField.strength * scale * point;
    const double z = center - focus;  // of the focal plane
    const glm::dvec3 back = glm::normalize(glm::dvec3(-turn, 1.0));
    const glm::dvec3 right = glm::normalize(glm::dvec3(1, 0, 0) - back.x * back);
    const glm::dmat3 rows(right, glm::cross(back, right), back);
    view.rotation = glm::transpose(rows) * view.rotation;
    view.shift = glm::transpose(rows) * view.shift;
    view.pan -= turn * z * (isPerspective(view) ? center / focus : 1);
    return view;
}

namespace {

/// The lens, with circles no larger than those of the shown tiles.
passes::Lens makeLens(const PictureImage& picture) {
    constexpr float kRounding = 0.01f;
    passes::Lens lens = picture.lens;
    if (!picture.tiles) return lens;
    const float largest = std::max(radiusAt(lens, picture.tiles->nearest()), radiusAt(lens, picture.tiles->farthest()));
    lens.most = std::min(lens.most, largest + kRounding);  // larger or NaN: unchanged
    return lens;
}

}  // namespace

std::vector<PictureRect> blurredBy(const passes::Lens& lens, std::span<const TileBins::Span> spans,
                                   graph::Extent extent) {
    constexpr std::uint32_t kBin = TileBins::kPixels, kBand = 2 * kBin;
    const auto room = static_cast<std::uint32_t>(1.25f * lens.most + lens.rim + 4);  // samples may stand for neighbours
    std::vector<PictureRect> bands;
    for (std::uint32_t top = 0; top < extent.height; top += kBand) {
        const std::uint32_t bottom = std::min(top + kBand, extent.height);
        std::uint32_t left = extent.width, right = 0;
        for (const TileBins::Span& s : spans) {
            if (s.y * kBin >= bottom + room || (s.y + 1) * kBin + room <= top) continue;
            left = std::min(left, s.x * kBin), right = std::max(right, s.endX * kBin);
        }
        if (right == 0) continue;
        left -= std::min(left, room);
        bands.push_back({left, top, std::min(right + room, extent.width) - left, bottom - top});
    }
    return bands;
}

void declareLens(Frame& f, graph::Extent extent, VkFormat format, const PictureImage* from) {
    graph::Graph& g = f.graph;
    graph::Image picture = g.importImage("picture", {format, extent}, passes::kTextureState);
    f.picture = picture;
    const bool coded = format == VK_FORMAT_R8G8B8A8_UNORM;
    const auto draw = [&](const char* name, LensStep step, graph::Image to, std::vector<graph::Image> images) {
        graph::PassBuilder drawn = g.graphics(name);
        for (const graph::Image image : images) drawn.samples(image);
        std::optional<graph::Clear> clear;
        if (step == LensStep::soft) clear = graph::Clear{1, 1, 1, 0};               // of pixels that are not soft
        if (step == LensStep::circles) clear = graph::Clear{0, kNoDistance, 0, 0};  // for empty pixels, as bits
        drawn.color(to, clear);
        if (!from) return to;
        drawn.record({[=](gpu::PassContext& c) {
                          std::vector<vk::ImageView> views;
                          for (const graph::Image image : images) views.push_back(c.view(image));
                          const passes::Lens lens = makeLens(*from);
                          std::vector<PictureRect> parts{{0, 0, c.extent.width, c.extent.height}};
                          if (from->tiles && step != LensStep::reach && step != LensStep::spread)
                              parts = blurredBy(lens, from->tiles->spans(), extent);
                          passes::drawLens(c, {step, coded}, lens, views, parts);
                      },
                      [=](gpu::PipelineContext& c) {
                          passes::wantLens(c, {step, coded});
                      }});
        return to;
    };
    const auto pass = [&](const char* name, LensStep step, graph::Extent size, std::vector<graph::Image> images) {
        return draw(name, step, g.image(name, {VK_FORMAT_R32G32_UINT, size}), std::move(images));
    };
    const auto inBlocks = [](std::uint32_t pixels) { return (pixels + passes::kLensBlock - 1) / passes::kLensBlock; };
    const graph::Extent blocks{inBlocks(extent.width), inBlocks(extent.height)};
    const graph::Image circles = pass("circles", LensStep::circles, extent, {picture, f.targets[0]});
    const graph::Image largest = pass("largest circles", LensStep::reach, blocks, {circles});
    const graph::Image reach = pass("reach of circles", LensStep::spread, blocks, {largest});
    const VkFormat roots = graph::bytesPerTexel(format) == 4 ? VK_FORMAT_R8G8B8A8_UNORM : VK_FORMAT_R16G16B16A16_SFLOAT;
    const graph::Image soft =
        draw("large circles", LensStep::soft, g.image("large circles", {roots, extent}), {circles, reach});
    f.targets[0] = draw("depth of field", LensStep::gather, picture, {circles, reach, soft});  // over blurred pixels
}

}  // namespace nacre
