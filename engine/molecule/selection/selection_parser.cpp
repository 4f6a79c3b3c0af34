#include <algorithm>
#include <charconv>
#include <cmath>
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

class Parser : SelectionText {
public:
    explicit Parser(std::string_view text) : SelectionText(text) {}

    Selection parse() {
        if (text_.size() > kLongestText)
            throw Error("cannot read selection", "",
                        "it is longer than " + std::to_string(kLongestText) + " characters");
        expression();
        if (!atEnd()) expected("'and', 'or' or the end", {"and", "or", "within", "around"});
        result_.text = trim(text_);
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
            const bool before = std::exchange(afterOperator_, true);
            part();
            afterOperator_ = before;
            push(operation);
        }
    }

    /// What may follow a term: "around 5", "expand 5", "extend 2", ":<5".
    void postfixes() {
        for (;;) {
            skipBlanks();
            const std::size_t begin = position_;
            const auto found = keyword();
            if (found == around || found == expand || found == extend) {
                accept(*found);
                SelectionStep step;
                step.test = *found;
                step.distance = distance();
                skipBlanks();
                if (lowerCase(nextToken()) == "of") {  // the reference follows
                    position_ = begin;
                    return;
                }
                refuseAfterOperator(begin);
                result_.steps.push_back(std::move(step));
            } else if (isZone()) {
                refuseAfterOperator(begin);
                zone();
            } else {
                return;
            }
        }
    }

    /// PyMOL and ChimeraX differ in the operand of "a and b around 5".
    void refuseAfterOperator(std::size_t begin) {
        if (!afterOperator_) return;
        position_ = begin;
        fail("put parentheses around what '" + std::string(nextToken()) + "' applies to");
    }

    bool isZone() const {
        const std::string_view rest = text_.substr(std::min(position_, text_.size()), 2);
        return rest.size() == 2 && (rest[0] == ':' || rest[0] == '@') && (rest[1] == '<' || rest[1] == '>');
    }
    /// ":<5": residues with an atom within 5 Å; ":>5": the others; with @ atoms.
    void zone() {
        const bool residues = text_[position_] == ':', beyond = text_[position_ + 1] == '>';
        position_ += 2;
        SelectionStep step;
        step.test = expand;
        step.distance = distance();
        result_.steps.push_back(std::move(step));
        if (residues) push(byResidue);
        if (beyond) push(negation);
    }

    void term() {
        const Nesting nesting(*this);
        const auto first = keyword();
        if (accept(negation)) {
            const bool before = std::exchange(afterOperator_, true);
            term();
            afterOperator_ = before;
            push(negation);
        } else if (first == byResidue || first == byChain || first == byMolecule || first == neighbor) {
            const std::string word(nextToken());
            accept(*first);
            const bool before = std::exchange(afterOperator_, false);  // "byres ligand around 5" has only one meaning
            operand(word.c_str());
            afterOperator_ = before;
            push(*first);
        } else if (first == within || first == around) {
            accept(*first);
            SelectionStep step = distanceStep(*first);
            operand(*first == within ? "within N of" : "around N of");
            result_.steps.push_back(std::move(step));
        } else if (acceptCharacter('(')) {
            const bool before = std::exchange(afterOperator_, false);
            expression();
            afterOperator_ = before;
            if (!acceptCharacter(')')) expected("'and', 'or' or ')'", {"and", "or", "within", "around"});
            const bool inParentheses = std::exchange(afterOperator_, false);
            postfixes();
            afterOperator_ = inParentheses;
        } else {
            test();
            postfixes();
        }
    }

    /// Operand of byres or within.
    void operand(const char* operation) {
        skipBlanks();
        const bool parentheses = !atEnd() && text_[position_] == '(';
        term();
        if (!parentheses) refuseOperator(operation);
    }

    /// If PyMOL's operand would be longer, the user must add parentheses.
    void refuseOperator(const char* operation) {
        const auto next = keyword();
        if (next && (*next == conjunction || *next == disjunction || *next == within || *next == around))
            fail("put parentheses around what '" + std::string(operation) + "' applies to, or around both");
    }

    double distance() {
        skipBlanks();
        const std::size_t begin = position_;
        const auto distance = parseNumber(word());
        if (!distance || !(*distance >= 0 && *distance <= kFarthest)) expectedAt(begin, "a distance from 0 to 10000 Å");
        return *distance;
    }

    SelectionStep distanceStep(SelectionTest test) {
        const double reach = distance();
        skipBlanks();
        const std::size_t beforeOf = position_;
        if (lowerCase(word()) != "of") expectedAt(beforeOf, "'of'", {"of"});
        SelectionStep step;
        step.test = test;
        step.distance = reach;
        return step;
    }

    void test() {
        skipBlanks();
        if (!atEndHere() && !isZone() && kMarks.find(text_[position_]) != std::string_view::npos)
            return chimeraSpecifier();
        const auto found = keyword();
        const std::string word = lowerCase(nextToken());
        const auto isOneOf = [&](std::initializer_list<SelectionTest> tests) {
            return std::find(tests.begin(), tests.end(), *found) != tests.end();
        };
        if (!found || isOneOf({conjunction, disjunction, expand, extend}))
            expected("a selection such as 'chain A', 'resn HEM' or 'protein'", keywords());
        accept(*found);
        SelectionStep step;
        step.test = *found;
        if (isOneOf({chain, segment, entity, residueName, atomName, element, alternate})) values(step);
        if (isOneOf({residueNumber, model, atomNumber})) numbers(step, describeValue(*found));
        if (isOneOf({temperatureFactor, occupancy})) comparison(step);
        if (*found == sequence) pattern(step);
        if (*found == ligand && word == "mainligand") step.words.push_back(word);
        if (*found == secondary && word == "ss") folds(step);
        if (*found == secondary && word != "ss") step.words.push_back(parseFold(word));
        result_.steps.push_back(std::move(step));
    }

    /// Description of a test's value, for messages.
    static const char* describeValue(SelectionTest test) {
        if (test == chain) return "a chain name";
        if (test == segment) return "a segment's name";
        if (test == entity) return "an entity's identifier or name";
        if (test == residueName) return "a residue name";
        if (test == atomName) return "an atom name";
        if (test == element) return "an element symbol";
        if (test == alternate) return "an alternate location";
        if (test == residueNumber) return "a residue number";
        return test == model ? "a model number" : "an atom's number";
    }

    /// "#1/A,B:10-20,HEM@CA": all parts must match. Each is equivalent to its keyword.
    void chimeraSpecifier() {
        std::string marks;
        chimera_ = true;
        while (!atEndHere() && kMarks.find(text_[position_]) != std::string_view::npos && !isZone()) {
            const char mark = text_[position_];
            // PyMOL's paths look similar, but their positions have other meanings.
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
                numbers(step, describeValue(step.test));
            } else {
                step.test = mark == '/' ? chain : mark == ':' ? residueName : atomName;
                values(step, mark == ':' ? "a residue name or number" : nullptr);
            }
            result_.steps.push_back(std::move(step));
            if (marks.size() > 1) push(conjunction);
        }
        chimera_ = false;
    }

    /// The canonical name of a secondary structure; empty if invalid.
    static std::string parseFold(const std::string& word) {
        if (word == "helix" || word == "h") return "HELIX";
        if (word == "strand" || word == "sheet" || word == "s" || word == "e") return "STRAND";
        if (word == "loop" || word == "coil" || word == "l" || word == "c" || word.empty()) return "LOOP";
        return {};
    }

    /// Values separated by + or commas. @param read  takes one; false if it is unusable
    template <typename Read>
    void list(const char* wanted, const Read& read) {
        do {
            skipBlanks();
            const std::size_t begin = position_;
            if (!read()) expectedAt(begin, wanted);
        } while (acceptCharacter('+') || acceptCharacter(','));
    }

    void folds(SelectionStep& step) {
        constexpr const char* kWanted = "helix, strand or loop";
        list(kWanted, [&] { return !step.words.emplace_back(parseFold(lowerCase(listItem(kWanted)))).empty(); });
    }

    void pattern(SelectionStep& step) {
        constexpr const char* kWanted = "one-letter codes of residues in a row, at most 200";
        list(kWanted, [&] {
            const std::string& letters = step.words.emplace_back(upperCase(listItem(kWanted)));
            return !letters.empty() && letters.size() <= 200 &&
                   std::all_of(letters.begin(), letters.end(), [](char c) { return isLetter(c) || c == '?'; });
        });
    }

    void comparison(SelectionStep& step) {
        // Bit mask of comparisons: 1 less, 2 equal, 4 greater.
        static constexpr std::pair<std::string_view, std::uint8_t> kSigns[] = {
            {"<=", 3}, {">=", 6}, {"!=", 5}, {"==", 2}, {"<", 1}, {">", 4}, {"=", 2}};
        skipBlanks();
        const auto sign = std::ranges::find_if(
            kSigns, [&](const auto& known) { return text_.substr(position_, known.first.size()) == known.first; });
        if (sign == std::end(kSigns)) expected("one of < <= = >= > !=");
        position_ += sign->first.size();
        step.comparison = static_cast<Comparison>(sign->second);
        skipBlanks();
        const std::size_t begin = position_;
        const auto number = parseNumber(word());
        if (!number || !std::isfinite(*number)) expectedAt(begin, "a number");
        step.value = *number;
    }

    void values(SelectionStep& step, const char* wanted = nullptr) {
        if (!wanted) wanted = describeValue(step.test);
        list(wanted, [&] {
            std::string value = listItem(wanted);
            if (step.test != chain && step.test != segment) value = upperCase(value);
            const bool usable = step.test != element || value == "X" || nacre::elementFromSymbol(value) != 0;
            step.words.push_back(std::move(value));
            return usable;
        });
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
        list(wanted, [&] {
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
            return true;
        });
    }

    void number(const char* wanted, std::int32_t& value, char& code) {
        const std::size_t begin = position_;
        if (text_.substr(position_, 2) == "\\-") ++position_;
        const char* end = text_.data() + text_.size();
        const auto [stop, error] = std::from_chars(text_.data() + position_, end, value);
        if (error != std::errc()) expectedAt(begin, wanted);
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
    bool afterOperator_ = false;  // an operator is open to the left of the term
    Selection result_;
};

}  // namespace

Selection parseSelection(std::string_view text) {
    // All blanks become spaces: views and lists store the text in lines.
    std::string plain(text.substr(0, kLongestText + 1));
    std::replace_if(plain.begin(), plain.end(), isBlank, ' ');
    return Parser(plain).parse();
}

}  // namespace nacre
