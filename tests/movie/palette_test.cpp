#include <gtest/gtest.h>

#include <vector>

#include "app/movie/gif.h"
#include "app/movie/write_movie.h"

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

/// Notes what it is shown for its palette.
class SampledFile : public MovieFile {
public:
    bool wantsSamples() const override { return true; }
    void sample(const Picture& picture) override { sampled.push_back(picture.width); }
    void add(const Picture&) override {}
    void finish() override {}
    std::vector<std::uint32_t> sampled;
};

TEST(Palette, IsMadeFromFramesOfTheWholeMovie) {
    const std::vector<std::vector<std::uint32_t>> expected{
        {0}, {0, 1}, {0, 1, 2}, {0, 1, 2, 3, 4}, {0, 1, 2, 3, 4, 5}, {0, 2, 4, 6, 8, 10}};
    for (const std::vector<std::uint32_t>& frames : expected) {
        SampledFile file;
        const std::uint64_t count = frames.size() < 6 || frames.back() == 5 ? frames.size() : 12;
        writeMovie(file, {count,
                          [](std::uint64_t frame) {
                              Picture picture;
                              picture.width = static_cast<std::uint32_t>(frame);
                              return picture;
                          },
                          [](MovieStage, std::uint64_t) { return true; }});
        EXPECT_EQ(file.sampled, frames);
    }
}

}  // namespace
}  // namespace nacre::app
