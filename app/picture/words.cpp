#include "app/picture/words.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "app/picture/color_values.h"
#include "app/picture/label_fields.h"
#include "app/picture/option_text.h"
#include "app/picture/option_values.h"
#include "engine/error.h"

namespace nacre::app {
namespace {

constexpr std::string_view kFrameField = "{frame}", kTimeField = "{time}";

/// The text without its fields, to check its markup.
void checkMarkup(std::string_view text) {
    std::string plain;
    eachPiece(
        text, [&](std::string_view piece) { plain += piece; }, [&](const LabelField&) { plain += 'x'; });
    parseMarkup(plain);
}

}  // namespace

Label parseLabel(std::string_view text) {
    std::optional<Error> first;
    for (std::size_t sign = text.find('='); sign != std::string_view::npos; sign = text.find('=', sign + 1)) {
        Label label;
        try {
            label.selection = parseSelection(text.substr(0, sign));
        } catch (const Error& error) {
            if (!first) first = error;
            continue;  // the '=' may belong to the selection
        }
        label.text = text.substr(sign + 1);
        if (label.text.empty()) throw std::invalid_argument("there is no text behind '" + label.selection.text + "='");
        checkMarkup(label.text);
        return label;
    }
    if (first) throw *first;
    throw std::invalid_argument("expected SELECTION=TEXT, not '" + std::string(text) + "'");
}

std::string labelText(const Label& label) { return label.selection.text + "=" + label.text; }

namespace {

/// The text before and after the last '='.
std::pair<std::string_view, std::string_view> ruleParts(std::string_view text, const char* wanted) {
    const std::size_t sign = text.rfind('=');
    if (sign == std::string_view::npos)
        throw std::invalid_argument(std::string("expected ") + wanted + ", not '" + std::string(text) + "'");
    return {text.substr(0, sign), text.substr(sign + 1)};
}

}  // namespace

LabelColor parseLabelColor(std::string_view text) {
    const auto [selection, color] = ruleParts(text, "SELECTION=COLOR");
    return {parseSelection(selection), parseInk(color)};
}

LabelOffset parseLabelOffset(std::string_view text) {
    constexpr double kFarthest = 200;  // em
    const auto [selection, offset] = ruleParts(text, "SELECTION=X,Y");
    const std::size_t comma = offset.find(',');
    if (comma == std::string_view::npos)
        throw std::invalid_argument("expected SELECTION=X,Y, not '" + std::string(text) + "'");
    return {parseSelection(selection), parseNumber(offset.substr(0, comma), -kFarthest, kFarthest),
            parseNumber(offset.substr(comma + 1), -kFarthest, kFarthest)};
}

Measure parseMeasure(std::string_view text) {
    Measure measure;
    measure.text = text;
    std::size_t from = 0;
    int depth = 0;
    char quote = '\0';
    const auto add = [&](std::size_t to) {
        std::string part(text.substr(from, to - from));
        const bool number = !part.empty() && std::ranges::all_of(part, [](char c) { return c >= '0' && c <= '9'; });
        measure.points.push_back(parseSelection(number ? "id " + part : part));
        from = to + 1;
    };
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (quote != '\0') {
            if (c == quote) quote = '\0';
        } else if (c == '"' || (c == '\'' && (i == 0 || text[i - 1] == ' '))) {
            quote = c;
        } else if (c == '(' || c == ')') {
            depth += c == '(' ? 1 : -1;
        } else if (c == ',' && depth == 0) {
            add(i);
        }
    }
    add(text.size());
    if (measure.points.size() < 2 || measure.points.size() > 4)
        throw std::invalid_argument(
            "expected two atoms for a distance, three for an angle or four for a torsion, separated by commas, not '" +
            std::string(text) + "'");
    return measure;
}

ScaleBar parseScaleBar(std::string_view text) {
    if (text == "A" || text == "Å" || text == "on") return ScaleBar::angstrom;
    return static_cast<ScaleBar>(parseChoice(text, {"off", "angstrom", "nm"}));
}

const char* scaleBarText(ScaleBar bar) {
    return bar == ScaleBar::off ? "off" : bar == ScaleBar::angstrom ? "angstrom" : "nm";
}

std::string parseTitle(std::string_view text) {
    parseMarkup(filledTitle(std::string(text), {}));
    return std::string(text);
}

std::string filledTitle(const std::string& title, const Moment& moment) {
    std::string time = "?";
    if (moment.picoseconds) {
        constexpr double kNanosecond = 1000;  // ps
        const bool nano = std::abs(*moment.picoseconds) >= kNanosecond;
        time = numberText(std::round(*moment.picoseconds / (nano ? kNanosecond : 1) * 1000) / 1000) +
               (nano ? " ns" : " ps");
    }
    std::string filled = title;
    for (const auto& [field, value] : {std::pair(kFrameField, std::to_string(moment.frame)), {kTimeField, time}})
        for (std::size_t at = 0; (at = filled.find(field, at)) != std::string::npos; at += value.size())
            filled.replace(at, field.size(), value);
    return filled;
}

bool titleMoves(const std::string& title) {
    return title.find(kFrameField) != std::string::npos || title.find(kTimeField) != std::string::npos;
}

std::array<float, 3> parseInk(std::string_view text) {
    const std::array<float, 4> color = parseColor(text);
    if (color[3] < 1) throw std::invalid_argument("text cannot be transparent: '" + std::string(text) + "'");
    return {color[0], color[1], color[2]};
}

}  // namespace nacre::app
