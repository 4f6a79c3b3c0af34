#include "app/picture/options.h"

#include <algorithm>
#include <cstdlib>
#include <iterator>

#include "app/picture/rows.h"

namespace nacre::app {

std::span<const Option> options() {
    static const std::vector<Option> kOptions = [] {
        std::vector<Option> all;
        for (std::vector<Option> (*rows)() :
             {inputRows, sceneRows, mapRows, geometryRows, fileRows, viewRows, shadingRows, wordRows, deviceRows}) {
            std::vector<Option> some = rows();
            std::move(some.begin(), some.end(), std::back_inserter(all));
        }
        return all;
    }();
    return kOptions;
}

const Option* findOption(std::string_view key, Topics topics) {
    for (const Option& option : options())
        if (option.key == key && has(topics, option.topic)) return &option;
    return nullptr;
}

const Option& option(std::string_view key) {
    if (const Option* found = findOption(key)) return *found;
    std::abort();  // a key that the program misspells
}

void setOption(const Option& option, std::string_view text, PictureDescription& description) {
    option.parse(text, description);
    description.given.emplace(option.key);
}

std::size_t chosen(const Option& option, const PictureDescription& description) {
    const auto& choices = option.control.choices;
    const std::string value = option.print(description);
    const auto is = [&](const Option::Control::Choice& choice) { return choice.value == value; };
    return static_cast<std::size_t>(std::find_if(choices.begin(), choices.end(), is) - choices.begin());
}

std::size_t stepOption(const Option& option, PictureDescription& description) {
    const std::size_t count = option.control.choices.size();
    const std::size_t at = (std::min(chosen(option, description), count - 1) + 1) % count;
    option.parse(option.control.choices[at].value, description);
    return at;
}

Facets difference(const PictureDescription& a, const PictureDescription& b) {
    Facets parts = 0;
    for (const Option& option : options())
        if (option.print && !has(parts, option.facet) && option.print(a) != option.print(b))
            parts |= static_cast<Facets>(option.facet);
    return parts;
}

}  // namespace nacre::app
