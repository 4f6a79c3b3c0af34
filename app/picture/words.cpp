#include "app/picture/words.h"

#include <algorithm>
#include <stdexcept>

#include "app/picture/appearance_values.h"
#include "app/picture/label_fields.h"
#include "app/picture/option_values.h"
#include "engine/error.h"

namespace nacre::app {
namespace {

/// The text without its fields, to check its markup.
void checkMarkup(std::string_view text) {
    std::string plain;
    eachPiece(
        text, [&](std::string_view piece) { plain += piece; }, [&](const LabelField&) { plain += 'x'; });
    runsOf(plain);
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
            continue;  // perhaps the sign belongs to the selection
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

Measure parseMeasure(std::string_view text) {
    Measure measure;
    measure.text = text;
    std::size_t from = 0;
    int depth = 0;
    char quote = '\0';
    const auto add = [&](std::size_t to) {
        std::string part(text.substr(from, to - from));
        const bool number =
            !part.empty() && std::all_of(part.begin(), part.end(), [](char c) { return c >= '0' && c <= '9'; });
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
    runsOf(text);
    return std::string(text);
}

std::array<float, 3> parseInk(std::string_view text) {
    const std::array<float, 4> color = parseColor(text);
    if (color[3] < 1) throw std::invalid_argument("text cannot be transparent: '" + std::string(text) + "'");
    return {color[0], color[1], color[2]};
}

}  // namespace nacre::app
