#include "app/apple/label_colors.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace nacre::app {
namespace {

constexpr LabelColor kBlack{0, 0, 0, 1}, kWhite{1, 1, 1, 1};

TEST(LabelColors, ContrastIsThatOfTheStandard) {
    EXPECT_NEAR(contrastRatio(kBlack, kWhite), 21, 1e-6);
    EXPECT_NEAR(contrastRatio(kWhite, kWhite), 1, 1e-6);
    // #767676 is the lightest grey of 4.5 to 1 on white, as WebAIM's checker and the W3C's examples have it: 4.54.
    const float grey = 0x76 / 255.0f;
    EXPECT_NEAR(contrastRatio({grey, grey, grey, 1}, kWhite), 4.54, 0.005);
}

TEST(LabelColors, TextIsReadableOverEveryBackground) {
    for (int step = 0; step < 9 * 9 * 9; ++step) {
        const LabelColor background{static_cast<float>(step % 9) / 8, static_cast<float>(step / 9 % 9) / 8,
                                    static_cast<float>(step / 81) / 8, 1};
        for (const bool more : {false, true}) {
            const LabelColors colors = labelColors(background, more);
            // Atoms of any colour shine through the ground.
            for (const LabelColor& behind : {kBlack, kWhite, background}) {
                LabelColor seen = kWhite;
                for (std::size_t c = 0; c < 3; ++c)
                    seen[c] = colors.ground[c] * colors.ground[3] + behind[c] * (1 - colors.ground[3]);
                EXPECT_GE(contrastRatio(seen, colors.text), more ? 15 : 7);
            }
            EXPECT_GE(contrastRatio(colors.bare, background), 4.5);
        }
    }
}

TEST(LabelColors, WhatIsTransparentIsWhite) {
    EXPECT_EQ(labelColors({0, 0, 0, 0}, false).ground, labelColors(kWhite, false).ground);
}

}  // namespace
}  // namespace nacre::app
