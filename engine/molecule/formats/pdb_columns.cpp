// Atom lines with fields outside their columns: shifted, or separated by single blanks or tabs.
#include <algorithm>
#include <string>
#include <vector>

#include "engine/molecule/bonds/residue_templates.h"
#include "engine/molecule/element.h"
#include "engine/molecule/formats/pdb_fields.h"
#include "engine/molecule/text.h"

namespace nacre::pdb {
namespace {

std::string rightAligned(std::string_view word, std::size_t width) {
    return std::string(width - std::min(width, word.size()), ' ') + std::string(word);
}

std::string leftAligned(std::string_view word, std::size_t width) {
    return std::string(word) + std::string(width - std::min(width, word.size()), ' ');
}

/// "-12", "123B"
bool isResidueNumber(std::string_view word) {
    if (!word.empty() && isLetter(word.back())) word.remove_suffix(1);
    return parseInteger(word).has_value();
}

/// Columns 55 to 80 from the words after the coordinates: occupancy, B factor, segment, element.
std::string columnsBehind(std::string_view rest) {
    if (column(rest, 4) == '.' && column(rest, 10) == '.') return std::string(rest);
    const std::vector<std::string_view> words = splitAllWords(rest);
    std::size_t next = 0;
    std::string text;
    for (int i = 0; i < 2; ++i)
        text += rightAligned(next < words.size() && number(words[next]) ? words[next++] : std::string_view(), 6);
    const bool element = next < words.size() && elementFromSymbol(words.back()) != 0;
    const std::string_view segment = next + (element ? 1 : 0) < words.size() ? words[next] : std::string_view();
    return text + "      " + leftAligned(segment, 4) + rightAligned(element ? words.back() : std::string_view(), 2);
}

}  // namespace

bool isOutOfColumns(std::string_view line, const Coordinates& where) {
    constexpr std::size_t kNumberEnd = 26;
    if (!where.pointed || (where.usual && !isDigit(column(line, kNumberEnd + 1)))) return false;
    std::string_view head = line.substr(0, static_cast<std::size_t>(where.fields[0].data() - line.data()));
    while (!head.empty() && isBlank(head.back())) head.remove_suffix(1);
    if (head.size() > 1 && isLetter(head.back()) && isDigit(head[head.size() - 2])) head.remove_suffix(1);
    if (head.empty() || !isDigit(head.back())) return false;
    const std::size_t end = head.size();
    const bool fiveDigits = end == kNumberEnd + 1 && parseInteger(columns(line, kNumberEnd - 3, end)).has_value() &&
                            column(line, kNumberEnd - 3) != ' ';
    const bool nameTooEarly = isLetter(column(line, 12));
    return nameTooEarly || (!fiveDigits && end != kNumberEnd + pushOfSerial(line, where.shift));
}

std::optional<std::string> inColumns(std::string_view line, const Coordinates& where) {
    constexpr std::size_t kRecord = 6, kLongestName = 4, kSerial = 5;
    const std::size_t begin = static_cast<std::size_t>(where.fields[0].data() - line.data());
    const std::string_view record = trim(line.substr(0, std::min(kRecord, line.find('\t'))));
    std::vector<std::string_view> words = splitAllWords(line.substr(record.size(), begin - record.size()));
    // Serial number, name, residue, number, and a chain that may be missing, or touch its neighbours.
    if (words.size() == 4 && isLetter(words[3][0]) && isResidueNumber(words[3].substr(1))) {
        words.push_back(words[3].substr(1));
        words[3] = words[3].substr(0, 1);
    }
    if (words.size() == 4) {
        std::string_view& both = words[2];
        const bool touch = both.size() == 4 && !residueTemplate(Name(both)) && residueTemplate(Name(both.substr(0, 3)));
        const std::string_view letter = touch ? both.substr(3) : std::string_view();
        both.remove_suffix(letter.size());
        words.insert(words.begin() + 3, letter);
    }
    if (words.size() != 5 || words[1].size() > kLongestName || words[2].size() > kLongestName || words[3].size() > 2 ||
        !isResidueNumber(words[4]))
        return std::nullopt;
    const std::string_view serial = words[0], name = words[1], residue = words[2], chain = words[3];
    std::string_view digits = words[4], code;
    if (isLetter(digits.back())) {
        code = digits.substr(digits.size() - 1);
        digits.remove_suffix(1);
    }
    std::string text = leftAligned(record, kRecord);
    if (serial.size() == kSerial + 1) text.pop_back();  // it starts one column early
    text += rightAligned(serial.size() > kSerial + 1 ? std::string_view() : serial, kSerial) + ' ';
    text += leftAligned((name.size() < kLongestName ? " " : "") + std::string(name), kLongestName) + ' ';
    text += leftAligned(rightAligned(residue, 3), 4) + (chain.empty() ? ' ' : chain.back());
    text += rightAligned(digits, 4) + (digits.size() > 4 ? "" : leftAligned(code, 1)) + "   ";
    for (const std::string_view field : where.fields) text += (field.size() < 8 ? "" : " ") + rightAligned(field, 8);
    const std::string_view last = where.fields[2];
    return text + columnsBehind(line.substr(static_cast<std::size_t>(last.data() + last.size() - line.data())));
}

}  // namespace nacre::pdb
