#pragma once
// The rows of options.h by subject, and helpers to write them.

#include "app/picture/option_text.h"
#include "app/picture/options.h"

namespace nacre::app {

std::vector<Option> inputRows();
std::vector<Option> sceneRows();
std::vector<Option> mapRows();
std::vector<Option> geometryRows();
std::vector<Option> fileRows();
std::vector<Option> viewRows();
std::vector<Option> shadingRows();
std::vector<Option> wordRows();
std::vector<Option> deviceRows();

/// Rows of one topic that affect one part of the work. A row may state another part; a row without help is only for
/// saved views.
std::vector<Option> under(Topic topic, Facet facet, std::vector<Option> rows);
std::vector<Option> joined(std::initializer_list<std::vector<Option>> groups);

/// A member of a member: at<&A::b, &B::c>(a) is a.b.c.
template <auto first, auto... rest>
auto& at(auto& object) {
    if constexpr (sizeof...(rest) == 0)
        return object.*first;
    else
        return at<rest...>(object.*first);
}

/// How an option parses and prints a member; an empty optional prints as "". @param print  numbers and text by default
template <auto... members, typename Parse, typename Print>
Option::Access valueOf(Parse parse, Print print) {
    return {[parse](std::string_view text, PictureDescription& d) { at<members...>(d) = parse(text); },
            [print](const PictureDescription& d) {
                const auto& value = at<members...>(d);
                if constexpr (requires { value.has_value(); })
                    return value ? std::string(print(*value)) : std::string();
                else
                    return std::string(print(value));
            }};
}
template <auto... members, typename Parse>
Option::Access valueOf(Parse parse) {
    return valueOf<members...>(parse, [](const auto& value) {
        if constexpr (requires { std::to_string(value); })
            return std::to_string(value);
        else
            return value;
    });
}

/// An enumeration with these value names, in order; or a boolean, false first.
template <const auto& names, auto... members>
Option::Access choiceOf() {
    using Value = std::remove_reference_t<decltype(at<members...>(std::declval<PictureDescription&>()))>;
    return valueOf<members...>([](std::string_view text) { return static_cast<Value>(parseChoice(text, names)); },
                               [](Value value) { return names[static_cast<std::size_t>(value)]; });
}

/// A boolean as two words, the first for true.
using Words2 = const char* const[2];
inline constexpr Words2 kOnOff = {"on", "off"}, kShowHide = {"show", "hide"};
template <const auto& words, auto... members>
Option::Access switchOf() {
    return valueOf<members...>([](std::string_view text) { return parseChoice(text, words) == 0; },
                               [](bool value) { return words[value ? 0 : 1]; });
}
/// A flag: its name alone means "on".
template <auto... members>
Option::Access flagOf() {
    return valueOf<members...>([](std::string_view text) { return text.empty() || parseChoice(text, kOnOff) == 0; },
                               [](bool value) { return kOnOff[value ? 0 : 1]; });
}

template <auto... members>
Option::Access numberOf(double low, double high) {
    return valueOf<members...>([=](std::string_view text) { return parseNumber(text, low, high); }, numberText);
}
/// Prints all digits needed to parse to the same number.
template <auto... members>
Option::Access exactOf(double low, double high) {
    return valueOf<members...>([=](std::string_view text) { return parseNumber(text, low, high); }, exactText);
}
template <auto... members>
Option::Access integerOf(std::int64_t low, std::int64_t high) {
    return valueOf<members...>([=](std::string_view text) { return parseInteger(text, low, high); });
}
template <auto... members>
Option::Access textOf() {
    return valueOf<members...>([](std::string_view text) { return text; });
}
/// The name of a file. Parsing throws std::invalid_argument if it is empty.
template <auto... members>
Option::Access fileOf() {
    return valueOf<members...>(fileName);
}
template <auto... members>
Option::Access selectionOf() {
    return valueOf<members...>(parseSelection, [](const Selection& selection) { return selection.text; });
}
inline std::string opaqueText(const std::array<float, 3>& color) {
    return backgroundText({color[0], color[1], color[2], 1});
}

/// Adds one to a list, or clears the list.
template <typename Value, typename Parse>
void addTo(std::vector<Value>& list, std::string_view text, std::size_t most, Parse parse) {
    if (text.empty()) return list.clear();
    if (list.size() >= most) throw std::invalid_argument("more than " + std::to_string(most) + " of them");
    list.push_back(parse(text));
}
template <typename Value, typename Text>
std::string lines(const std::vector<Value>& list, Text text) {
    std::string all;
    for (const Value& value : list) all += (all.empty() ? "" : "\n") + text(value);
    return all;
}
template <auto... members, typename Parse, typename Text>
Option::Access listOf(std::size_t most, Parse parse, Text text) {
    return {[=](std::string_view value, PictureDescription& d) { addTo(at<members...>(d), value, most, parse); },
            [=](const PictureDescription& d) { return lines(at<members...>(d), text); }};
}

}  // namespace nacre::app
