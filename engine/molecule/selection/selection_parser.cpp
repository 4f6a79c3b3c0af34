#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "engine/error.h"
#include "engine/molecule/element.h"
#include "engine/molecule/selection/selection_text.h"
#include "engine/molecule/text.h"

namespace nacre {
namespace {

using enum SelectionTest;

constexpr std::size_t kLongestText = 20'000;
constexpr int kDeepest = 64;
constexpr double kFarthest = 10'000;  // Å
constexpr char kAnyCode = '\x7f';     // after every insertion code

std::string upperCase(std::string_view text) {
    std::string upper(text);
    for (char& c : upper)
        if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    return upper;
}

class Parser : SelectionText {
public:
    explicit Parser(std::string_view text) : SelectionText(text) {}

    Selection parse() {
        if (text_.size() > kLongestText)
            throw Error("cannot read selection", "",
                        "it is longer than " + std::to_string(kLongestText) + " characters");
        expression();
        if (!atEnd()) expected("'and', 'or' or the end", {"and", "or", "within", "around"});
        result_.text = printable(trim(text_), 200);
        return std::move(result_);
    }

private:
    struct Nesting {
        explicit Nesting(Parser& parser) : depth(parser.depth_) {
            if (++depth > kDeepest) parser.fail("more than " + std::to_string(kDeepest) + " levels of nesting");
        }
        ~Nesting() { --depth; }
        int& depth;
    };

    void expression() {
        binary(disjunction);
        for (const auto& [near, words] : {std::pair(within, "within N of"), std::pair(around, "around N of")}) {
            if (!accept(near)) continue;
            SelectionStep step = distanceStep(near);
            operand(words);
            result_.steps.push_back(std::move(step));
            push(conjunction);
            refuseOperator(words);
        }
    }

    void binary(SelectionTest operation) {
        const auto part = [&] { operation == disjunction ? binary(conjunction) : term(); };
        part();
        while (accept(operation)) {
            part();
            push(operation);
        }
    }

    void term() {
        const Nesting nesting(*this);
        if (accept(negation)) {
            term();
            push(negation);
        } else if (accept(byResidue)) {
            operand("byres");
            push(byResidue);
        } else if (const auto near = keyword(); near == within || near == around) {
            accept(*near);
            SelectionStep step = distanceStep(*near);
            operand(*near == within ? "within N of" : "around N of");
            result_.steps.push_back(std::move(step));
        } else if (acceptCharacter('(')) {
            expression();
            if (!acceptCharacter(')')) expected("'and', 'or' or ')'", {"and", "or", "within", "around"});
        } else {
            test();
        }
    }

    /// What byres or within applies to.
    void operand(const char* operation) {
        skipBlanks();
        const bool parentheses = !atEnd() && text_[position_] == '(';
        term();
        if (!parentheses) refuseOperator(operation);
    }

    /// Where PyMOL and the eye may disagree on how far an operation reaches, the writer has to say.
    void refuseOperator(const char* operation) {
        const auto next = keyword();
        if (next && (*next == conjunction || *next == disjunction || *next == within || *next == around))
            fail("put parentheses around what '" + std::string(operation) + "' applies to, or around both");
    }

    SelectionStep distanceStep(SelectionTest test) {
        skipBlanks();
        const std::size_t begin = position_;
        const std::string_view number = word();
        const auto distance = parseNumber(number);
        if (!distance || !(*distance >= 0 && *distance <= kFarthest)) {
            position_ = begin;
            expected("a distance from 0 to 10000 Å");
        }
        skipBlanks();
        const std::size_t beforeOf = position_;
        if (lowerCase(word()) != "of") {
            position_ = beforeOf;
            expected("'of'", {"of"});
        }
        SelectionStep step;
        step.test = test;
        step.distance = *distance;
        return step;
    }

    void test() {
        skipBlanks();
        if (!atEndHere() && kMarks.find(text_[position_]) != std::string_view::npos) return chimeraSpecifier();
        const auto found = keyword();
        const std::string word = lowerCase(nextToken());
        if (!found || *found == conjunction || *found == disjunction)
            expected("a selection such as 'chain A', 'resn HEM' or 'protein'", keywords());
        accept(*found);
        SelectionStep step;
        step.test = *found;
        switch (*found) {
            case chain:
                values(step, "a chain name");
                break;
            case residueName:
                values(step, "a residue name");
                break;
            case atomName:
                values(step, "an atom name");
                break;
            case element:
                values(step, "an element symbol");
                break;
            case alternate:
                values(step, "an alternate location");
                break;
            case residueNumber:
                numbers(step, "a residue number");
                break;
            case model:
                numbers(step, "a model number");
                break;
            case atomNumber:
                numbers(step, "an atom's number");
                break;
            case secondary:
                if (word == "ss")
                    folds(step);
                else
                    step.words.push_back(foldOf(word));
                break;
            case sequence:
                pattern(step);
                break;
            case temperatureFactor:
            case occupancy:
                comparison(step);
                break;
            default:
                break;
        }
        result_.steps.push_back(std::move(step));
    }

    /// "#1/A,B:10-20,HEM@CA": parts that all have to hold. A part means what the word does that stands for it.
    void chimeraSpecifier() {
        std::string marks;
        chimera_ = true;
        while (!atEndHere() && kMarks.find(text_[position_]) != std::string_view::npos) {
            const char mark = text_[position_];
            // PyMOL's paths look alike, and mean something else by each place.
            if (marks.find(mark) != std::string::npos)
                fail("'" + std::string(1, mark) + "' stands twice in a specifier");
            marks += mark;
            ++position_;
            SelectionStep step;
            const std::size_t begin = position_;
            const bool number =
                begin < text_.size() && (text_[begin] == '-' || (text_[begin] >= '0' && text_[begin] <= '9'));
            if (mark == '#' || (mark == ':' && number)) {
                step.test = mark == '#' ? model : residueNumber;
                numbers(step, mark == '#' ? "a model number" : "a residue number");
            } else {
                step.test = mark == '/' ? chain : mark == ':' ? residueName : atomName;
                values(step, mark == '/' ? "a chain name" : mark == ':' ? "a residue name or number" : "an atom name");
            }
            result_.steps.push_back(std::move(step));
            if (marks.size() > 1) push(conjunction);
        }
        chimera_ = false;
    }

    /// The canonical name of a kind of fold; empty if a word is none.
    static std::string foldOf(const std::string& word) {
        if (word == "helix" || word == "h") return "HELIX";
        if (word == "strand" || word == "sheet" || word == "s" || word == "e") return "STRAND";
        if (word == "loop" || word == "coil" || word == "l" || word == "c" || word.empty()) return "LOOP";
        return {};
    }
    void folds(SelectionStep& step) {
        constexpr const char* kWanted = "helix, strand or loop";
        do {
            skipBlanks();
            const std::size_t begin = position_;
            step.words.push_back(foldOf(lowerCase(listItem(kWanted))));
            if (!step.words.back().empty()) continue;
            position_ = begin;
            expected(kWanted);
        } while (acceptCharacter('+') || acceptCharacter(','));
    }

    void pattern(SelectionStep& step) {
        constexpr const char* kWanted = "one-letter codes of residues in a row, at most 200";
        do {
            skipBlanks();
            const std::size_t begin = position_;
            step.words.push_back(upperCase(listItem(kWanted)));
            const std::string& letters = step.words.back();
            const bool usable =
                !letters.empty() && letters.size() <= 200 &&
                std::all_of(letters.begin(), letters.end(), [](char c) { return isLetter(c) || c == '?'; });
            if (usable) continue;
            position_ = begin;
            expected(kWanted);
        } while (acceptCharacter('+') || acceptCharacter(','));
    }

    void comparison(SelectionStep& step) {
        struct Sign {
            std::string_view text;
            Comparison meaning;
        };
        static constexpr Sign kSigns[] = {{"<=", Comparison::lessOrEqual}, {">=", Comparison::greaterOrEqual},
                                          {"!=", Comparison::notEqual},    {"==", Comparison::equal},
                                          {"<", Comparison::less},         {">", Comparison::greater},
                                          {"=", Comparison::equal}};
        skipBlanks();
        const auto sign = std::find_if(std::begin(kSigns), std::end(kSigns), [&](const Sign& known) {
            return text_.substr(position_, known.text.size()) == known.text;
        });
        if (sign == std::end(kSigns)) expected("one of < <= = >= > !=");
        position_ += sign->text.size();
        step.comparison = sign->meaning;
        skipBlanks();
        const std::size_t begin = position_;
        const auto number = parseNumber(word());
        if (!number || !std::isfinite(*number)) {
            position_ = begin;
            expected("a number");
        }
        step.value = *number;
    }

    void values(SelectionStep& step, const char* wanted) {
        do {
            skipBlanks();
            const std::size_t begin = position_;
            std::string value = listItem(wanted);
            if (step.test != chain) value = upperCase(value);
            if (step.test == element && value != "X" && nacre::elementFromSymbol(value) == 0) {
                position_ = begin;
                expected(wanted);
            }
            step.words.push_back(std::move(value));
        } while (acceptCharacter('+') || acceptCharacter(','));
    }

    std::string listItem(const char* wanted) {
        if (!atEnd() && (text_[position_] == '\'' || text_[position_] == '"')) {
            const std::size_t close = text_.find(text_[position_], position_ + 1);
            if (close == std::string_view::npos) fail("this quote is not closed");
            std::string value(text_.substr(position_ + 1, close - position_ - 1));
            position_ = close + 1;
            return value;
        }
        // A forgotten value, rather than a chain named "and".
        const auto next = keyword();
        if (next && (*next == conjunction || *next == disjunction || *next == negation)) expected(wanted);
        std::string value(word());
        if (value.empty()) expected(wanted);
        return value;
    }

    void numbers(SelectionStep& step, const char* wanted) {
        do {
            skipBlanks();
            const std::size_t end = wordEnd();
            NumberRange range;
            number(wanted, range.first, range.firstCode);
            range.last = range.first;
            range.lastCode = range.firstCode;
            if (position_ < end && (text_[position_] == '-' || text_[position_] == ':')) {
                ++position_;
                const std::size_t begin = position_;
                number(wanted, range.last, range.lastCode);
                if (range.lastCode == '\0') range.lastCode = kAnyCode;
                if (range.last < range.first) {
                    position_ = begin;
                    fail("the range ends before it begins");
                }
            }
            if (position_ < end) expected("'+', ',' or the end of the number");
            step.numbers.push_back(range);
        } while (acceptCharacter('+') || acceptCharacter(','));
    }

    void number(const char* wanted, std::int32_t& value, char& code) {
        const std::size_t begin = position_;
        if (text_.substr(position_, 2) == "\\-") ++position_;
        const char* end = text_.data() + text_.size();
        const auto [stop, error] = std::from_chars(text_.data() + position_, end, value);
        if (error != std::errc()) {
            position_ = begin;
            expected(wanted);
        }
        position_ = static_cast<std::size_t>(stop - text_.data());
        if (atEndHere() || !isLetter(text_[position_])) return;
        code = upperCase(text_.substr(position_, 1))[0];
        ++position_;
    }

    void push(SelectionTest operation) {
        SelectionStep step;
        step.test = operation;
        result_.steps.push_back(std::move(step));
    }

    int depth_ = 0;
    Selection result_;
};

}  // namespace

Selection parseSelection(std::string_view text) { return Parser(text).parse(); }

}  // namespace nacre
