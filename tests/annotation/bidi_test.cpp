// Directions of text beside FriBidi, and shaped lines.

#include "app/annotation/bidi.h"

#include <fribidi.h>
#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "app/annotation/painter.h"
#include "app/annotation/visual_text.h"

namespace nacre::app {
namespace {

FriBidiCharType judged(BidiClass c) {
    constexpr FriBidiCharType kTypes[] = {
        FRIBIDI_TYPE_LTR, FRIBIDI_TYPE_RTL, FRIBIDI_TYPE_AL,  FRIBIDI_TYPE_EN,  FRIBIDI_TYPE_ES,  FRIBIDI_TYPE_ET,
        FRIBIDI_TYPE_AN,  FRIBIDI_TYPE_CS,  FRIBIDI_TYPE_NSM, FRIBIDI_TYPE_BN,  FRIBIDI_TYPE_BS,  FRIBIDI_TYPE_SS,
        FRIBIDI_TYPE_WS,  FRIBIDI_TYPE_ON,  FRIBIDI_TYPE_LRE, FRIBIDI_TYPE_LRO, FRIBIDI_TYPE_RLE, FRIBIDI_TYPE_RLO,
        FRIBIDI_TYPE_PDF, FRIBIDI_TYPE_LRI, FRIBIDI_TYPE_RLI, FRIBIDI_TYPE_FSI, FRIBIDI_TYPE_PDI};
    return kTypes[static_cast<std::size_t>(c)];
}

TEST(Bidi, ClassesAreThoseOfUnicode) {
    std::string different;
    for (char32_t c = 1; c < 0x700; ++c) {  // Latin, Greek, Cyrillic, Armenian, Hebrew, Arabic
        const FriBidiCharType theirs = fribidi_get_bidi_type(c);
        char text[64];
        std::snprintf(text, sizeof text, " %04x:%s", static_cast<unsigned>(c), fribidi_get_bidi_type_name(theirs));
        if (theirs != judged(findBidiClass(c))) different += text;
    }
    // Signs of Bopomofo and Armenian.
    EXPECT_EQ(different, " 02ea:ON 02eb:ON 058a:ON 058d:ON 058e:ON");
}

/// The order of positions, by our runs.
std::vector<std::size_t> order(const std::vector<char32_t>& text) {
    std::vector<std::size_t> places;
    for (const DirectedRun& run : visualRuns(text))
        for (std::size_t i = 0; i < run.count; ++i)
            places.push_back(run.first + (run.rightToLeft ? run.count - 1 - i : i));
    return places;
}

/// FriBidi's, without what is in no run.
std::vector<std::size_t> judgedOrder(const std::vector<char32_t>& text) {
    const std::vector<FriBidiChar> logical(text.begin(), text.end());
    const auto count = static_cast<FriBidiStrIndex>(text.size());
    std::vector<FriBidiCharType> types(text.size());
    std::vector<FriBidiBracketType> brackets(text.size());
    std::vector<FriBidiLevel> levels(text.size());
    std::vector<FriBidiStrIndex> map(text.size());
    FriBidiParType base = FRIBIDI_PAR_ON;
    fribidi_get_bidi_types(logical.data(), count, types.data());
    fribidi_get_bracket_types(logical.data(), count, types.data(), brackets.data());
    if (!fribidi_get_par_embedding_levels_ex(types.data(), brackets.data(), count, &base, levels.data())) return {};
    for (std::size_t i = 0; i < map.size(); ++i) map[i] = static_cast<FriBidiStrIndex>(i);
    if (!fribidi_reorder_line(0, types.data(), count, 0, base, levels.data(), nullptr, map.data())) return {};
    std::vector<std::size_t> places;
    for (const FriBidiStrIndex i : map)
        if (const auto at = static_cast<std::size_t>(i); !FRIBIDI_IS_EXPLICIT_OR_BN(types[at])) places.push_back(at);
    return places;
}

TEST(Bidi, RandomLinesRunAsFriBidiHasThem) {
    const std::u32string letters =
        U"ab\u05d0\u05d1\u0628\u0645 1 2\u0661\u0662+-.,:/%$()[]<>!? \u0301\u05b0"
        U"\u200e\u200f\u202a\u202b\u202c\u202d\u202e";
    std::mt19937 random(7);
    // Half of the lines have marks that control directions. There FriBidi 1.0.8 gives brackets about a number that
    // begin an embedding the direction outside of it; UAX #9 (N0, X10) the embedding's.
    std::size_t wrong[2] = {};
    for (std::size_t round = 0; round < 20000; ++round) {
        std::vector<char32_t> text;
        const std::size_t known = round % 2 ? letters.size() : letters.size() - 7;
        for (std::size_t i = random() % 14 + 1; i > 0; --i) text.push_back(letters[random() % known]);
        wrong[round % 2] += order(text) != judgedOrder(text);
    }
    EXPECT_EQ(wrong[0], 0u);
    EXPECT_LE(wrong[1], 1u);
}

TEST(Bidi, IsolatesHideWhatTheyHold) {
    // FriBidi 1.0.8 looks through isolates for letters; UAX #9 does not. FSI without a letter is as LRI (P3).
    using Order = std::vector<std::size_t>;
    EXPECT_EQ(order({U'a', U' ', 0x2067, 0x5d0, 0x5d1, U'!', 0x2069, U' ', U'b'}), (Order{0, 1, 2, 5, 4, 3, 6, 7, 8}));
    EXPECT_EQ(order({0x5d0, U' ', 0x2066, U'1', U'-', U'2', 0x2069, U' ', 0x5d1}), (Order{8, 7, 6, 3, 4, 5, 2, 1, 0}));
    EXPECT_EQ(order({0x5d0, 0x2068, U'!', U'?', 0x2069, 0x5d1}), (Order{5, 4, 2, 3, 1, 0}));
    EXPECT_EQ(order({0x2067, 0x628, 0x2069, 0x5d0, 0x2067, U'2', U'%', U'1'}), (Order{5, 6, 7, 4, 3, 2, 1, 0}));
    EXPECT_EQ(order({0x2069, U'a', 0x2069}), (Order{0, 1, 2})) << "ends without a beginning";
}

TEST(Bidi, PanelsTextHasTheFormsOfFriBidi) {
    for (const char* text :
         {"\u0633\u0644\u0627\u0645", "\u0628\u0631\u0648\u062a\u064a\u0646 1abc", "\u0644\u0622 \u0644\u0625",
          "(\u05d0) 12", "\u0645\u064f\u062d\u064e\u0645\u0651\u062f"}) {
        std::vector<FriBidiChar> logical(200), visual(200);
        const std::string_view bytes(text);
        const FriBidiStrIndex count = fribidi_charset_to_unicode(
            FRIBIDI_CHAR_SET_UTF8, text, static_cast<FriBidiStrIndex>(bytes.size()), logical.data());
        FriBidiParType base = FRIBIDI_PAR_ON;
        fribidi_log2vis(logical.data(), count, &base, visual.data(), nullptr, nullptr, nullptr);
        std::string theirs(800, '\0');
        theirs.resize(static_cast<std::size_t>(
            fribidi_unicode_to_charset(FRIBIDI_CHAR_SET_UTF8, visual.data(), count, theirs.data())));
        for (std::size_t at; (at = theirs.find("\xef\xbb\xbf")) != std::string::npos;) theirs.erase(at, 3);
        EXPECT_EQ(visualText(text), theirs) << text;
    }
}

TEST(Shaping, LettersJoin) {
    const WordPainter painter;
    // Of beh alone and of three in a row: joined, the first two have no tail.
    const double one = painter.measureWidth("\u0628", 100), three = painter.measureWidth("\u0628\u0628\u0628", 100);
    EXPECT_LT(three, 2.4 * one);
    EXPECT_NEAR(painter.measureWidth("\u0628\u200c\u0628\u200c\u0628", 100), 3 * one, 1)
        << "non-joiners keep them apart";
    EXPECT_LT(painter.measureWidth("\u0644\u0627", 100), painter.measureWidth("\u0644\u200c\u0627", 100))
        << "lam and alef are one";
    EXPECT_NEAR(painter.measureWidth("e\u0301", 100), painter.measureWidth("e", 100), 1) << "an accent takes no room";
}

TEST(Shaping, IndicSignsChangePlaces) {
    const WordPainter painter;
    const auto ink = [&](const std::string& text) {
        std::vector<float> rgba(200 * 100 * 4, 1);
        Marks marks;
        marks.texts = {{{20, 70}, 50, text}};
        painter.paint(marks, rgba.data(), 200, 0, 100);
        double left = 0, right = 0;
        for (std::size_t i = 0; i < rgba.size(); i += 4) (i / 4 % 200 < 40 ? left : right) += 1 - rgba[i];
        return std::pair(left, right);
    };
    if (!systemFontWith({U'\u0915'})) GTEST_SKIP() << "no Devanagari font here";
    // Ka and the vowel sign i, which is written before it; and ka, virama, ssa, which are one.
    EXPECT_NE(ink("\u0915\u093f").first, ink("\u0915").first);
    EXPECT_LT(painter.measureWidth("\u0915\u094d\u0937", 100),
              0.95 * (painter.measureWidth("\u0915", 100) + painter.measureWidth("\u0937", 100)));
}

}  // namespace
}  // namespace nacre::app
