#include "engine/molecule/floating_point.h"

#include <locale.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>
#include <string_view>
#ifdef __APPLE__
#include <xlocale.h>
#endif

namespace nacre {
namespace portable {
namespace {

bool isDigit(char c) { return c >= '0' && c <= '9'; }

/// The program may have set a locale whose numbers have a comma.
locale_t plainLocale() {
    static const locale_t only = newlocale(LC_ALL_MASK, "C", nullptr);
    return only;
}

/// Where a word ends, in small or capital letters; `first` if another stands there.
const char* afterWord(const char* first, const char* last, std::string_view word) {
    if (static_cast<std::size_t>(last - first) < word.size()) return first;
    const bool same =
        std::equal(word.begin(), word.end(), first, [](char w, char c) { return w == c || w - 'a' + 'A' == c; });
    return same ? first + word.size() : first;
}

/// "inf", "infinity", "nan", "nan(letters)".
const char* afterNoNumber(const char* first, const char* last, double& value) {
    if (const char* end = afterWord(first, last, "inf"); end != first) {
        value = std::numeric_limits<double>::infinity();
        return afterWord(end, last, "inity");
    }
    const char* end = afterWord(first, last, "nan");
    if (end == first) return first;
    value = std::numeric_limits<double>::quiet_NaN();
    if (end == last || *end != '(') return end;
    const char* close = std::find_if(end + 1, last, [](char c) {
        return !isDigit(c) && !(c >= 'a' && c <= 'z') && !(c >= 'A' && c <= 'Z') && c != '_';
    });
    return close != last && *close == ')' ? close + 1 : end;
}

struct Decimal {
    const char* end;
    bool zero;
};

/// digits [. digits] [e [sign] digits]; ends where it begins if there is no digit.
Decimal afterDecimal(const char* first, const char* last) {
    const char* at = first;
    bool any = false, zero = true;
    for (bool point = false; at != last && (isDigit(*at) || (*at == '.' && !point)); ++at) {
        point |= *at == '.';
        any |= *at != '.';
        zero &= *at == '.' || *at == '0';
    }
    if (!any) return {first, true};
    if (at == last || (*at != 'e' && *at != 'E')) return {at, zero};
    const char* digits = at + 1;
    if (digits != last && (*digits == '+' || *digits == '-')) ++digits;
    if (digits == last || !isDigit(*digits)) return {at, zero};
    return {std::find_if_not(digits, last, isDigit), zero};
}

}  // namespace

std::from_chars_result fromChars(const char* first, const char* last, double& value) {
    const bool negative = first != last && *first == '-';
    const char* const begin = first + negative;
    double magnitude = 0;
    if (const char* end = afterNoNumber(begin, last, magnitude); end != begin) {
        value = negative ? -magnitude : magnitude;
        return {end, std::errc()};
    }
    const Decimal decimal = afterDecimal(begin, last);
    if (decimal.end == begin) return {first, std::errc::invalid_argument};
    const std::string text(begin, decimal.end);
    magnitude = strtod_l(text.c_str(), nullptr, plainLocale());
    if (std::isinf(magnitude) || (magnitude == 0 && !decimal.zero))
        return {decimal.end, std::errc::result_out_of_range};
    value = negative ? -magnitude : magnitude;
    return {decimal.end, std::errc()};
}

std::to_chars_result toChars(char* first, char* last, double value) {
    std::string best;
    for (int digits = 1; digits <= std::numeric_limits<double>::max_digits10; ++digits) {
        std::array<char, 32> text{};
        const int length = std::snprintf(text.data(), text.size(), "%.*g", digits, value);
        std::replace(text.begin(), text.begin() + length, ',', '.');  // of the program's locale
        if (strtod_l(text.data(), nullptr, plainLocale()) != value && !std::isnan(value)) continue;
        const std::string_view found(text.data(), static_cast<std::size_t>(length));
        const bool plain = found.find('e') == std::string_view::npos;
        if (best.empty() || found.size() < best.size() || (plain && found.size() == best.size())) best = found;
        if (plain) break;  // "1e+01" may come before "10"
    }
    if (static_cast<std::ptrdiff_t>(best.size()) > last - first) return {last, std::errc::value_too_large};
    return {std::copy(best.begin(), best.end(), first), std::errc()};
}

}  // namespace portable

#ifdef __cpp_lib_to_chars
std::from_chars_result fromChars(const char* first, const char* last, double& value) {
    return std::from_chars(first, last, value);
}
std::to_chars_result toChars(char* first, char* last, double value) { return std::to_chars(first, last, value); }
#else
std::from_chars_result fromChars(const char* first, const char* last, double& value) {
    return portable::fromChars(first, last, value);
}
std::to_chars_result toChars(char* first, char* last, double value) { return portable::toChars(first, last, value); }
#endif

}  // namespace nacre
