#include "engine/scene/color/colors.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace nacre {
namespace {

// Index = atomic number; 0 = unknown, 119 = deuterium.
constexpr std::array<std::uint32_t, 120> kElements = {
    0xd88ab8,                                                                        // unknown
    0xf2f0ec, 0xcfeeee,                                                              // H He
    0xb58ae0, 0xb3d98c, 0xeab5a4, 0xc4beb4, 0x7f9be8, 0xe0645c, 0x9cd88f, 0xb5dfe8,  // Li-Ne
    0xa37fd6, 0x8fcf7a, 0xbfa9a9, 0xe0c4a0, 0xee9f4d, 0xeccb52, 0x74c96b, 0x92cfdd,  // Na-Ar
    0x9370c4, 0x6cc068, 0xdedee2, 0xb9bec4, 0xa3a7b0, 0x8c9bc2, 0x9e7fc0, 0xd9824a, 0xdc8fa0,
    0x6fbf82, 0xc98852, 0x8388b4, 0xc09494, 0x6e9595, 0xb884d8, 0xe3a350, 0xa8524a, 0x74b9cd,  // K-Kr
    0x7d5cb0, 0x4fae5e, 0x9edddd, 0x9bd6d8, 0x82bcc6, 0x68b0b2, 0x559c9f, 0x44898f, 0x2f7c8c,
    0x287b8a, 0xc8ccd0, 0xead29a, 0xa8837f, 0x74858a, 0xa06fb4, 0xcd8430, 0x9463ad, 0x5ba6b8,  // Rb-Xe
    0x6c4a9b, 0x3f9c52,                                                                        // Cs Ba
    0x82cde4, 0xe6e6c8, 0xcfe6c4, 0xc2e4c4, 0xadebc6, 0x99e2c2, 0x78dcc2, 0x5ed6c0, 0x4fccb8,
    0x42c4b0, 0x38b8a4, 0x32b08e, 0x30ae7c, 0x30a45e,  // La-Yb
    0x3a9a44, 0x74bce0, 0x76a6dc, 0x5592c4, 0x4a80a8, 0x4a769a, 0x3f6688, 0xc8c8d4, 0xe2bb50,
    0xb0b2c4, 0xa4665a, 0x646872, 0x9a5fb0, 0xa9763a, 0x7e5a52, 0x4a8ea2,  // Lu-Rn
    0x5c3c86, 0x3a8448,                                                    // Fr Ra
    0x77a8de, 0x5cb4d8, 0x4ea4d4, 0x4a92d0, 0x4a82cc, 0x4c74c8, 0x5a6ac4, 0x7064c0, 0x8660bc,
    0x9658b4, 0xa24eac, 0xa84aa2, 0xa84896, 0xae468a,  // Ac-No
    0xb44864, 0xb84c60, 0xbc4e5c, 0xc0505a, 0xc45258, 0xc85456, 0xcc5654, 0xcf5852, 0xd25a50,
    0xd55c4e, 0xb06a58, 0x7c7280, 0xa068b0, 0xa87848, 0x80605c, 0x5090a0,  // Lr-Og
    0xe6e4f0};                                                             // deuterium

struct NamedColor {
    std::string_view name;
    std::uint32_t rgb;
};

// One hue per family, one shade per residue; protonation variants and selenomethionine share their parent's.
constexpr NamedColor kResidues[] = {
    {"ASP", 0xe0645c}, {"GLU", 0xd4584f}, {"ASH", 0xe0645c}, {"GLH", 0xd4584f},  {"LYS", 0x6f8fe0},  {"ARG", 0x5b79d2},
    {"HIS", 0x94a8ea}, {"HID", 0x94a8ea}, {"HIE", 0x94a8ea}, {"HIP", 0x94a8ea},  {"HSD", 0x94a8ea},  {"HSE", 0x94a8ea},
    {"HSP", 0x94a8ea}, {"SER", 0xf0b27a}, {"THR", 0xe6a066}, {"ASN", 0x6fcad0},  {"GLN", 0x5bb9c2},  {"PHE", 0xa884cc},
    {"TYR", 0xbf94d6}, {"TRP", 0x8f6cb8}, {"ALA", 0xcbd3c0}, {"VAL", 0x8fbf86},  {"LEU", 0x7ab070},  {"ILE", 0x66a05e},
    {"PRO", 0xd9a3a8}, {"GLY", 0xeceae4}, {"CYS", 0xeccb52}, {"CYX", 0xeccb52},  {"CYM", 0xeccb52},  {"MET", 0xd8b548},
    {"MSE", 0xd8b548}, {"SEC", 0xe3a350}, {"PYL", 0x6f8fe0}, {"A", 0xe0756a},    {"DA", 0xe0756a},   {"C", 0xe8c25a},
    {"DC", 0xe8c25a},  {"G", 0x7cbf7a},   {"DG", 0x7cbf7a},  {"T", 0x6f9fe0},    {"DT", 0x6f9fe0},   {"U", 0x8f88dc},
    {"DU", 0x8f88dc},  {"I", 0x8fd0b4},   {"DI", 0x8fd0b4},  {"HOH", 0xb8d4ea},  {"WAT", 0xb8d4ea},  {"H2O", 0xb8d4ea},
    {"DOD", 0xb8d4ea}, {"SOL", 0xb8d4ea}, {"TIP", 0xb8d4ea}, {"TIP3", 0xb8d4ea}, {"TIP4", 0xb8d4ea}, {"SPC", 0xb8d4ea}};
constexpr std::uint32_t kOtherResidue = 0xc4beb4;

/// Decodes the lowest byte of an sRGB colour.
double linearByte(std::uint32_t color) {
    const double c = (color & 0xff) / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}
std::uint32_t codedByte(double light) {
    const double coded = light <= 0.0031308 ? light * 12.92 : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
    return static_cast<std::uint32_t>(std::lround(255 * coded));
}

}  // namespace

std::uint32_t withOpacity(std::uint32_t color, double opacity) {
    const double steps = std::round(opacity * kOpacitySteps);
    if (steps >= kOpacitySteps) return color;
    return (color & ~kSurfaceBits) | (static_cast<std::uint32_t>(std::max(steps, kMaterials + 1.0)) - 1) << 25;
}

std::uint32_t elementColor(Element element) { return packedColor(kElements[element < kElements.size() ? element : 0]); }

std::uint32_t residueColor(std::string_view name) {
    const auto* found = std::find_if(std::begin(kResidues), std::end(kResidues),
                                     [&](const NamedColor& named) { return named.name == name; });
    return packedColor(found == std::end(kResidues) ? kOtherResidue : found->rgb);
}

std::uint32_t copyTint(std::size_t tint, std::size_t count) {
    constexpr std::size_t kMostTones = 6;
    constexpr double kDarkest = 130;  // sRGB: a fifth of the light
    const std::size_t steps = std::clamp<std::size_t>(count, 2, kMostTones) - 1;
    const double share = static_cast<double>(tint % kMostTones) / static_cast<double>(steps);
    const auto grey = static_cast<std::uint32_t>(std::lround(255 - (255 - kDarkest) * share));
    return grey | grey << 8 | grey << 16 | 0xfe000000u;
}

std::uint32_t tintedColor(std::uint32_t color, std::uint32_t tint) {
    std::uint32_t mixed = 0xff000000u;
    for (const int shift : {0, 8, 16})
        mixed |= codedByte(linearByte(color >> shift) * linearByte(tint >> shift)) << shift;
    return mixed;
}

std::uint32_t meanColor(std::span<const std::uint32_t> colors, std::span<const float> shares) {
    const auto computeMean = [&](const auto& getValue) {
        double sum = 0, all = 0;
        for (std::size_t i = 0; i < colors.size(); ++i) {
            const auto share = static_cast<double>(shares[i]);
            sum += share * getValue(colors[i]);
            all += share;
        }
        return sum / all;
    };
    std::uint32_t mean = 0xff000000u;
    for (const int shift : {0, 8, 16})
        mean |= codedByte(computeMean([&](std::uint32_t color) { return linearByte(color >> shift); })) << shift;
    return withOpacity(mean,
                       computeMean([](std::uint32_t color) { return opacitySteps(color) / double{kOpacitySteps}; }));
}

}  // namespace nacre
