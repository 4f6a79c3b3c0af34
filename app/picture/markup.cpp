// Markup: superscripts, subscripts and Greek letters.

#include <stdexcept>

#include "app/picture/words.h"
#include "engine/molecule/nearest_word.h"
#include "engine/molecule/text.h"

namespace nacre::app {
namespace {

struct Letter {
    std::string_view name, letter;
};
constexpr Letter kLetters[] = {
    {"alpha", "α"}, {"beta", "β"},    {"gamma", "γ"},   {"delta", "δ"},  {"epsilon", "ε"}, {"zeta", "ζ"},
    {"eta", "η"},   {"theta", "θ"},   {"iota", "ι"},    {"kappa", "κ"},  {"lambda", "λ"},  {"mu", "μ"},
    {"nu", "ν"},    {"xi", "ξ"},      {"omicron", "ο"}, {"pi", "π"},     {"rho", "ρ"},     {"sigma", "σ"},
    {"tau", "τ"},   {"upsilon", "υ"}, {"phi", "φ"},     {"chi", "χ"},    {"psi", "ψ"},     {"omega", "ω"},
    {"Gamma", "Γ"}, {"Delta", "Δ"},   {"Theta", "Θ"},   {"Lambda", "Λ"}, {"Xi", "Ξ"},      {"Pi", "Π"},
    {"Sigma", "Σ"}, {"Phi", "Φ"},     {"Psi", "Ψ"},     {"Omega", "Ω"},  {"AA", "Å"},      {"deg", "°"},
    {"prime", "′"}, {"to", "→"},      {"cdot", "·"},    {"pm", "±"},     {"times", "×"}};

/// Length in bytes of the character at a position.
std::size_t characterBytes(std::string_view text, std::size_t at) {
    std::size_t bytes = 1;
    while (at + bytes < text.size() && (static_cast<unsigned char>(text[at + bytes]) & 0xc0) == 0x80) ++bytes;
    return bytes;
}

class MarkupReader {
public:
    explicit MarkupReader(std::string_view text) : text_(text) {}
    std::vector<TextRun> read() {
        while (at_ < text_.size()) {
            if (text_[at_] != '_' && text_[at_] != '^') {
                add(character(), 0);
                continue;
            }
            const int level = text_[at_++] == '^' ? 1 : -1;
            if (at_ >= text_.size()) fail("nothing follows its last character");
            if (text_[at_] != '{') {
                add(character(), level);
                continue;
            }
            ++at_;
            while (at_ < text_.size() && text_[at_] != '}') add(character(), level);
            if (at_ >= text_.size()) fail("a brace is not closed");
            ++at_;
        }
        return std::move(runs_);
    }

private:
    [[noreturn]] void fail(const std::string& why) const {
        throw std::invalid_argument("'" + std::string(text_) + "': " + why);
    }
    std::string character() {
        if (text_[at_] != '\\') {
            const std::size_t bytes = characterBytes(text_, at_);
            at_ += bytes;
            return std::string(text_.substr(at_ - bytes, bytes));
        }
        if (++at_ >= text_.size()) fail("nothing follows its last character");
        if (!isLetter(text_[at_])) return std::string(1, text_[at_++]);
        std::size_t end = at_;
        while (end < text_.size() && isLetter(text_[end])) ++end;
        const std::string_view name = text_.substr(at_, end - at_);
        // "\alphaH" is a Greek letter followed by another letter.
        const Letter* longest = nullptr;
        std::vector<std::string> words;
        for (const Letter& letter : kLetters) {
            words.emplace_back(letter.name);
            if (name.starts_with(letter.name) && (!longest || letter.name.size() > longest->name.size()))
                longest = &letter;
        }
        if (longest) {
            at_ += longest->name.size();
            return std::string(longest->letter);
        }
        fail("there is no letter '\\" + std::string(name) + "'" + suggestion(name, words));
    }
    void add(const std::string& character, int level) {
        if (runs_.empty() || runs_.back().level != level) runs_.push_back({"", level});
        runs_.back().text += character;
    }

    std::string_view text_;
    std::size_t at_ = 0;
    std::vector<TextRun> runs_;
};

}  // namespace

std::vector<TextRun> parseMarkup(std::string_view text) { return MarkupReader(text).read(); }

}  // namespace nacre::app
