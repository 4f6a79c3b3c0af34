#include "engine/molecule/formats/pdb_fields.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "engine/molecule/bonds/residue_templates.h"
#include "engine/molecule/element.h"
#include "engine/molecule/floating_point.h"
#include "engine/molecule/text.h"

namespace nacre::pdb {
namespace {

bool isSpaceOrNul(char c) { return c == ' ' || c == '\0' || c == '\t'; }
/// Plain decimals of the width that PDB columns have, several times faster than the general conversion. Mantissa and
/// power of ten are exact in double, so the quotient is correctly rounded.
std::optional<double> shortDecimal(std::string_view text) {
    constexpr double kPowers[] = {1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12};
    if (text.size() > 12) return std::nullopt;
    std::size_t i = text.front() == '-' || text.front() == '+' ? 1 : 0;
    std::int64_t mantissa = 0;
    std::size_t digits = 0;
    std::size_t decimals = 0;
    bool point = false;
    for (; i < text.size(); ++i) {
        if (isDigit(text[i])) {
            mantissa = mantissa * 10 + (text[i] - '0');
            ++digits;
            if (point) ++decimals;
        } else if (text[i] == '.' && !point) {
            point = true;
        } else {
            return std::nullopt;
        }
    }
    if (digits == 0) return std::nullopt;
    const double value = static_cast<double>(mantissa) / kPowers[decimals];
    return text.front() == '-' ? -value : value;
}

std::optional<std::int64_t> decimal(std::string_view text) {
    if (text.size() > 1 && text[0] == '+' && isDigit(text[1])) text.remove_prefix(1);
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return value;
}

std::optional<std::int64_t> hybrid36(std::string_view text, std::size_t width) {
    if (text.size() != width || !isLetter(text.front())) return std::nullopt;
    const bool lower = text.front() >= 'a';
    std::int64_t value = 0;
    std::int64_t firstLetterPower = 1;  // 36^(width - 1)
    std::int64_t decimals = 10;         // 10^width
    for (std::size_t i = 1; i < width; ++i) {
        firstLetterPower *= 36;
        decimals *= 10;
    }
    for (const char c : text) {
        const bool fits = isDigit(c) || (lower ? c >= 'a' && c <= 'z' : c >= 'A' && c <= 'Z');
        if (!fits) return std::nullopt;
        value = value * 36 + (isDigit(c) ? c - '0' : upperCase(c) - 'A' + 10);
    }
    return value - 10 * firstLetterPower + decimals + (lower ? 26 * firstLetterPower : 0);
}

/// Element of a one-letter symbol, or unknown if there is none.
Element oneLetter(char c) { return isLetter(c) ? elementFromSymbol(std::string_view(&c, 1)) : Element{0}; }

/// In standard residues, atom names start with the element in any column; only selenium has two letters.
Element inStandardResidue(std::string_view name) {
    const std::size_t first = name.find_first_not_of("0123456789");
    if (first == std::string_view::npos) return 0;
    if (upperCase(name[first]) == 'S' && name.size() > first + 1 && upperCase(name[first + 1]) == 'E')
        return elementFromSymbol("SE");
    return oneLetter(name[first]);
}

/// Whole names that are unambiguous in any column.
bool isPlainSymbol(std::string_view name) {
    for (const char* symbol : {"SI", "CL", "BR", "FE", "MG", "ZN", "MN", "LI", "AL"})
        if (name.size() == 2 && upperCase(name[0]) == symbol[0] && upperCase(name[1]) == symbol[1]) return true;
    return false;
}

/// Element of an ion's name in capitals, without sign and numbers; some have special names in programs.
Element findIon(std::string_view name) {
    struct Ion {
        std::string_view name, symbol;
    };
    static constexpr Ion kIons[] = {{"SOD", "NA"}, {"POT", "K"},  {"CLA", "CL"}, {"CAL", "CA"}, {"CES", "CS"},
                                    {"LIT", "LI"}, {"RUB", "RB"}, {"BAR", "BA"}, {"CIP", "NA"}, {"CIM", "CL"},
                                    {"IP", "NA"},  {"IM", "CL"},  {"IOD", "I"}};
    for (const Ion& ion : kIons)
        if (name == ion.name) return elementFromSymbol(ion.symbol);
    return elementFromSymbol(name);
}

/// A name in capitals, without signs and numbers at both ends: "Mg+2" and "MG2" are "MG".
std::string bareName(std::string_view name) {
    constexpr std::string_view kBeside = "0123456789+-";
    const std::size_t first = std::min(name.find_first_not_of(kBeside), name.size());
    return upperCase(name.substr(first, name.find_last_not_of(kBeside) + 1 - first));
}

/// Whether names indicate an ion: by a sign, or by a residue of the same name or called ION.
bool isNamedAsIon(std::string_view name, const std::string& bare, const Name& residueName) {
    return name.find_first_of("+-") != std::string_view::npos || bare == bareName(residueName.view()) ||
           startsWith(residueName.view(), "ION");
}

/// Columns 13-14 hold the symbol, right-justified; names of four characters have no room for that, so that theirs may
/// have one letter.
Element byNameColumns(std::string_view field) {
    const std::string_view name = trim(field);
    if (isPlainSymbol(name)) return elementFromSymbol(name);
    const bool mixedCase = name.size() > 1 && name[0] >= 'A' && name[0] <= 'Z' && name[1] >= 'a' && name[1] <= 'z';
    if (const Element two = mixedCase ? elementFromSymbol(name.substr(0, 2)) : Element{0}) return two;
    const char first = column(field, 1);
    const char second = column(field, 2);
    if (isSpaceOrNul(first) || isDigit(first)) return oneLetter(second);
    if (!isLetter(first)) return oneLetter(second);
    const Element two = isLetter(second) ? elementFromSymbol(field.substr(0, 2)) : Element{0};
    const bool full = !isSpaceOrNul(column(field, 3)) && !isSpaceOrNul(column(field, 4));
    const char letter = upperCase(first);
    const bool organic = letter == 'H' || letter == 'D' || letter == 'C' || letter == 'N' || letter == 'O';
    const bool chlorine = letter == 'C' && upperCase(second) == 'L';
    if (two != 0 && !(full && organic && !chlorine)) return two;
    return oneLetter(first);
}

}  // namespace

std::string_view trim(std::string_view field) {
    while (!field.empty() && isSpaceOrNul(field.front())) field.remove_prefix(1);
    while (!field.empty() && isSpaceOrNul(field.back())) field.remove_suffix(1);
    return field;
}

std::optional<double> number(std::string_view field) {
    field = trim(field);
    if (field.empty()) return std::nullopt;
    if (const auto value = shortDecimal(field)) return value;
    double value = 0;
    const auto [end, error] = fromChars(field.data(), field.data() + field.size(), value);
    if (error != std::errc() || end != field.data() + field.size() || !std::isfinite(value)) return std::nullopt;
    return value;
}

std::optional<std::int64_t> integer(std::string_view field, std::size_t width) {
    field = trim(field);
    if (const auto value = decimal(field)) return value;
    return field.empty() ? std::nullopt : hybrid36(field, width);
}

namespace {

/// Columns that a serial number extends beyond its own: 2 for "ATOM  1000000".
std::size_t overflowOfSerial(std::string_view line) {
    constexpr std::size_t kEnd = 11, kMost = 4;
    if (!isDigit(column(line, 7)) || isDigit(column(line, 6))) return 0;
    std::size_t extra = 0;
    while (extra < kMost && isDigit(column(line, kEnd + extra + 1))) ++extra;
    return isDigit(column(line, kEnd)) ? extra : 0;
}

}  // namespace

std::optional<std::int64_t> serial(std::string_view line) {
    // "ATOM 1000000" starts early, "ATOM  100000" ends late. A name of four characters may begin with a digit.
    const std::size_t first = isDigit(column(line, 6)) ? 6 : 7;
    std::size_t extra = overflowOfSerial(line);
    if (extra > 1 && pushOfSerial(line, extra) < extra) extra = 1;
    return integer(columns(line, first, first == 6 && isDigit(column(line, 12)) ? 12 : 11 + extra), 5);
}

std::size_t pushOfSerial(std::string_view line, std::size_t shift) {
    constexpr std::size_t kChain = 22, kNumber = 23, kNumberEnd = 26;
    const std::size_t extra = std::min(overflowOfSerial(line), shift);
    // The residue's number ends where the shift puts it; without a shift it would begin in the chain's column.
    for (std::size_t push = extra; push > 0; --push) {
        const bool ends = isDigit(column(line, kNumberEnd + push)) && !isDigit(column(line, kNumberEnd + push + 1));
        const bool begins = !isDigit(column(line, kChain + push)) || column(line, kNumber + push) == ' ';
        if (ends && begins) return push;
    }
    return 0;
}

Coordinates coordinates(std::string_view line) {
    const bool usual =
        column(line, 35) == '.' && column(line, 43) == '.' && column(line, 51) == '.' && column(line, 30) == ' ';
    const Coordinates columned{{columns(line, 31, 38), columns(line, 39, 46), columns(line, 47, 54)}, 0, usual, usual};
    if (usual) return columned;
    constexpr std::size_t kUsualDecimals = 3, kUsualEnd = 54;
    Coordinates found;
    bool touch = false;
    std::size_t at = 26;  // after the residue's number, which may be too long, or shifted to the right
    // Single blanks or tabs separate the fields.
    if (const std::size_t point = line.find('.', 12); point < 30) at = line.find_last_of(" \t", point) + 1;
    const auto skipDigits = [&] {
        while (at < line.size() && isDigit(line[at])) ++at;
    };
    const auto skipBlanks = [&] {
        while (at < line.size() && isSpaceOrNul(line[at])) ++at;
    };
    if (overflowOfSerial(line) > 0 && !isDigit(column(line, 26))) skipBlanks();
    const std::size_t number = at;
    if (isDigit(column(line, 26)) || number > 26 || isDigit(column(line, 27))) skipDigits();
    if (at < line.size() && line[at] == '.') at = number;  // it is a coordinate
    if (at < line.size() && isLetter(line[at])) ++at;      // an insertion code
    for (std::string_view& field : found.fields) {
        skipBlanks();
        const std::size_t begin = at;
        if (at < line.size() && (line[at] == '-' || line[at] == '+')) ++at;
        skipDigits();
        if (at >= line.size() || line[at] != '.') return columned;
        const std::size_t point = at++;
        skipDigits();
        // Two numbers without a blank between them.
        if (at < line.size() && line[at] == '.') at = std::min(point + 1 + kUsualDecimals, at), touch = true;
        field = line.substr(begin, at - begin);
    }
    // Programs that truncate wide numbers to eight characters keep the columns.
    const auto isCut = [](std::string_view field) {
        return pdb::number(field) && field.find('.') != std::string_view::npos;
    };
    if (touch && at == kUsualEnd && column(line, 30) == ' ' && std::ranges::all_of(columned.fields, isCut))
        return columned;
    found.shift = at > kUsualEnd ? at - kUsualEnd : 0;
    return found;
}

std::string_view segment(std::string_view line) {
    const std::string_view number = trim(columns(line, 77, 80));
    const bool numbered = !number.empty() && number.find_first_not_of("0123456789") == std::string_view::npos;
    return numbered ? std::string_view() : trim(columns(line, 73, 76));
}

Element statedElement(std::string_view line) {
    // Old files have the entry's code and a line number in columns 73-80; digits there are not a symbol.
    const std::string_view symbol = trim(columns(line, 77, 78));
    return symbol.empty() ? Element{0} : elementFromSymbol(symbol);
}

Element elementByName(std::string_view field, const Name& residueName) {
    if (residueTemplate(residueName)) return inStandardResidue(trim(field));
    return byNameColumns(field);
}

Element elementByLooseName(std::string_view name, const Name& residueName) {
    if (residueTemplate(residueName)) return inStandardResidue(name);
    const std::string bare = bareName(name);
    if (isNamedAsIon(name, bare, residueName))
        if (const Element ion = findIon(bare)) return ion;
    const std::string_view letters = name.substr(0, name.find_last_not_of("0123456789+-") + 1);
    if (isPlainSymbol(letters)) return elementFromSymbol(letters);
    return byNameColumns(name.size() < 4 ? " " + std::string(name) : std::string(name));
}

Element elementOfIon(const Name& name, const Name& residueName, Element stated) {
    const std::string_view written = name.view();
    if (written.empty() || residueTemplate(residueName)) return 0;
    const std::string bare = bareName(written);
    if (bare.empty()) return 0;
    const bool ofPrograms = bare.size() == 3;  // programs' symbols of three letters are in no other table
    const Element ion = ofPrograms || isNamedAsIon(written, bare, residueName) ? findIon(bare) : Element{0};
    const bool unknown = stated == 0 || stated == oneLetter(bare.front());
    return unknown ? ion : stated;
}

Element elementByAutoDockType(std::string_view type) {
    struct Type {
        std::string_view type, symbol;
    };
    // AutoDock 4 types that are no symbols: aromatic carbon, polar hydrogen, acceptors, the carbons that close rings,
    // and the water of hydrated docking.
    static constexpr Type kTypes[] = {{"A", "C"},  {"HD", "H"}, {"HS", "H"}, {"NA", "N"}, {"NS", "N"},
                                      {"OA", "O"}, {"OS", "O"}, {"SA", "S"}, {"Z", "C"},  {"G", "C"},
                                      {"GA", "C"}, {"J", "C"},  {"Q", "C"},  {"W", "O"}};
    type = trim(type);
    for (const Type& known : kTypes)
        if (type == known.type) return elementFromSymbol(known.symbol);
    if (type.size() == 3 && startsWith(type, "CG") && isDigit(type[2])) type = "C";  // Meeko: where a ring is broken
    return elementFromSymbol(type);
}

bool isAutoDockGlue(std::string_view type) {
    type = trim(type);
    return type.size() == 2 && type[0] == 'G' && isDigit(type[1]);
}

std::int8_t charge(std::string_view line) {
    const char a = column(line, 79);
    const char b = column(line, 80);
    const bool digitFirst = isDigit(a) && (b == '+' || b == '-');
    const bool signFirst = isDigit(b) && (a == '+' || a == '-');
    if (!digitFirst && !signFirst) return 0;
    const int size = (digitFirst ? a : b) - '0';
    return static_cast<std::int8_t>((digitFirst ? b : a) == '-' ? -size : size);
}

}  // namespace nacre::pdb
