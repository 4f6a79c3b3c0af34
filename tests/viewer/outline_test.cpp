// The outline of marked atoms: where it is, and what it leaves alone.

#include "app/viewer/outline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace nacre::app {
namespace {

constexpr PixelSize kSize{40, 30};

/// A disc of atom 3 in the middle, on a ground of atom 1 at the left and none at the right.
std::vector<std::uint32_t> makeDisc(double radius) {
    std::vector<std::uint32_t> atoms(std::size_t{kSize.width} * kSize.height);
    for (std::uint32_t y = 0; y < kSize.height; ++y)
        for (std::uint32_t x = 0; x < kSize.width; ++x)
            atoms[y * kSize.width + x] = std::hypot(x - 20.0, y - 15.0) <= radius ? 3 : x < 20 ? 1 : 0;
    return atoms;
}

std::vector<std::uint8_t> spreadAlphas(const std::vector<MarkSpan>& spans) {
    std::vector<std::uint8_t> alphas(std::size_t{kSize.width} * kSize.height);
    for (const MarkSpan& span : spans)
        for (std::uint32_t i = 0; i < span.width; ++i) {
            EXPECT_EQ(alphas[span.y * kSize.width + span.x + i], 0) << "pixels are covered once";
            alphas[span.y * kSize.width + span.x + i] = span.alpha;
        }
    return alphas;
}

/// Alphas of pixels, as whole pixels.
double measureArea(const std::vector<std::uint8_t>& alphas, const std::vector<std::uint32_t>& atoms, bool inside) {
    double area = 0;
    for (std::size_t i = 0; i < alphas.size(); ++i)
        if ((atoms[i] == 3) == inside) area += alphas[i] / 255.0;
    return area;
}

TEST(Outline, IsARingAroundWhatIsSeenOfTheSelection) {
    const std::vector<std::uint32_t> atoms = makeDisc(8);
    const Highlights marks{{false, false, true}};
    const std::vector<std::uint8_t> alphas = spreadAlphas(makeOutline(atoms, kSize, marks, 2));
    const double ring = std::numbers::pi * (10 * 10 - 8 * 8);
    EXPECT_NEAR(measureArea(alphas, atoms, false), ring, 0.12 * ring) << "two pixels wide";
    EXPECT_EQ(alphas[15 * kSize.width + 29], 255) << "beside the disc";
    EXPECT_EQ(alphas[15 * kSize.width + 32], 0) << "farther away";
    EXPECT_GT(alphas[15 * kSize.width + 20], 0) << "a tint inside";
    EXPECT_LT(alphas[15 * kSize.width + 20], 100) << "that leaves its colours";
}

TEST(Outline, OfWhatIsHoveredIsLighter) {
    const std::vector<std::uint32_t> atoms = makeDisc(8);
    Highlights hovered;
    hovered.firstHovered = 2, hovered.hovered = 1;
    const auto light = spreadAlphas(makeOutline(atoms, kSize, hovered, 2));
    const auto strong = spreadAlphas(makeOutline(atoms, kSize, {{false, false, true}}, 2));
    for (const bool inside : {true, false}) {
        EXPECT_GT(measureArea(light, atoms, inside), 0);
        EXPECT_LT(measureArea(light, atoms, inside), 0.8 * measureArea(strong, atoms, inside));
    }
}

TEST(Outline, IsNowhereWithoutMarkedAtomsInSight) {
    const std::vector<std::uint32_t> atoms = makeDisc(8);
    EXPECT_TRUE(makeOutline(atoms, kSize, {}, 2).empty());
    EXPECT_TRUE(makeOutline(atoms, kSize, {{false, true}}, 2).empty()) << "hidden behind others";
    EXPECT_TRUE(makeOutline({}, kSize, {{true}}, 2).empty()) << "nothing is known of the pixels";
    std::vector<std::uint32_t> beyond = atoms;
    for (std::uint32_t& atom : beyond) atom = 0xffffffff;
    EXPECT_TRUE(makeOutline(beyond, kSize, {{true}}, 2).empty()) << "of a dash, which is no atom";
}

TEST(Outline, IsPaintedOntoPictures) {
    const std::vector<std::uint32_t> atoms = makeDisc(8);
    Picture picture{kSize.width, kSize.height, std::vector<float>(std::size_t{4} * kSize.width * kSize.height, 0)};
    paintMarks(makeOutline(atoms, kSize, {{false, false, true}}, 2), picture);
    const float* ring = &picture.rgba[4 * (15 * kSize.width + 29)];
    EXPECT_FLOAT_EQ(ring[3], 1) << "also on a transparent ground";
    EXPECT_FLOAT_EQ(ring[0], 1);
    EXPECT_NEAR(ring[1], 0.0262f, 1e-3f) << "0x2d in linear light, by the sRGB standard";
    EXPECT_EQ(picture.rgba[3], 0) << "elsewhere nothing";
}

}  // namespace
}  // namespace nacre::app
