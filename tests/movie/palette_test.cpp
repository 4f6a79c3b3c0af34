#include <gtest/gtest.h>

#include <vector>

#include "app/movie/gif.h"

namespace nacre::app {
namespace {

TEST(Palette, KeepsTheBackgroundAndFewColoursExactly) {
    Palette palette;
    std::vector<std::uint8_t> few;
    for (int i = 0; i < 200; ++i) few.insert(few.end(), {static_cast<std::uint8_t>(i), 7, 9});
    few.insert(few.end(), 3000, 255);
    palette.count(few);
    palette.settle();
    EXPECT_EQ(palette.colors().front(), (Rgb{255, 255, 255}));
    for (std::size_t i = 0; i < few.size(); i += 3) {
        const Rgb& c = palette.colors()[palette.place(few.data() + i, 3, 5)];
        EXPECT_EQ(c, (Rgb{few[i], few[i + 1], few[i + 2]}));
    }
}

TEST(Palette, ManyColoursLieNear) {
    Palette palette;
    std::vector<std::uint8_t> shades;  // six hues, each from dark to light
    for (int hue = 1; hue < 7; ++hue)
        for (int i = 0; i < 250; ++i)
            for (int k = 0; k < 3; ++k) shades.push_back(static_cast<std::uint8_t>(hue >> k & 1 ? i : i / 3));
    palette.count(shades);
    palette.settle();
    EXPECT_LE(palette.colors().size(), Palette::kMost);
    for (std::size_t i = 0; i < shades.size(); i += 3)
        for (std::uint32_t x = 0; x < 8; ++x) {
            const Rgb& c = palette.colors()[palette.place(shades.data() + i, x, 1)];
            for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(c[k], shades[i + k], 16);
        }
}

}  // namespace
}  // namespace nacre::app
