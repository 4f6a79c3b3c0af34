#include "engine/molecule/text.h"

#include <cmath>

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

/// Length of the UTF-8 sequence at the front that may appear in a message; 0: none.
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

std::optional<std::int64_t> parseInteger(std::string_view text) { return parseWhole<std::int64_t>(trim(text)); }

std::optional<double> parseNumber(std::string_view text) {
    text = trim(text);
    if (const auto value = parseWhole<double>(text)) return value;
    const std::size_t exponent = text.find_first_of("dD");
    if (exponent == std::string_view::npos || text.size() > 64) return std::nullopt;
    std::string fortran(text);
    fortran[exponent] = 'e';
    return parseWhole<double>(fortran);
}

std::string numbersApart(std::string_view line) {
    std::string apart;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const bool sign = line[i] == '-' || line[i] == '+';
        if (sign && i > 0 && (isDigit(line[i - 1]) || line[i - 1] == '.')) {
            // Three digits without a point are an exponent.
            std::size_t digits = i + 1;
            while (digits < line.size() && isDigit(line[digits])) ++digits;
            const bool pointed = digits < line.size() && line[digits] == '.';
            if (pointed || digits != i + 4) apart += ' ';
        }
        apart += line[i];
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

std::vector<std::string_view> wordsOf(std::string_view line) {
    std::vector<std::string_view> words;
    for (std::string_view word = cutWord(line); !word.empty(); word = cutWord(line)) words.push_back(word);
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
