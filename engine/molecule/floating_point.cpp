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

#include "engine/molecule/text.h"

namespace nacre {
namespace portable {
namespace {

/// The program's locale may use decimal commas.
locale_t plainLocale() {
    static const locale_t only = newlocale(LC_ALL_MASK, "C", nullptr);
    return only;
}

}  // namespace

std::from_chars_result fromChars(const char* first, const char* last, double& value) {
    // strtod() also accepts blanks, a plus and hexadecimals, which are no numbers here.
    const char* const begin = first != last && *first == '-' ? first + 1 : first;
    const bool starts = begin != last && (isDigit(*begin) || *begin == '.' || isLetter(*begin));
    const bool hexadecimal = last - begin > 1 && begin[0] == '0' && (begin[1] | 0x20) == 'x';
    const std::string text(begin, hexadecimal ? begin + 1 : last);
    char* stop = nullptr;
    const double magnitude = starts ? strtod_l(text.c_str(), &stop, plainLocale()) : 0;
    if (!starts || stop == text.c_str()) return {first, std::errc::invalid_argument};
    const char* const end = begin + (stop - text.c_str());
    const char* const mantissaEnd = std::find_if(begin, end, [](char c) { return (c | 0x20) == 'e'; });
    const bool zero = std::none_of(begin, mantissaEnd, [](char c) { return c >= '1' && c <= '9'; });
    if (!isLetter(*begin) && (std::isinf(magnitude) || (magnitude == 0 && !zero)))
        return {end, std::errc::result_out_of_range};
    value = first != begin ? -magnitude : magnitude;
    return {end, std::errc()};
}

std::to_chars_result toChars(char* first, char* last, double value) {
    std::string best;
    for (int digits = 1; digits <= std::numeric_limits<double>::max_digits10; ++digits) {
        std::array<char, 32> text{};
        const int length = std::snprintf(text.data(), text.size(), "%.*g", digits, value);
        std::replace(text.begin(), text.begin() + length, ',', '.');  // in the program's locale
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
