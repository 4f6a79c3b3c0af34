// What stands in for std::from_chars and std::to_chars where the library has none, against those of this one.

#include "engine/molecule/floating_point.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <random>
#include <string>

#include "engine/molecule/text.h"

namespace nacre {
namespace {

void expectSame(const std::string& text) {
    double expected = 42, value = 42;
    const char* const end = text.data() + text.size();
    const auto right = std::from_chars(text.data(), end, expected);
    const auto ours = portable::fromChars(text.data(), end, value);
    EXPECT_EQ(ours.ec, right.ec) << text;
    EXPECT_EQ(ours.ptr - text.data(), right.ptr - text.data()) << text;
    EXPECT_EQ(std::isnan(value), std::isnan(expected)) << text;
    if (!std::isnan(expected)) {
        EXPECT_EQ(std::bit_cast<std::uint64_t>(value), std::bit_cast<std::uint64_t>(expected)) << text;
    }
}

TEST(FloatingPoint, ReadsAsTheStandardLibraryDoes) {
    for (const char* text : {"", " 1"}) expectSame(text);
    for (const std::string_view text :
         splitAllWords("- +1 0 -0 00012.500 1. .5 . -.5e1 1e 1e+ 1e+2x 1E-2 1e400 -1e400 1e-400 0e-400 4.9e-324 "
                       "1e-320 0x10 1,5 1.5.2 inf -INF infin Infinity nan -nan NaN(a_1) nan( nan(-) e5 12abc "
                       "--1 1d2 1.7976931348623158e308 1.8e308 179769313486231580793728971405301e276 "
                       "0.000000000000000000000000000000000000000000001234"))
        expectSame(std::string(text));
    std::mt19937 random(7);
    constexpr std::string_view kAlphabet = "0123456789.-+eE0123456789infa x(";
    for (int i = 0; i < 30000; ++i) {
        std::string text(random() % 14, ' ');
        for (char& c : text) c = kAlphabet[random() % kAlphabet.size()];
        expectSame(text);
    }
}

TEST(FloatingPoint, WritesWhatReadsBackTheSame) {
    std::mt19937_64 random(11);
    for (int i = 0; i < 30000; ++i) {
        const double value = i % 2 ? std::bit_cast<double>(random()) : std::round(1e4 * std::sin(i)) / 1e3;
        if (!std::isfinite(value)) continue;
        std::array<char, 32> ours{}, right{};
        const auto end = portable::toChars(ours.data(), ours.data() + ours.size(), value);
        const auto rightEnd = std::to_chars(right.data(), right.data() + right.size(), value);
        ASSERT_EQ(end.ec, std::errc());
        double back = 0;
        portable::fromChars(ours.data(), end.ptr, back);
        EXPECT_EQ(back, value) << ours.data();
        if (std::abs(value) > 1e-4 && std::abs(value) < 1e5) {
            EXPECT_EQ(std::string(ours.data(), end.ptr), std::string(right.data(), rightEnd.ptr));
        }
    }
    std::array<char, 3> small{};
    EXPECT_EQ(portable::toChars(small.data(), small.data() + small.size(), 0.125).ec, std::errc::value_too_large);
}

}  // namespace
}  // namespace nacre
