#include "app/picture/option_values.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "app/picture/option_text.h"
#include "engine/molecule/nearest_word.h"
#include "engine/molecule/trajectory/motion.h"
#include "engine/settings.h"

namespace nacre::app {

void refuse(std::string_view text, const std::string& wanted, std::span<const std::string> words) {
    throw std::invalid_argument("expected " + wanted + ", not '" + std::string(text) + "'" + suggestion(text, words));
}

std::string joinWords(std::span<const std::string> words) {
    std::string list;
    for (const std::string& word : words) list += (list.empty() ? "" : ", ") + word;
    return list;
}

std::string joinAlternatives(std::span<const std::string> words) {
    return (words.size() > 1 ? joinWords(words.first(words.size() - 1)) + " or " : "") + words.back();
}

void refuseEnding(std::string_view name, std::span<const std::string> endings, const std::string& also) {
    const std::size_t dot = std::min(name.rfind('.'), name.size());
    throw std::invalid_argument("expected a name that ends in " + joinAlternatives(endings) + also + ", not '" +
                                std::string(name) + "'" + suggestion(name.substr(dot), endings));
}

std::string fileName(std::string_view text) {
    if (text.empty()) throw std::invalid_argument("expected a file name");
    return std::string(text);
}

Size parseSize(std::string_view text) {
    const std::string wanted = "WIDTHxHEIGHT, each 1 to " + std::to_string(kLargestSide);
    const std::size_t cross = text.find('x');
    Size size;
    if (cross == std::string_view::npos || !readWhole(text.substr(0, cross), size.width) ||
        !readWhole(text.substr(cross + 1), size.height))
        refuse(text, wanted);
    for (const std::uint32_t side : {size.width, size.height})
        if (side < 1 || side > kLargestSide) refuse(text, wanted);
    return size;
}

Length parseLength(std::string_view text) {
    constexpr std::pair<std::string_view, double> kUnits[] = {{"mm", 1 / 25.4}, {"cm", 1 / 2.54}, {"in", 1}};
    double scale = 1;
    bool inches = false;
    std::string_view number = text;
    for (const auto& [unit, ofInch] : kUnits)
        if (text.ends_with(unit)) {
            number.remove_suffix(unit.size());
            scale = ofInch;
            inches = true;
        }
    const bool pixels = text.ends_with("px");
    if (pixels) number.remove_suffix(2);
    double value = 0;
    if (!inches && !pixels && readWhole(number, value))
        throw std::invalid_argument("a length needs a unit: " + std::string(text) + "mm or " + std::string(text) +
                                    "px");
    if (!readWhole(number, value) || !(value > 0) || !(value <= kLargestSide))
        refuse(text, "a length such as 85mm, 8.5cm, 3.3in or 1200px");
    return {value * scale, inches};
}

namespace {

constexpr std::pair<std::string_view, ScreenLength::Unit> kScreenUnits[] = {
    {"pt", ScreenLength::Unit::points}, {"%", ScreenLength::Unit::percent}, {"A", ScreenLength::Unit::angstrom}};

}  // namespace

double ScreenLength::pixels(double shorter, double dpi, double pixelsPerAngstrom) const {
    switch (unit) {
        case Unit::percent:
            return value / 100 * shorter;
        case Unit::angstrom:
            return value * pixelsPerAngstrom;
        default:
            return value * dpi / 72;
    }
}

std::optional<ScreenLength> parseScreenLength(std::string_view text) {
    for (const auto& [ending, unit] : kScreenUnits) {
        double value = 0;
        if (text.ends_with(ending) && readWhole(text.substr(0, text.size() - ending.size()), value))
            return ScreenLength{value, unit};
    }
    return std::nullopt;
}

std::string screenLengthText(const ScreenLength& length) {
    return numberText(length.value) + std::string(kScreenUnits[static_cast<std::size_t>(length.unit)].first);
}

std::optional<double> parsePoints(std::string_view text) {
    const std::optional<ScreenLength> length = parseScreenLength(text);
    return length && length->unit == ScreenLength::Unit::points ? std::optional(length->value) : std::nullopt;
}

double parsePixels(std::string_view text, double least, double most) {
    if (const std::optional<double> points = parsePoints(text)) {
        const double pixels = *points * kScreenDpi / 72;
        if (!(pixels >= least && pixels <= most))
            refuse(text, "from " + numberText(least) + " to " + numberText(most) + " pixels, of which 96 are 72pt");
        return pixels;
    }
    if (text.ends_with("px")) text.remove_suffix(2);
    return parseNumber(text, least, most);
}

glm::dvec3 parseRotation(std::string_view text) {
    glm::dvec3 angles(0);
    std::string_view rest = text;
    for (int i = 0; i < 3; ++i) {
        const std::size_t comma = i < 2 ? rest.find(',') : rest.size();
        if (comma == std::string_view::npos || !readWhole(rest.substr(0, comma), angles[i]) ||
            !std::isfinite(angles[i]))
            refuse(text, "three angles X,Y,Z in degrees");
        rest.remove_prefix(i < 2 ? comma + 1 : comma);
    }
    return angles;
}

double parseNumber(std::string_view text, double low, double high) {
    double value = 0;
    if (!readWhole(text, value) || !(value >= low && value <= high))
        refuse(text, "a number from " + numberText(low) + " to " + numberText(high));
    return value;
}

std::int64_t parseInteger(std::string_view text, std::int64_t low, std::int64_t high) {
    std::int64_t value = 0;
    if (!readWhole(text, value) || value < low || value > high)
        refuse(text, "a whole number from " + std::to_string(low) + " to " + std::to_string(high));
    return value;
}

int parseModel(std::string_view text) {
    if (text == "all") return kAllModels;
    int value = 0;
    if (!readWhole(text, value) || value < 1) refuse(text, "'all' or a model's number from 1");
    return value;
}

std::int64_t parseFrame(std::string_view text) { return parseInteger(text, 1, std::int64_t{1} << 40); }

std::int64_t parseSmoothing(std::string_view text) {
    const std::int64_t frames = parseInteger(text, 1, Motion::kMostSmoothed);
    if (frames % 2 == 0) throw std::invalid_argument("expected an odd number");
    return frames;
}

int parseOcclusion(std::string_view text) {
    if (text == "off") return 0;
    std::int64_t value = 0;
    if (!readWhole(text, value) || value < 1 || value > kMostDirections)
        refuse(text, "'off' or a number of directions from 1 to " + std::to_string(kMostDirections));
    return static_cast<int>(value);
}

std::size_t parseChoice(std::string_view text, std::initializer_list<const char*> choices) {
    return parseChoice(text, std::span(choices.begin(), choices.size()));
}

std::size_t parseChoice(std::string_view text, std::span<const char* const> choices) {
    std::string list;
    std::size_t index = 0;
    for (const std::string_view choice : choices) {
        if (choice == text) return index;
        list += std::string(index == 0 ? "" : index + 1 == choices.size() ? " or " : ", ") + std::string(choice);
        ++index;
    }
    refuse(text, list, std::vector<std::string>(choices.begin(), choices.end()));
}

std::uint32_t parseSupersample(std::string_view text) {
    if (text == "auto") return RenderSettings::kEdges;
    std::uint32_t value = 0;
    if (!readWhole(text, value) || value < 1 || value > kMostSupersample)
        refuse(text, "'auto' or a whole number from 1 to " + std::to_string(kMostSupersample));
    return value;
}

void checkSamples(const Size& size, std::uint32_t supersample, std::uint64_t most) {
    supersample = std::max(supersample, 1u);  // edge samples need no additional pixels
    const std::uint64_t samples = std::uint64_t{size.width} * size.height * supersample * supersample;
    if (samples > most)
        throw std::invalid_argument("--size times --supersample squared is " + std::to_string(samples) +
                                    " samples; at most " + std::to_string(most) + " are drawn");
}

}  // namespace nacre::app
