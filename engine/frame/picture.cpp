#include "engine/frame/picture.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace nacre {
namespace {

/// Premultiplied linear colour of a background.
std::array<float, 4> premultiplied(const std::array<float, 4>& background) {
    const float a = background[3];
    return {linearFromSrgb(background[0]) * a, linearFromSrgb(background[1]) * a, linearFromSrgb(background[2]) * a, a};
}

}  // namespace

float linearFromSrgb(float c) { return c <= 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f); }

namespace {

/// @param add  adds a pixel to four sums, and returns whether it is covered
template <typename Add>
std::uint64_t resolve(const ResolvedPart& part, Picture& to, const Add& add) {
    const std::uint32_t n = part.n;
    const auto samples = static_cast<float>(n * n);
    std::uint64_t covered = 0;
    for (std::uint32_t y = 0; y < part.rect.height; ++y)
        for (std::uint32_t x = 0; x < part.rect.width; ++x) {
            if (part.only && !part.only->finer(part.x + x, part.y + y)) continue;
            const std::size_t first =
                std::size_t{part.rect.y + y} * n * part.rowPixels + std::size_t{part.rect.x + x} * n;
            std::array<float, 4> sum{};
            for (std::uint32_t j = 0; j < n; ++j)
                for (std::uint32_t i = 0; i < n; ++i)
                    covered += add(first + std::size_t{j} * part.rowPixels + i, sum) ? 1 : 0;
            float* pixel = to.rgba.data() + 4 * (std::size_t{part.y + y} * to.width + part.x + x);
            for (std::size_t c = 0; c < 4; ++c) pixel[c] = sum[c] / samples;
        }
    return covered;
}

}  // namespace

std::uint64_t resolvePixels(const std::uint32_t* pixels, const ResolvedPart& part, Picture& to) {
    std::array<float, 256> linear{}, share{};
    for (std::size_t i = 0; i < 256; ++i) {
        share[i] = static_cast<float>(i) / 255.0f;
        linear[i] = linearFromSrgb(share[i]);
    }
    return resolve(part, to, [&](std::size_t at, std::array<float, 4>& sum) {
        const std::uint32_t p = pixels[at];
        if (p >> 24 == 0) return false;
        for (std::size_t c = 0; c < 3; ++c) sum[c] += linear[p >> (8 * c) & 0xff];
        sum[3] += share[p >> 24];
        return true;
    });
}

std::uint64_t resolvePixels(const float* pixels, const ResolvedPart& part, Picture& to) {
    return resolve(part, to, [&](std::size_t at, std::array<float, 4>& sum) {
        const float* p = pixels + 4 * at;
        if (!(p[3] > 0)) return false;
        for (std::size_t c = 0; c < 3; ++c) sum[c] += std::min(p[c], p[3]);  // highlights end at white, as in 8 bits
        sum[3] += p[3];
        return true;
    });
}

std::uint64_t putOver(Picture& picture, const std::array<float, 4>& background) {
    const std::array<float, 4> behind = premultiplied(background);
    std::uint64_t covered = 0;
    for (std::size_t i = 0; i < picture.rgba.size(); i += 4) {
        float* pixel = picture.rgba.data() + i;
        const float alpha = pixel[3];
        covered += alpha > 0 ? 1 : 0;
        for (std::size_t c = 0; c < 4; ++c) pixel[c] += (1 - alpha) * behind[c];
    }
    return covered;
}

LayerPicture assembleLayers(std::uint32_t width, std::uint32_t height, const float* color, const float* surface,
                            const std::uint32_t* identity, const std::array<float, 4>& background,
                            std::uint64_t& covered) {
    const std::array<float, 4> behind = premultiplied(background);
    const std::size_t count = std::size_t{width} * height;
    LayerPicture l;
    l.width = width;
    l.height = height;
    l.rgba.resize(count * 4);
    l.z.resize(count);
    l.normal.resize(count * 3);
    l.occlusion.resize(count);
    l.id.resize(count);
    covered = 0;
    for (std::size_t i = 0; i < count; ++i) {
        // A density map has a normal, and no atom.
        const bool hit =
            identity[2 * i] != 0 || std::any_of(surface + 4 * i, surface + 4 * i + 3, [](float n) { return n != 0; });
        covered += hit ? 1 : 0;
        const float through = 1.0f - color[4 * i + 3];
        for (std::size_t c = 0; c < 4; ++c) l.rgba[4 * i + c] = color[4 * i + c] + through * behind[c];
        for (std::size_t c = 0; c < 3; ++c) l.normal[3 * i + c] = hit ? surface[4 * i + c] : 0.0f;
        l.z[i] = hit ? surface[4 * i + 3] : std::numeric_limits<float>::infinity();
        l.id[i] = identity[2 * i];
        l.occlusion[i] = hit ? std::bit_cast<float>(identity[2 * i + 1]) : 1.0f;
    }
    return l;
}

}  // namespace nacre
