#include "engine/scene/palettes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <span>

namespace nacre {
namespace {

constexpr std::uint32_t kSunset[] = {0x364b9a, 0x4a7bb7, 0x6ea6cd, 0x98cae1, 0xc2e4ef, 0xeaeccc,
                                     0xfeda8b, 0xfdb366, 0xf67e4b, 0xdd3d2d, 0xa50026};
constexpr std::uint32_t kViridis[] = {0x440154, 0x472d7b, 0x3b528b, 0x2c728e, 0x21918c,
                                      0x28ae80, 0x5ec962, 0xaddc30, 0xfde725};
constexpr std::uint32_t kRainbow[] = {0x4e79c5, 0x4d8ac6, 0x4e96bc, 0x549eb3, 0x59a5a9, 0x60ab9e, 0x69b190,
                                      0x77b77d, 0x8cbc68, 0xa6be54, 0xbebc48, 0xd1b541, 0xddaa3c, 0xe49c39,
                                      0xe78c35, 0xe67932, 0xe4632d, 0xdf4828, 0xda2222};
constexpr std::uint32_t kLipophilicity[] = {0x008b8b, 0xffffff, 0xb8860b};

constexpr std::uint32_t kKinds[] = {0x56b4e9, 0xe69f00, 0x1fae83, 0xf0e442, 0x2b86c5, 0xe0733a, 0xd487b2};

std::span<const std::uint32_t> stopsOf(Palette palette) {
    switch (palette) {
        case Palette::viridis:
            return kViridis;
        case Palette::rainbow:
            return kRainbow;
        case Palette::lipophilicity:
            return kLipophilicity;
        case Palette::sunset:
            break;
    }
    return kSunset;
}

}  // namespace

std::string colorText(std::uint32_t color) {
    constexpr char kDigits[] = "0123456789abcdef";
    std::string text = "#";
    for (const int shift : {0, 8, 16}) {
        text += kDigits[color >> (shift + 4) & 15];
        text += kDigits[color >> shift & 15];
    }
    return text;
}

std::uint32_t paletteColor(Palette palette, double at) {
    const std::span<const std::uint32_t> stops = stopsOf(palette);
    const double place = (at > 0 ? std::min(at, 1.0) : 0.0) * static_cast<double>(stops.size() - 1);
    const auto left = std::min(static_cast<std::size_t>(place), stops.size() - 2);
    const double share = place - static_cast<double>(left);
    std::uint32_t rgb = 0;
    for (const int shift : {16, 8, 0}) {
        const double low = stops[left] >> shift & 0xff, high = stops[left + 1] >> shift & 0xff;
        rgb |= static_cast<std::uint32_t>(std::lround(low + (high - low) * share)) << shift;
    }
    return packedColor(rgb);
}

std::uint32_t kindColor(std::size_t kind) {
    const std::uint32_t color = packedColor(kKinds[kind % std::size(kKinds)]);
    return kind / std::size(kKinds) % 2 == 1 ? darkerColor(color) : color;
}

std::uint32_t darkerColor(std::uint32_t color) {
    std::uint32_t darker = color & 0xff000000u;
    for (const int shift : {0, 8, 16}) darker |= ((color >> shift & 0xff) * 3 / 4) << shift;
    return darker;
}

}  // namespace nacre
