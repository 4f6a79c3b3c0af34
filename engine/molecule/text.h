#pragma once
// What the readers share. Must also compile as C++17.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "engine/error.h"

namespace nacre {

/// Letters and capitals of ASCII, whatever the locale.
inline bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
inline bool isDigit(char c) { return c >= '0' && c <= '9'; }
inline char upperCase(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }
/// Whether isspace() of the C locale holds.
inline bool isBlank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
/// Without blanks at both ends.
std::string_view trim(std::string_view text);
std::string lowerCase(std::string_view text);
std::string upperCase(std::string_view text);
bool startsWith(std::string_view text, std::string_view start);

/// The whole of `text` as a number, blanks around it allowed; empty if it is none. parseNumber also takes Fortran's
/// exponents ("1.0D+02") and what C calls "nan" and "inf": the caller judges.
std::optional<std::int64_t> parseInteger(std::string_view text);
std::optional<double> parseNumber(std::string_view text);

/// Throws the error of every reader. @param name  of the file @param line  1-based; 0 if there is none
[[noreturn]] void cannotRead(const std::string& name, const std::string& why, std::uint64_t line = 0);

/// What a reader throws at the atom after the last that there is room for.
Error tooManyAtoms(const std::string& name, std::size_t maxAtoms);

/// What an atom may stand from the origin along an axis, Å: every reader refuses more.
constexpr double kFarthestCoordinate = 1e9;

/// A coordinate in Å. @throws Error with the line unless it is a number within ±kFarthestCoordinate.
/// @param axis  'x', 'y' or 'z', for the message
/// @param line  0 if there is none
/// @param scale Å in the file's unit
float parseCoordinate(std::string_view text, char axis, const std::string& name, std::uint64_t line, double scale = 1);

/// Text that is safe in a message: control characters and what is not UTF-8 as \xNN, cut to about `limit` bytes.
std::string printable(std::string_view text, std::size_t limit = 48);

/// The first words of a line.
struct Words {
    std::array<std::string_view, 16> word{};
    std::size_t count = 0;  ///< at most 16
    std::string_view operator[](std::size_t i) const { return i < count ? word[i] : std::string_view(); }
};
Words splitWords(std::string_view line);

/// Walks through lines that end in '\n'.
class LineReader {
public:
    explicit LineReader(std::string_view text, std::uint64_t firstLine = 1) : rest_(text), number_(firstLine - 1) {}

    /// Steps to the next line; false at the end of the text.
    bool next();
    std::string_view line() const { return line_; }
    std::uint64_t number() const { return number_; }  ///< 1-based number of the current line
    std::string_view rest() const { return rest_; }   ///< what follows the current line

private:
    std::string_view rest_, line_;
    std::uint64_t number_;
};

/// Columns first to first + count of a fixed-column line, as far as they exist.
inline std::string_view columns(std::string_view line, std::size_t first, std::size_t count) {
    return first < line.size() ? line.substr(first, count) : std::string_view();
}

}  // namespace nacre
