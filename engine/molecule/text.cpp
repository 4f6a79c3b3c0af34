#include "engine/molecule/text.h"

#include <cmath>
#include <cstdarg>
#include <cstdio>

#include "engine/molecule/floating_point.h"
#include "engine/molecule/read.h"

namespace nacre {

namespace {

template <typename Number>
std::optional<Number> parseWhole(std::string_view text) {
    if (!text.empty() && text.front() == '+') {
        text.remove_prefix(1);
        if (!text.empty() && text.front() == '-') return std::nullopt;
    }
    Number value{};
    const auto [end, fault] = fromChars(text.data(), text.data() + text.size(), value);
    if (fault == std::errc::result_out_of_range && std::is_floating_point_v<Number>) return Number(HUGE_VAL);
    if (fault != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return value;
}

/// Length of the UTF-8 sequence at the front if it may appear in a message, else 0.
std::size_t printableSequence(std::string_view text) {
    const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
    const auto follows = [&](std::size_t i) { return (byte(i) & 0xC0u) == 0x80u; };
    const unsigned lead = byte(0);
    if (lead >= 0x20 && lead < 0x7F) return 1;
    if (lead == 0xC2 && byte(1) < 0xA0) return 0;  // C1 control characters
    if (lead >= 0xC2 && lead < 0xE0 && follows(1)) return 2;
    if (lead == 0xE2 && (byte(1) == 0x80 || byte(1) == 0x81)) return 0;  // line separators, marks of direction
    const bool three = lead >= 0xE0 && lead < 0xF0 && follows(1) && follows(2);
    if (three && !(lead == 0xE0 && byte(1) < 0xA0) && !(lead == 0xED && byte(1) >= 0xA0)) return 3;
    const bool four = lead >= 0xF0 && lead < 0xF5 && follows(1) && follows(2) && follows(3);
    if (four && !(lead == 0xF0 && byte(1) < 0x90) && !(lead == 0xF4 && byte(1) >= 0x90)) return 4;
    return 0;
}

}  // namespace

std::string_view trim(std::string_view text) {
    while (!text.empty() && isBlank(text.front())) text.remove_prefix(1);
    while (!text.empty() && isBlank(text.back())) text.remove_suffix(1);
    return text;
}

std::string lowerCase(std::string_view text) {
    std::string lower(text);
    for (char& c : lower)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return lower;
}

std::string upperCase(std::string_view text) {
    std::string upper(text);
    for (char& c : upper) c = upperCase(c);
    return upper;
}

bool startsWith(std::string_view text, std::string_view start) { return text.substr(0, start.size()) == start; }

std::string formatted(const char* format, ...) {
    std::va_list values, measured;
    va_start(values, format);
    va_copy(measured, values);
    std::string text(static_cast<std::size_t>(std::vsnprintf(nullptr, 0, format, measured)), '\0');
    va_end(measured);
    std::vsnprintf(text.data(), text.size() + 1, format, values);
    va_end(values);
    return text;
}

std::optional<std::int64_t> parseInteger(std::string_view text) { return parseWhole<std::int64_t>(trim(text)); }

namespace {

/// Whether a sign begins an exponent of three digits without its letter: "1.5-100".
bool isExponent(std::string_view number, std::size_t sign) {
    constexpr std::size_t kDigits = 3;
    return sign != std::string_view::npos && number.size() == sign + 1 + kDigits && isDigit(number[sign - 1]) &&
           number.substr(0, sign).find('.') != std::string_view::npos &&
           number.find_first_not_of("0123456789", sign + 1) == std::string_view::npos;
}

}  // namespace

std::optional<double> parseNumber(std::string_view text) {
    text = trim(text);
    if (const auto value = parseWhole<double>(text)) return value;
    if (text.size() > 64) return std::nullopt;
    std::string fortran(text);
    if (const std::size_t letter = text.find_first_of("dD"); letter != std::string_view::npos)
        fortran[letter] = 'e';
    else if (const std::size_t sign = text.find_first_of("+-", 1); isExponent(text, sign))
        fortran.insert(sign, 1, 'e');
    else
        return std::nullopt;
    return parseWhole<double>(fortran);
}

namespace {

constexpr std::string_view kOfNumbers = "0123456789.+-eEdD";

/// Digits after the last decimal point, and the exponent: all numbers of a line have the same.
struct NumberTail {
    std::size_t decimals = 0, size = 0;

    explicit NumberTail(std::string_view word) {
        const std::string_view tail = word.substr(word.find_last_of('.') + 1);
        while (decimals < tail.size() && isDigit(tail[decimals])) ++decimals;
        size = tail.size();
    }
    /// @param rest  text after a decimal point
    bool fits(std::string_view rest) const {
        if (rest.size() < size) return false;
        for (std::size_t i = 0; i < size; ++i) {
            const bool sign = i == decimals + 1 && (rest[i] == '-' || rest[i] == '+');
            if (i == decimals ? !isLetter(rest[i]) : !sign && !isDigit(rest[i])) return false;
        }
        return true;
    }
};

/// Divides a word of numbers without signs between them; returns the word itself if their ends are uncertain.
std::string cutByDecimals(std::string_view word) {
    const NumberTail tail(word);
    std::string apart;
    for (std::size_t begin = 0; begin < word.size();) {
        const std::size_t point = word.find('.', begin);
        const bool led = point != std::string_view::npos && point > begin && isDigit(word[point - 1]);
        if (!led || !tail.fits(word.substr(point + 1))) return std::string(word);
        const std::size_t end = point + 1 + tail.size;
        apart.append(begin > 0 ? " " : "").append(word.substr(begin, end - begin));
        begin = end;
    }
    return apart;
}

/// Inserts blanks in a word of numbers before signs that follow a digit.
std::string cutBySigns(std::string_view word) {
    std::string apart;
    for (std::size_t i = 0; i < word.size(); ++i) {
        const bool sign = word[i] == '-' || word[i] == '+';
        if (sign && i > 0 && (isDigit(word[i - 1]) || word[i - 1] == '.')) {
            // Three digits without a point are an exponent.
            std::size_t digits = i + 1;
            while (digits < word.size() && isDigit(word[digits])) ++digits;
            const bool pointed = digits < word.size() && word[digits] == '.';
            if (pointed || digits != i + 4) apart += ' ';
        }
        apart += word[i];
    }
    return apart;
}

bool hasTwoPoints(std::string_view word) { return word.find('.') != word.rfind('.'); }

}  // namespace

bool mayTouch(std::string_view word) {
    const std::size_t point = word.find('.');
    if (point == std::string_view::npos) return false;
    for (std::size_t i = point + 1; i < word.size(); ++i) {
        const bool sign = word[i] == '-' || word[i] == '+';
        if (word[i] == '.' || (sign && (isDigit(word[i - 1]) || word[i - 1] == '.'))) return true;
    }
    return false;
}

std::string numbersApart(std::string_view line) {
    std::string apart;
    while (!line.empty()) {
        std::size_t length = 0;
        while (length < line.size() && !isBlank(line[length])) ++length;
        const std::string_view word = line.substr(0, length);
        if (!mayTouch(word) || word.find_first_not_of(kOfNumbers) != std::string_view::npos) {
            apart += word;
        } else {
            const std::string signs = cutBySigns(word);
            for (std::string_view rest = signs; !rest.empty();) {
                const std::string_view number = rest.substr(0, rest.find(' '));
                apart += hasTwoPoints(number) ? cutByDecimals(number) : std::string(number);
                rest.remove_prefix(number.size());
                if (!rest.empty()) rest.remove_prefix(1), apart += ' ';
            }
        }
        line.remove_prefix(length);
        for (; !line.empty() && isBlank(line.front()); line.remove_prefix(1)) apart += line.front();
    }
    return apart;
}

void cannotRead(const std::string& name, const std::string& why, std::uint64_t line) {
    throw Error("cannot read molecule", name, why, line > 0 ? std::optional<std::uint64_t>(line) : std::nullopt);
}

Error tooManyAtoms(const std::string& name, std::size_t maxAtoms) {
    const char* why = maxAtoms < kMaxAtoms ? ", the most that the memory limit allows" : "";
    return {"cannot read molecule", name, "more than " + std::to_string(maxAtoms) + " atoms" + why};
}

std::string printable(std::string_view text, std::size_t limit) {
    static const char* const kDigits = "0123456789abcdef";
    std::string safe;
    while (!text.empty()) {
        if (safe.size() >= limit) return safe + "...";
        std::size_t length = printableSequence(text);
        if (length > 0) {
            safe += text.substr(0, length);
        } else {
            const auto byte = static_cast<unsigned char>(text.front());
            safe += "\\x";
            safe += kDigits[byte >> 4];
            safe += kDigits[byte & 15];
            length = 1;
        }
        text.remove_prefix(length);
    }
    return safe;
}

namespace {

/// Cuts the first word off; empty at the end of the line.
std::string_view cutWord(std::string_view& line) {
    while (!line.empty() && isBlank(line.front())) line.remove_prefix(1);
    std::size_t length = 0;
    while (length < line.size() && !isBlank(line[length])) ++length;
    const std::string_view word = line.substr(0, length);
    line.remove_prefix(length);
    return word;
}

}  // namespace

Words splitWords(std::string_view line) {
    Words words;
    while (words.count < words.word.size()) {
        const std::string_view word = cutWord(line);
        if (word.empty()) break;
        words.word[words.count++] = word;
    }
    return words;
}

std::vector<std::string_view> splitAllWords(std::string_view line) {
    std::vector<std::string_view> words;
    for (std::string_view word = cutWord(line); !word.empty(); word = cutWord(line)) words.push_back(word);
    return words;
}

Words splitWordsApart(std::string_view line, std::size_t first, std::string& apart) {
    Words words = splitWords(line);
    for (std::size_t i = first; i < first + 3; ++i) {
        if (!mayTouch(words[i])) continue;
        apart = numbersApart(line);
        return splitWords(apart);
    }
    return words;
}

bool LineReader::next() {
    if (rest_.empty()) return false;
    const std::size_t end = rest_.find('\n');
    line_ = rest_.substr(0, end);
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    ++number_;
    return true;
}

}  // namespace nacre
