#include "app/picture/options.h"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>

#include "app/picture/rows.h"
#include "engine/error.h"
#include "engine/molecule/nearest_word.h"

namespace nacre::app {

std::vector<Option> under(Topic topic, Facet facet, std::vector<Option> rows) {
    for (Option& row : rows) {
        if (row.topic == Topic::saved && !row.help.empty()) row.topic = topic;
        if (row.facet == Facet::file) row.facet = facet;
    }
    return rows;
}

std::vector<Option> joined(std::initializer_list<std::vector<Option>> groups) {
    std::vector<Option> all;
    for (const std::vector<Option>& group : groups) all.insert(all.end(), group.begin(), group.end());
    return all;
}

std::span<const Option> options() {
    static const std::vector<Option> kOptions = joined({inputRows(), sceneRows(), mapRows(), geometryRows(), fileRows(),
                                                        viewRows(), shadingRows(), wordRows(), deviceRows()});
    return kOptions;
}

const Option* findOption(std::string_view key, Topics topics) {
    for (const Option& option : options())
        if (option.key == key && has(topics, option.topic)) return &option;
    return nullptr;
}

const Option& option(std::string_view key) {
    if (const Option* found = findOption(key)) return *found;
    std::abort();  // a misspelled key in the program
}

namespace {

/// For an invalid text, suggests a word of the option's syntax, or its other unit.
std::string hintFor(const Option& option, std::string_view text, std::string_view said) {
    if (said.find("did you mean") != std::string_view::npos) return {};
    std::vector<std::string> words(1);
    for (const char c : option.syntax)
        if (c == '|')
            words.emplace_back();
        else
            words.back() += c;
    for (std::string& word : words) word.resize(std::min(word.find('['), word.size()));  // "focus[,RADIUS]"
    std::erase_if(words, [](const std::string& word) {                                   // placeholders: SEL, START,END
        return word.size() < 3 || !std::ranges::all_of(word, [](char c) { return (c >= 'a' && c <= 'z') || c == '-'; });
    });
    if (std::string hint = suggestion(text, words); !hint.empty()) return hint;
    const bool number = !text.empty() && text.front() >= '0' && text.front() <= '9';
    return number && option.syntax.find("POINTSpt") != std::string::npos ? " (8pt is a size in points)" : "";
}

}  // namespace

void setOption(const Option& option, std::string_view text, PictureDescription& description) {
    std::string said, hint;
    try {
        option.value.parse(text, description);
    } catch (const std::invalid_argument& error) {
        said = error.what();
        if ((hint = hintFor(option, text, said)).empty()) throw;
    } catch (const Error& error) {
        said = error.what();
        if ((hint = hintFor(option, text, said)).empty()) throw;
    }
    if (!hint.empty()) throw std::invalid_argument(said + hint);
    description.given.emplace(option.key);
}

std::size_t chosen(const Option& option, const PictureDescription& description) {
    const auto& choices = option.control.choices;
    const std::string value = option.value.print(description);
    const auto is = [&](const Option::Control::Choice& choice) { return choice.value == value; };
    return static_cast<std::size_t>(std::find_if(choices.begin(), choices.end(), is) - choices.begin());
}

std::size_t stepOption(const Option& option, PictureDescription& description) {
    const std::size_t count = option.control.choices.size();
    const std::size_t at = (std::min(chosen(option, description), count - 1) + 1) % count;
    option.value.parse(option.control.choices[at].value, description);
    return at;
}

Facets difference(const PictureDescription& a, const PictureDescription& b) {
    Facets parts = 0;
    for (const Option& option : options())
        if (option.value.print && !has(parts, option.facet) && option.value.print(a) != option.value.print(b))
            parts |= static_cast<Facets>(option.facet);
    return parts;
}

}  // namespace nacre::app
