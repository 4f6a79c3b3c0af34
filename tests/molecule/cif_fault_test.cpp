// Errors of both PEGTLs that gemmi is built on say the same of the same text.

#include "engine/molecule/formats/cif_fault.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string_view>
#include <vector>

namespace nacre {
namespace {

struct Position {
    std::size_t byte = 0, line = 0;
};

/// The shape of PEGTL 2.8's.
struct Upstream : std::runtime_error {
    explicit Upstream(const std::string& words) : std::runtime_error(":12:3(45): " + words) {}
    std::vector<Position> positions{{45, 12}};
};

/// The shape of PEGTL 3's.
struct Debians : std::runtime_error {
    explicit Debians(std::string words) : std::runtime_error(":12:3: " + words), words_(std::move(words)) {}
    std::string_view message() const { return words_; }
    const std::vector<Position>& positions() const { return positions_; }

private:
    std::string words_;
    std::vector<Position> positions_{{45, 12}};
};

TEST(CifFault, IsToldAlikeWhicheverPegtlThrewIt) {
    for (const std::string words : {"parse error", "unterminated 'string'", "expected block header (data_)"}) {
        EXPECT_EQ(faultMessage(Upstream(words)), words);
        EXPECT_EQ(faultMessage(Debians(words)), words);
    }
    EXPECT_EQ(lineNumber(Upstream("parse error")), 12u);
    EXPECT_EQ(lineNumber(Debians("parse error")), 12u);
}

}  // namespace
}  // namespace nacre
