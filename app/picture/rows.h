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

/// An enumeration with these value names, in order.
template <const auto& names, auto... members>
void parseNamed(std::string_view text, PictureDescription& d) {
    auto& value = at<members...>(d);
    value = static_cast<std::remove_reference_t<decltype(value)>>(parseChoice(text, names));
}
template <const auto& names, auto... members>
std::string printNamed(const PictureDescription& d) {
    return std::string(names[static_cast<std::size_t>(at<members...>(d))]);
}

/// A boolean as two words, the first for true.
using Words2 = const char* const[2];
inline constexpr Words2 kOnOff = {"on", "off"}, kShowHide = {"show", "hide"};
template <const auto& words, auto... members>
void parseSwitch(std::string_view text, PictureDescription& d) {
    at<members...>(d) = parseChoice(text, words) == 0;
}
template <const auto& words, auto... members>
std::string printSwitch(const PictureDescription& d) {
    return words[at<members...>(d) ? 0 : 1];
}
/// A flag: its name alone means "on".
template <auto... members>
void parseFlag(std::string_view text, PictureDescription& d) {
    at<members...>(d) = text.empty() || parseChoice(text, kOnOff) == 0;
}

template <auto... members>
std::string printNumber(const PictureDescription& d) {
    return numberText(at<members...>(d));
}
/// All digits needed to parse to the same number.
template <auto... members>
std::string printExact(const PictureDescription& d) {
    return exactText(at<members...>(d));
}
template <auto... members>
std::string printText(const PictureDescription& d) {
    return at<members...>(d);
}

template <auto... members>
void parseSelected(std::string_view text, PictureDescription& d) {
    at<members...>(d) = parseSelection(text);
}
template <auto... members>
std::string printSelected(const PictureDescription& d) {
    const auto& selection = at<members...>(d);
    return selection ? selection->text : std::string();
}

/// The name of a file. @throws std::invalid_argument if it is empty
template <auto... members>
void parseFile(std::string_view text, PictureDescription& d) {
    at<members...>(d) = fileName(text);
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

}  // namespace nacre::app
