#pragma once
// A selection's text while it is parsed: words, keywords, and the position for errors.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/molecule/selection/selection.h"

namespace nacre {

class SelectionText {
public:
    explicit SelectionText(std::string_view text) : text_(text) {}

protected:
    bool atEndHere() const { return position_ >= text_.size(); }
    bool atEnd();
    void skipBlanks();
    /// End of the word that begins here.
    std::size_t wordEnd() const;
    std::string_view word();
    /// The next word or operator; moves to its beginning.
    std::string_view nextToken();
    /// Meaning of the next token if it is a keyword: names of PyMOL, ChimeraX and VMD that agree.
    std::optional<SelectionTest> keyword();
    bool accept(SelectionTest wanted);
    bool acceptCharacter(char wanted);

    /// @param meant  valid words: the nearest is suggested
    [[noreturn]] void expected(const std::string& wanted, const std::vector<std::string>& meant = {});
    /// As above for an earlier position.
    [[noreturn]] void expectedAt(std::size_t place, const std::string& wanted,
                                 const std::vector<std::string>& meant = {}) {
        position_ = place;
        expected(wanted, meant);
    }
    static std::vector<std::string> keywords();
    /// @throws Error with the column
    [[noreturn]] void fail(const std::string& why) const;

    std::string_view text_;
    std::size_t position_ = 0;
    bool chimera_ = false;  ///< inside a ChimeraX specifier, whose marks end a word

    static constexpr std::string_view kMarks = "#/:@";  ///< of such specifiers
};

}  // namespace nacre
