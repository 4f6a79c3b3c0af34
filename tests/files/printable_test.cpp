#include "app/files/printable.h"

#include <gtest/gtest.h>

#include "app/files/code_points.h"
#include "app/files/json_text.h"

namespace nacre::app {
namespace {

TEST(Printable, LeavesWhatIsTextAlone) {
    for (const char* text : {"", "4hhb.pdb", "Å µ 日本語 🧬",
                             "a\xc2\xa0"
                             "b",
                             "C:\\x1b"})
        EXPECT_EQ(printable(text), text);
}

TEST(Printable, ShowsWhatATerminalWouldObey) {
    EXPECT_EQ(printable("\x1b[2J\a\b\x7f"), "\\x1b[2J\\x07\\x08\\x7f");
    EXPECT_EQ(printable("a\nb\r\tc"), "a b  c");
    EXPECT_EQ(printableLines("a\nb\x1b"), "a\nb\\x1b");
    EXPECT_EQ(printable("\xc2\x9b"
                        "31m"),
              "\\x9b31m");  // C1: CSI
    EXPECT_EQ(printable("\x9b"
                        "31m"),
              "\\x9b31m");  // the same, for terminals of one byte
    EXPECT_EQ(printable("\xe2\x80\xae"
                        "bdp.exe"),
              "\\u202ebdp.exe");  // right to left from here
    EXPECT_EQ(printable("\xe2\x81\xa6x\xe2\x81\xa9"), "\\u2066x\\u2069");
    EXPECT_EQ(printable("\xe2\x80\xa8"), "\\u2028");
    EXPECT_EQ(printable(std::string_view("\0", 1)), "\\x00");
}

TEST(CodePoints, GoToUtf16AndBack) {
    const std::string text = "a\u00e9\u4e2d\U0001f9ec";
    EXPECT_EQ(toUtf16(text), u"a\u00e9\u4e2d\U0001f9ec");
    EXPECT_EQ(toUtf8(toUtf16(text)), text);
    EXPECT_EQ(codePoints(text), (std::vector<char32_t>{'a', 0xe9, 0x4e2d, 0x1f9ec}));
    EXPECT_EQ(toUtf16("\xff z"), u"\ufffd z");
    const char16_t halves[] = {0xdc00, u'x', 0xd83e, 0};  // of pairs
    EXPECT_EQ(toUtf8(halves), "\ufffdx\ufffd");
}

TEST(Printable, ShowsBytesThatAreNoText) {
    EXPECT_EQ(printable("\xff\xfe"), "\\xff\\xfe");
    EXPECT_EQ(printable("\xc3"), "\\xc3");                    // ends too soon
    EXPECT_EQ(printable("\xc0\x9b"), "\\xc0\\x9b");           // overlong
    EXPECT_EQ(printable("\xe0\x82\x9b"), "\\xe0\\x82\\x9b");  // overlong C1
    EXPECT_EQ(printable("\xed\xa0\x80"), "\\xed\\xa0\\x80");  // a surrogate
    EXPECT_EQ(printable("\xf4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80");
}

TEST(Printable, JsonStaysTheSameJson) {
    const nlohmann::ordered_json json{{"title", "\x1b[2J \xc2\x9b \x7f \xe2\x80\xae Å"}, {"n", {1, 2.5}}};
    const std::string text = jsonText(json);
    EXPECT_EQ(text.find_first_of("\x1b\x7f"), std::string::npos);
    EXPECT_EQ(text.find("\xc2\x9b"), std::string::npos);
    EXPECT_EQ(text.find("\xe2\x80\xae"), std::string::npos);
    EXPECT_NE(text.find("Å"), std::string::npos);
    EXPECT_EQ(nlohmann::ordered_json::parse(text), json);
    EXPECT_EQ(printableLines(text), text);
    // What is no UTF-8 becomes U+FFFD.
    EXPECT_NE(jsonText({{"title", "\x9b"}}).find("\xef\xbf\xbd"), std::string::npos);
}

}  // namespace
}  // namespace nacre::app
