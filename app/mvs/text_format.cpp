#include "app/mvs/text_format.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string_view>

#include "engine/molecule/text.h"

namespace nacre::app::mvs {
namespace {

[[noreturn]] void refuseFormat(const std::string& why) { throw std::invalid_argument("its text_format " + why); }

constexpr int kWidest = 100;

int smallNumber(std::string_view text, std::size_t& at, int otherwise) {
    const std::size_t start = at;
    int number = 0;
    for (; at < text.size() && text[at] >= '0' && text[at] <= '9'; ++at)
        if ((number = 10 * number + (text[at] - '0')) > kWidest) refuseFormat("has a width or precision above 100");
    return at == start ? otherwise : number;
}

std::string printed(const char* format, int precision, double value) {
    std::string text(512, '\0');
    const int size = std::snprintf(text.data(), text.size(), format, precision, value);
    text.resize(static_cast<std::size_t>(std::clamp(size, 0, 511)));
    return text;
}

std::string withCommas(std::string text) {
    const std::size_t first = text.find_first_of("0123456789");
    std::size_t end = text.find_first_not_of("0123456789", first);
    if (first == std::string::npos) return text;
    if (end == std::string::npos) end = text.size();
    for (; end > first + 3; end -= 3) text.insert(end - 3, ",");
    return text;
}

}  // namespace

TextFormat::TextFormat(const std::string& format) {
    constexpr std::size_t kLongest = 10'000;
    if (format.size() > kLongest) refuseFormat("is longer than " + std::to_string(kLongest) + " bytes");
    std::string words;
    for (std::size_t i = 0; i < format.size(); ++i) {
        const char c = format[i];
        const bool twice = i + 1 < format.size() && format[i + 1] == c;
        if ((c != '{' && c != '}') || twice) {
            words += c;
            if (c == '{' || c == '}') ++i;
            continue;
        }
        const std::size_t end = format.find_first_of("{}", i + 1);
        if (c == '}' || end == std::string::npos || format[end] == '{') refuseFormat("has a brace without another");
        const std::string field = format.substr(i + 1, end - i - 1);
        const std::size_t colon = std::min(field.find(':'), field.size());
        Part part{std::move(words), kFirst, parseStyle(field.substr(std::min(colon + 1, field.size())))};
        words.clear();
        if (colon > 0) {
            part.field = fields_.size();
            fields_.push_back(field.substr(0, colon));
        }
        parts_.push_back(std::move(part));
        i = end;
    }
    end_ = std::move(words);
}

TextFormat::Style TextFormat::parseStyle(const std::string& text) {
    constexpr std::string_view kAligns = "<>=^", kTypes = "sdfFeE%";
    Style style;
    std::size_t at = 0;
    const auto next = [&](std::string_view words) {
        return at < text.size() && words.find(text[at]) != std::string_view::npos;
    };
    const bool filled = text.size() > 1 && kAligns.find(text[1]) != std::string_view::npos;
    if (filled)
        style.fill = text[0], style.align = text[1], at = 2;
    else if (next(kAligns))
        style.align = text[at++];
    if (next("+- ")) style.sign = text[at++];
    if (next("0")) {
        if (!filled) style.fill = '0';
        if (style.align == 0) style.align = '=';
        ++at;
    }
    style.width = smallNumber(text, at, 0);
    if (next(",")) style.commas = true, ++at;
    if (next(".")) style.precision = smallNumber(text, ++at, 6);
    if (next(kTypes)) style.type = text[at++];
    if (at != text.size()) refuseFormat("has a format that is not known: '" + nacre::printable(text, 40) + "'");
    if (style.align == 0) style.align = style.type == 's' ? '<' : '>';
    return style;
}

std::string TextFormat::styled(const std::string& value, const Style& style) {
    std::string text = value;
    if (style.type != 's') {
        const auto number = parseNumber(value);
        if (!number || !std::isfinite(*number)) return value;
        if (style.type == 'd') text = printed("%.*f", 0, std::floor(*number));
        if (style.type == 'f' || style.type == 'F') text = printed("%.*f", style.precision, *number);
        if (style.type == 'e') text = printed("%.*e", style.precision, *number);
        if (style.type == 'E') text = printed("%.*E", style.precision, *number);
        if (style.type == '%') text = printed("%.*f", style.precision, 100 * *number) + '%';
        if (style.commas) text = withCommas(text);
        if (style.sign != '-' && text[0] != '-') text.insert(0, 1, style.sign);
    }
    const auto width = static_cast<std::size_t>(style.width);
    if (text.size() >= width) return text;
    const std::size_t room = width - text.size();
    if (style.align == '<') return text + std::string(room, style.fill);
    if (style.align == '^') return std::string(room / 2, style.fill) + text + std::string(room - room / 2, style.fill);
    const bool isSigned = style.align == '=' && (text[0] == '-' || text[0] == '+' || text[0] == ' ');
    return text.insert(isSigned ? 1 : 0, room, style.fill);
}

std::optional<std::string> TextFormat::of(const std::vector<std::optional<std::string>>& values,
                                          std::size_t from) const {
    std::string text;
    for (const Part& part : parts_) {
        const auto& value = values[part.field == kFirst ? 0 : from + part.field];
        if (!value) return std::nullopt;
        text += part.words + styled(*value, part.style);
    }
    return text + end_;
}

}  // namespace nacre::app::mvs
