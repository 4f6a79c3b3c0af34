#include "app/images/srgb_profile.h"

#include <cmath>
#include <initializer_list>
#include <string_view>

namespace nacre::app {
namespace {

class Bytes {
public:
    void number(std::uint32_t value, int size = 4) {
        for (int shift = 8 * (size - 1); shift >= 0; shift -= 8)
            all.push_back(static_cast<std::uint8_t>(value >> shift));
    }
    /// s15Fixed16Number
    void fixed(double value) { number(static_cast<std::uint32_t>(std::lround(value * 65536))); }
    void text(std::string_view four) { all.insert(all.end(), four.begin(), four.end()); }
    void type(std::string_view four) {
        text(four);
        number(0);
    }
    std::vector<std::uint8_t> all;
};

std::vector<std::uint8_t> localized(std::string_view words) {
    Bytes tag;
    tag.type("mluc");
    tag.number(1);
    tag.number(12);
    tag.text("enUS");
    tag.number(static_cast<std::uint32_t>(2 * words.size()));
    tag.number(28);
    for (const char c : words) tag.number(static_cast<std::uint8_t>(c), 2);
    return tag.all;
}

std::vector<std::uint8_t> fixedTag(std::string_view type, std::initializer_list<double> values) {
    Bytes tag;
    tag.type(type);
    for (const double value : values) tag.fixed(value);
    return tag.all;
}

/// Linear light of a code value: ((a x + b)^g above d, c x below).
std::vector<std::uint8_t> curve() {
    Bytes tag;
    tag.type("para");
    tag.number(3, 2);
    tag.number(0, 2);
    for (const double value : {2.4, 1 / 1.055, 0.055 / 1.055, 1 / 12.92, 0.04045}) tag.fixed(value);
    return tag.all;
}

}  // namespace

std::vector<std::uint8_t> srgbProfile() {
    struct Tag {
        std::string_view name;
        std::vector<std::uint8_t> data;
    };
    const Tag tags[] = {
        {"desc", localized("sRGB")},
        {"cprt", localized("CC0")},
        {"wtpt", fixedTag("XYZ ", {0.9642, 1, 0.8249})},
        // D65 adapted to D50, and the adapted primaries.
        {"chad", fixedTag("sf32", {1.047882, 0.022919, -0.050201, 0.029587, 0.990479, -0.017059, -0.009232, 0.015076,
                                   0.751678})},
        {"rXYZ", fixedTag("XYZ ", {0.436066, 0.222488, 0.013916})},
        {"gXYZ", fixedTag("XYZ ", {0.385147, 0.716873, 0.097076})},
        {"bXYZ", fixedTag("XYZ ", {0.143066, 0.060608, 0.714096})},
        {"rTRC", curve()},
        {"gTRC", {}},  // the same curve
        {"bTRC", {}},
    };
    constexpr std::uint32_t kHeader = 128, kCount = 10;
    Bytes table, data;
    std::uint32_t at = 0, size = 0;
    for (const Tag& tag : tags) {
        if (!tag.data.empty()) {
            at = kHeader + 4 + 12 * kCount + static_cast<std::uint32_t>(data.all.size());
            size = static_cast<std::uint32_t>(tag.data.size());
            data.all.insert(data.all.end(), tag.data.begin(), tag.data.end());
            data.all.resize((data.all.size() + 3) / 4 * 4);
        }
        table.text(tag.name);
        table.number(at);
        table.number(size);
    }
    Bytes profile;
    profile.number(kHeader + 4 + static_cast<std::uint32_t>(table.all.size() + data.all.size()));
    profile.number(0);           // no preferred CMM
    profile.number(0x04300000);  // version
    profile.text("mntrRGB XYZ ");
    for (const std::uint32_t part : {1970u, 1u, 1u, 0u, 0u, 0u}) profile.number(part, 2);
    profile.text("acsp");
    for (int i = 0; i < 7; ++i) profile.number(0);  // platform, flags, device; 0: perceptual
    for (const double value : {0.9642, 1.0, 0.8249}) profile.fixed(value);
    profile.all.resize(kHeader);
    profile.number(kCount);
    profile.all.insert(profile.all.end(), table.all.begin(), table.all.end());
    profile.all.insert(profile.all.end(), data.all.begin(), data.all.end());
    return profile.all;
}

}  // namespace nacre::app
