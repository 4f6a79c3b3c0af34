#pragma once
// The text of a selection as the parser goes through it: words, key words, and where it stands when it fails.

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
    /// Where the word ends that begins here.
    std::size_t wordEnd() const;
    std::string_view word();
    /// The next word or operator as it stands; moves on to it, not past it.
    std::string_view nextToken();
    /// What the next token means, if it is a key word: the names of PyMOL, ChimeraX and VMD where they mean one thing.
    std::optional<SelectionTest> keyword();
    bool accept(SelectionTest wanted);
    bool acceptCharacter(char wanted);

    /// @param meant  what may be: the nearest is suggested
    [[noreturn]] void expected(const std::string& wanted, const std::vector<std::string>& meant = {});
    /// The same of what stands at a place that was passed.
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
    bool chimera_ = false;  ///< in a specifier of ChimeraX, whose marks end a word

    static constexpr std::string_view kMarks = "#/:@";  ///< of such specifiers
};

}  // namespace nacre
