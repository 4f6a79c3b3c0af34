#include "engine/scene/color/palettes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

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

constexpr std::uint32_t kPlasma[] = {0x0d0887, 0x4c02a1, 0x7e03a8, 0xaa2395, 0xcc4778,
                                     0xe66c5c, 0xf89540, 0xfdc527, 0xf0f921};
constexpr std::uint32_t kBlueWhiteRed[] = {0x2f5fc4, 0xf4f4f2, 0xc43a34};
constexpr std::uint32_t kRedWhiteBlue[] = {0xc43a34, 0xf4f4f2, 0x2f5fc4};
constexpr std::uint32_t kGrays[] = {0x3a3a3a, 0xf0f0f0};

constexpr std::uint32_t kDistinct[] = {0x22bcfc, 0xd28c23, 0x2d6e5c, 0xe8edc3, 0x9482a0, 0x6c59a2, 0xd2b3be, 0x759878};
constexpr std::uint32_t kLight[] = {0x77aadd, 0xee8866, 0x44bb99, 0xeedd88, 0xffaabb, 0x99ddff, 0xbbcc33, 0xaaaa00};
constexpr std::uint32_t kOkabeIto[] = {0x56b4e9, 0xe69f00, 0x1fae83, 0xf0e442, 0x2b86c5, 0xe0733a, 0xd487b2};
constexpr std::uint32_t kBright[] = {0x4477aa, 0xee6677, 0x228833, 0xccbb44, 0x66ccee, 0xaa3377, 0xbbbbbb};
constexpr std::uint32_t kVibrant[] = {0xee7733, 0x0077bb, 0x33bbee, 0xee3377, 0xcc3311, 0x009988, 0xbbbbbb};
constexpr std::uint32_t kMuted[] = {0xcc6677, 0x332288, 0xddcc77, 0x117733, 0x88ccee,
                                    0x882255, 0x44aa99, 0x999933, 0xaa4499};

struct PaletteEntry {
    Palette palette;
    std::string_view name;
    std::span<const std::uint32_t> colors;
};
// In the order of the enumeration, after `automatic`.
constexpr PaletteEntry kPalettes[] = {
    {Palette::distinct, "distinct", kDistinct},
    {Palette::light, "light", kLight},
    {Palette::okabeIto, "okabe-ito", kOkabeIto},
    {Palette::bright, "bright", kBright},
    {Palette::vibrant, "vibrant", kVibrant},
    {Palette::muted, "muted", kMuted},
    {Palette::viridis, "viridis", kViridis},
    {Palette::plasma, "plasma", kPlasma},
    {Palette::sunset, "sunset", kSunset},
    {Palette::blueWhiteRed, "blue-white-red", kBlueWhiteRed},
    {Palette::redWhiteBlue, "red-white-blue", kRedWhiteBlue},
    {Palette::rainbow, "rainbow", kRainbow},
    {Palette::lipophilicity, "lipophilicity", kLipophilicity},
    {Palette::grays, "grays", kGrays},
};

std::span<const std::uint32_t> paletteColors(const AnyPalette& palette) {
    if (!palette.own.empty()) return palette.own;
    return kPalettes[static_cast<std::size_t>(palette.named) - 1].colors;
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

std::string_view paletteName(Palette palette) {
    return palette == Palette::automatic ? std::string_view() : kPalettes[static_cast<std::size_t>(palette) - 1].name;
}

std::string paletteName(const AnyPalette& palette) {
    std::string name;
    for (const std::uint32_t color : palette.own) name += (name.empty() ? "" : ":") + colorText(packedColor(color));
    return palette.own.empty() ? std::string(paletteName(palette.named)) : name;
}

std::optional<Palette> paletteFromName(std::string_view name) {
    for (const PaletteEntry& entry : kPalettes)
        if (entry.name == name) return entry.palette;
    return std::nullopt;
}

bool isRamp(const AnyPalette& palette) { return !palette.own.empty() || palette.named >= Palette::viridis; }

std::span<const Palette> allPalettes() {
    static constexpr auto kAll = [] {
        std::array<Palette, std::size(kPalettes)> all{};
        for (std::size_t i = 0; i < all.size(); ++i) all[i] = kPalettes[i].palette;
        return all;
    }();
    return kAll;
}

std::uint32_t paletteColor(const AnyPalette& ramp, double at) {
    const std::span<const std::uint32_t> stops = paletteColors(ramp);
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

std::size_t kindCount(const AnyPalette& kinds) { return paletteColors(kinds).size(); }

std::uint32_t kindColor(std::size_t kind, const AnyPalette& kinds) {
    const std::span<const std::uint32_t> colors = paletteColors(kinds);
    const std::uint32_t color = packedColor(colors[kind % colors.size()]);
    return kind / colors.size() % 2 == 1 ? darkerColor(color) : color;
}

std::uint32_t darkerColor(std::uint32_t color) {
    std::uint32_t darker = color & 0xff000000u;
    for (const int shift : {0, 8, 16}) darker |= ((color >> shift & 0xff) * 3 / 4) << shift;
    return darker;
}

}  // namespace nacre
