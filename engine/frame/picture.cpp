#include "engine/frame/picture.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "engine/srgb.h"

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
            const std::size_t first =
                std::size_t{part.rect.y + y} * n * part.rowPixels + std::size_t{part.rect.x + x} * n;
            std::array<float, 4> sum{};
            for (std::uint32_t j = 0; j < n; ++j)
                for (std::uint32_t i = 0; i < n; ++i)
                    covered += add(first + std::size_t{j} * part.rowPixels + i, sum) ? 1 : 0;
            float* pixel = to.rgba.data() + 4 * (std::size_t{y} * to.width + x);
            for (std::size_t c = 0; c < 4; ++c) pixel[c] = sum[c] / samples;
        }
    return covered;
}

/// Values of the bytes 0 to 255.
struct ByteValues {
    std::array<float, 256> linear{}, share{};
    ByteValues() {
        for (std::size_t i = 0; i < 256; ++i) {
            share[i] = static_cast<float>(i) / 255.0f;
            linear[i] = linearFromSrgb(share[i]);
        }
    }
    /// Adds a pixel that is not empty.
    void add(std::uint32_t pixel, std::array<float, 4>& sum) const {
        for (std::size_t c = 0; c < 3; ++c) sum[c] += linear[pixel >> (8 * c) & 0xff];
        sum[3] += share[pixel >> 24];
    }
};

const ByteValues& byteValues() {
    static const ByteValues values;
    return values;
}

void putOver(float* pixel, const std::array<float, 4>& behind) {
    const float alpha = pixel[3];
    for (std::size_t c = 0; c < 4; ++c) pixel[c] += (1 - alpha) * behind[c];
}

}  // namespace

std::uint64_t resolvePixels(const std::uint32_t* pixels, const ResolvedPart& part, Picture& to) {
    const ByteValues& values = byteValues();
    return resolve(part, to, [&](std::size_t at, std::array<float, 4>& sum) {
        if (pixels[at] >> 24 == 0) return false;
        values.add(pixels[at], sum);
        return true;
    });
}

namespace {

/// @param code  returns the code of a translucent pixel @returns the number of covered pixels
template <std::size_t kChannels, typename Code>
std::uint64_t codeRows(const std::uint32_t* pixels, const ResolvedPart& part, const Code& code, std::uint8_t* to) {
    constexpr std::uint32_t kShare = 24, kSolid = 0xff;
    const std::array<std::uint8_t, 4> empty = code(0);
    std::uint64_t covered = 0;
    for (std::uint32_t y = 0; y < part.rect.height; ++y) {
        const std::uint32_t* from = pixels + std::size_t{part.rect.y + y} * part.rowPixels + part.rect.x;
        for (const std::uint32_t* const end = from + part.rect.width; from < end; ++from, to += kChannels) {
            const std::uint32_t share = *from >> kShare;
            covered += share != 0 ? 1 : 0;
            if (share == kSolid)  // every code survives the way to linear light and back
                std::memcpy(to, from, kChannels);
            else if (share == 0)
                std::memcpy(to, empty.data(), kChannels);
            else
                std::memcpy(to, code(*from).data(), kChannels);
        }
    }
    return covered;
}

}  // namespace

CodedPicture codePixels(const std::uint32_t* pixels, const ResolvedPart& part, const std::array<float, 4>& background,
                        bool alpha, std::uint64_t& covered) {
    const ByteValues& values = byteValues();
    const std::array<float, 4> behind = premultiplied(background);
    const auto code = [&](std::uint32_t pixel) {
        std::array<float, 4> sum{};
        if (pixel >> 24 != 0) values.add(pixel, sum);
        putOver(sum.data(), behind);
        std::array<std::uint8_t, 4> bytes{};
        codePixel(sum.data(), alpha, bytes.data());
        return bytes;
    };
    CodedPicture picture{part.rect.width, part.rect.height, alpha, {}};
    picture.bytes.resize(picture.channels() * part.rect.width * part.rect.height);
    covered = alpha ? codeRows<4>(pixels, part, code, picture.bytes.data())
                    : codeRows<3>(pixels, part, code, picture.bytes.data());
    return picture;
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
        covered += picture.rgba[i + 3] > 0 ? 1 : 0;
        putOver(picture.rgba.data() + i, behind);
    }
    return covered;
}

Picture emptyPicture(std::uint32_t width, std::uint32_t height) {
    return {width, height, std::vector<float>(std::size_t{4} * width * height)};
}

std::uint32_t nearestAtom(const std::uint32_t* identity, std::uint32_t side, double reach) {
    std::uint32_t atom = 0;
    double nearest = reach * reach + 0.5;
    for (std::uint32_t j = 0; j < side; ++j)
        for (std::uint32_t i = 0; i < side; ++i) {
            const double right = i - (side - 1) / 2.0, down = j - (side - 1) / 2.0;
            const double distance = right * right + down * down;
            const std::uint32_t here = identity[2 * (std::size_t{j} * side + i)];
            if (here == 0 || distance >= nearest) continue;
            nearest = distance;
            atom = here;
        }
    return atom;
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
        const bool hit = identity[2 * i] != 0 ||
                         std::any_of(surface + 4 * i + 1, surface + 4 * i + 4, [](float n) { return n != 0; });
        covered += hit ? 1 : 0;
        const float through = 1.0f - color[4 * i + 3];
        for (std::size_t c = 0; c < 4; ++c) l.rgba[4 * i + c] = color[4 * i + c] + through * behind[c];
        for (std::size_t c = 0; c < 3; ++c) l.normal[3 * i + c] = hit ? surface[4 * i + 1 + c] : 0.0f;
        l.z[i] = hit ? surface[4 * i] : std::numeric_limits<float>::infinity();
        l.id[i] = identity[2 * i];
        l.occlusion[i] = hit ? std::bit_cast<float>(identity[2 * i + 1]) : 1.0f;
    }
    return l;
}

}  // namespace nacre
