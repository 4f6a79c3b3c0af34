#pragma once
// Shared by the readers. Must also compile as C++17.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/error.h"

namespace nacre {

/// ASCII letters and capitals, for any locale.
inline bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
inline bool isDigit(char c) { return c >= '0' && c <= '9'; }
inline char upperCase(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }
/// isspace() of the C locale.
inline bool isBlank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
/// Removes blanks at both ends.
std::string_view trim(std::string_view text);
std::string lowerCase(std::string_view text);
std::string upperCase(std::string_view text);
bool startsWith(std::string_view text, std::string_view start);
/// Text formatted as by printf().
[[gnu::format(printf, 1, 2)]] std::string formatted(const char* format, ...);

/// The whole `text` as a number, with blanks allowed around it; empty if it is not a number. parseNumber also accepts
/// Fortran exponents ("1.0D+02", "1.0-102") and C's "nan" and "inf", which callers must check.
std::optional<std::int64_t> parseInteger(std::string_view text);
std::optional<double> parseNumber(std::string_view text);

/// A line with blanks inserted between numbers that touch, as Fortran writes them where they fill their columns: before
/// a sign that follows a digit ("-5.1E-018-5.1E-018"), and where the decimals and exponent of the last number imply the
/// ends of the others ("1.234510.2345"). An exponent may lack its letter: "1.5-100" is one number.
std::string numbersApart(std::string_view line);
/// Whether a word may be several numbers that touch.
bool mayTouch(std::string_view word);

/// Throws a reader's error. @param name  of the file @param line  1-based; 0: none
[[noreturn]] void cannotRead(const std::string& name, const std::string& why, std::uint64_t line = 0);

/// The error for an atom beyond the limit.
Error tooManyAtoms(const std::string& name, std::size_t maxAtoms);

/// Largest coordinate, Å: atoms beyond it are omitted.
constexpr double kFarthestCoordinate = 1e9;

/// Text that is safe in a message: control characters and invalid UTF-8 as \xNN, cut to about `limit` bytes.
std::string printable(std::string_view text, std::size_t limit = 48);

/// The first words of a line.
struct Words {
    std::array<std::string_view, 16> word{};
    std::size_t count = 0;  ///< at most 16
    std::string_view operator[](std::size_t i) const { return i < count ? word[i] : std::string_view(); }
};
Words splitWords(std::string_view line);
/// All words of a line.
std::vector<std::string_view> splitAllWords(std::string_view line);
/// The first words of a line, separating three numbers from word `first` on, which may touch. @param apart  holds their
/// text
Words splitWordsApart(std::string_view line, std::size_t first, std::string& apart);

/// Iterates over lines that end in '\n'.
class LineReader {
public:
    explicit LineReader(std::string_view text, std::uint64_t firstLine = 1) : rest_(text), number_(firstLine - 1) {}

    /// Steps to the next line; false at the end of the text.
    bool next();
    std::string_view line() const { return line_; }
    std::uint64_t number() const { return number_; }  ///< 1-based number of the current line
    std::string_view rest() const { return rest_; }   ///< the text after the current line

private:
    std::string_view rest_, line_;
    std::uint64_t number_;
};

/// Columns first to first + count of a fixed-column line, as far as they exist.
inline std::string_view columns(std::string_view line, std::size_t first, std::size_t count) {
    return first < line.size() ? line.substr(first, count) : std::string_view();
}

}  // namespace nacre
