#include "app/mvs/value_palette.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>

#include "app/mvs/scene_parts.h"
#include "engine/molecule/floating_point.h"
#include "engine/molecule/text.h"

namespace nacre::app::mvs {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

[[noreturn]] void refusePalette(const std::string& why) { throw std::invalid_argument("its palette " + why); }

const Json* findField(const Json& palette, const char* name) {
    const auto found = palette.find(name);
    return found == palette.end() || found->is_null() ? nullptr : &*found;
}
bool isSet(const Json& palette, const char* name) {
    const Json* value = findField(palette, name);
    return value && value->is_boolean() && value->get<bool>();
}
std::string readWord(const Json& palette, const char* name, const char* otherwise) {
    const Json* value = findField(palette, name);
    return value && value->is_string() ? value->get<std::string>() : otherwise;
}

/// The number at the start of a text.
std::optional<double> leadingNumber(const std::string& text) {
    const std::size_t start = text.find_first_not_of(" \t+");
    double value = 0;
    if (start == std::string::npos) return std::nullopt;
    const auto read = fromChars(text.data() + start, text.data() + text.size(), value);
    return read.ec == std::errc() && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

double readBound(const Json& value, double otherwise) {
    if (value.is_null()) return otherwise;
    if (!value.is_number()) refusePalette("has a checkpoint that is no number");
    return value.get<double>();
}

std::uint32_t colorInPalette(const Json& value) {
    const auto color = readColor(&value);
    if (!color) refusePalette("names a colour that is none: " + nacre::printable(value.dump(-1, ' ', true), 40));
    return *color;
}

/// A colour with its range or checkpoint.
struct Step {
    std::optional<std::uint32_t> color;
    double from = 0, to = 0;
};

/// The steps of a list. @param each  numbers given with each colour; 0: only colours
std::vector<Step> listedSteps(const Json& palette, std::size_t& each) {
    const Json* list = findField(palette, "colors");
    const std::string name = list && list->is_string() ? list->get<std::string>() : list ? "" : "YlGn";
    std::vector<Step> steps;
    each = 0;
    if (!name.empty()) {
        for (const std::uint32_t color : namedColorList(name)) steps.push_back({color});
        if (steps.empty()) refusePalette("'" + nacre::printable(name, 40) + "' is not known");
        return steps;
    }
    if (!list->is_array() || list->empty()) refusePalette("has no list of colours");
    if (list->size() > kMostPaletteColors)
        refusePalette("has more than " + std::to_string(kMostPaletteColors) + " colours");
    each = list->front().is_array() ? list->front().size() - 1 : 0;
    for (const Json& entry : *list) {
        const std::size_t size = entry.is_array() ? entry.size() : 1;
        if (each > 2 || size != each + 1) refusePalette("has colours with and without checkpoints");
        if (each == 0) {
            steps.push_back({colorInPalette(entry)});
            continue;
        }
        Step step;
        if (each == 1 || !entry[0].is_null()) step.color = colorInPalette(entry[0]);
        step.from = readBound(entry[1], -kInfinity);
        step.to = each == 2 ? readBound(entry[2], kInfinity) : 0;
        steps.push_back(step);
    }
    return steps;
}

class NumberPalette {
public:
    explicit NumberPalette(const Json& palette) : ramp_(readWord(palette, "kind", "") == "continuous") {
        std::size_t each = 0;
        steps_ = listedSteps(palette, each);
        if (each == 0 && isSet(palette, "reverse")) std::reverse(steps_.begin(), steps_.end());
        if (ramp_ && each == 2) refusePalette("has colours with two checkpoints");
        const auto count = static_cast<double>(steps_.size());
        for (std::size_t i = 0; i < steps_.size() && each == 0; ++i) {
            const auto place = static_cast<double>(i);
            steps_[i].from = ramp_ ? (count > 1 ? place / (count - 1) : 0) : place / count;
            steps_[i].to = (place + 1) / count;
        }
        for (std::size_t i = 0; i < steps_.size() && each == 1; ++i)
            steps_[i].to = i + 1 < steps_.size() ? steps_[i + 1].from : kInfinity;
        if (!ramp_) return;
        std::stable_sort(steps_.begin(), steps_.end(), [](const Step& a, const Step& b) { return a.from < b.from; });
        below_ = outsideColor(palette, "underflow_color", steps_.front());
        above_ = outsideColor(palette, "overflow_color", steps_.back());
    }

    std::optional<std::uint32_t> at(double x) const {
        if (!ramp_) {
            const auto found =
                std::find_if(steps_.rbegin(), steps_.rend(), [&](const Step& s) { return s.from <= x && x <= s.to; });
            return found == steps_.rend() ? std::nullopt : found->color;
        }
        const auto next =
            std::lower_bound(steps_.begin(), steps_.end(), x, [](const Step& s, double at) { return s.from < at; });
        if (next == steps_.end()) return above_;
        if (next->from <= x) return next->color;
        if (next == steps_.begin()) return below_;
        const Step& last = *std::prev(next);
        return mixedColor(*last.color, *next->color, (x - last.from) / (next->from - last.from));
    }

private:
    static std::optional<std::uint32_t> outsideColor(const Json& palette, const char* name, const Step& nearest) {
        const Json* value = findField(palette, name);
        if (!value) return std::nullopt;
        return *value == "auto" ? nearest.color : colorInPalette(*value);
    }

    bool ramp_;
    std::vector<Step> steps_;
    std::optional<std::uint32_t> below_, above_;
};

/// Maps values to positions in a palette.
struct Scale {
    double from = 0, to = 1;
    bool used = true;

    double operator()(double x) const {
        if (!used) return x;
        if (from == to) return x < from ? -0.5 : x == from ? 0.5 : 1.5;
        return (x - from) / (to - from);
    }
};

Scale makeScale(const Json& palette, const std::vector<AnnotationRow>& rows) {
    Scale scale{.used = readWord(palette, "mode", "normalized") != "absolute"};
    if (!scale.used) return scale;
    double least = kInfinity, largest = -kInfinity;
    for (const AnnotationRow& row : rows)
        if (const auto value = row.value() ? leadingNumber(*row.value()) : std::nullopt)
            least = std::min(least, *value), largest = std::max(largest, *value);
    scale = least <= largest ? Scale{least, largest} : Scale{};
    if (const Json* domain = findField(palette, "value_domain")) {
        if (!domain->is_array() || domain->size() != 2) refusePalette("has a value_domain that is no pair of numbers");
        scale.from = readBound((*domain)[0], scale.from);
        scale.to = readBound((*domain)[1], scale.to);
    }
    return scale;
}

ColorOfValue numberColors(const Json& palette, const std::vector<AnnotationRow>& rows) {
    return [colors = NumberPalette(palette), scale = makeScale(palette, rows)](const std::string& text) {
        const auto value = leadingNumber(text);
        return value ? colors.at(scale(*value)) : std::nullopt;
    };
}

/// The distinct values, in the order in which they get colours.
std::vector<std::string> sortedValues(const Json& palette, const std::vector<AnnotationRow>& rows, bool capitals) {
    std::vector<std::string> values;
    std::set<std::string> known;
    for (const AnnotationRow& row : rows)
        if (row.value())
            if (const auto [value, isNew] = known.insert(capitals ? upperCase(*row.value()) : *row.value()); isNew)
                values.push_back(*value);
    const std::string order = readWord(palette, "sort", "none");
    if (order == "lexical") std::sort(values.begin(), values.end());
    if (order == "numeric")
        std::stable_sort(values.begin(), values.end(), [](const std::string& a, const std::string& b) {
            return leadingNumber(a).value_or(kInfinity) < leadingNumber(b).value_or(kInfinity);
        });
    if (readWord(palette, "sort_direction", "ascending") == "descending") std::reverse(values.begin(), values.end());
    return values;
}

ColorOfValue wordColors(const Json& palette, const std::vector<AnnotationRow>& rows) {
    static const Json kUsual = "Category10";
    const Json* given = findField(palette, "colors");
    const Json& colors = given ? *given : kUsual;
    const bool capitals = isSet(palette, "case_insensitive");
    std::map<std::string, std::uint32_t> named;
    if (colors.is_object())
        for (const auto& [word, color] : colors.items()) named.emplace(word, colorInPalette(color));
    else if (colors.is_string())
        named = namedColorMap(colors.get<std::string>());
    std::map<std::string, std::uint32_t> chosen;
    for (const auto& [word, color] : named) chosen.insert_or_assign(capitals ? upperCase(word) : word, color);
    if (named.empty() && !colors.is_object()) {
        std::size_t each = 0, next = 0;
        Json listed = Json::object();
        listed["colors"] = colors;
        const std::vector<Step> list = listedSteps(listed, each);
        if (each > 0) refusePalette("has checkpoints, and words have none");
        const bool repeats = isSet(palette, "repeat_color_list");
        for (const std::string& value : sortedValues(palette, rows, capitals)) {
            if (next == list.size() && !repeats) break;
            chosen.emplace(value, *list[next++ % list.size()].color);
        }
    }
    std::optional<std::uint32_t> missing;
    if (const Json* color = findField(palette, "missing_color")) missing = colorInPalette(*color);
    return [=](const std::string& value) -> std::optional<std::uint32_t> {
        const auto found = chosen.find(capitals ? upperCase(value) : value);
        return found == chosen.end() ? missing : found->second;
    };
}

}  // namespace

std::uint32_t mixedColor(std::uint32_t from, std::uint32_t to, double share) {
    std::uint32_t mixed = 0xff000000u;
    for (int shift = 0; shift < 24; shift += 8) {
        const double a = from >> shift & 0xff, b = to >> shift & 0xff;
        mixed |= static_cast<std::uint32_t>(std::lround(a + (b - a) * share)) << shift;
    }
    return mixed;
}

ColorOfValue colorsOfPalette(const Json& palette, const std::vector<AnnotationRow>& rows) {
    if (!palette.is_object()) refusePalette("is no object");
    const std::string kind = readWord(palette, "kind", "");
    if (kind == "categorical") return wordColors(palette, rows);
    if (kind == "discrete" || kind == "continuous") return numberColors(palette, rows);
    refusePalette("is of no kind that is known: '" + nacre::printable(kind, 40) + "'");
}

std::optional<std::uint32_t> paletteColorAt(const Json& palette, double share) {
    if (!palette.is_object()) refusePalette("is no object");
    return NumberPalette(palette).at(std::clamp(share, 0.0, 1.0));
}

}  // namespace nacre::app::mvs
