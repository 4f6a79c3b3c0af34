#include "app/picture/options.h"

#include <cstdlib>
#include <iterator>

#include "app/picture/rows.h"

namespace nacre::app {

std::span<const Option> options() {
    static const std::vector<Option> kOptions = [] {
        std::vector<Option> all;
        for (std::vector<Option> (*rows)() :
             {inputRows, sceneRows, mapRows, fileRows, viewRows, shadingRows, wordRows, deviceRows}) {
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

Facets difference(const PictureDescription& a, const PictureDescription& b) {
    Facets parts = 0;
    for (const Option& option : options())
        if (option.print && !has(parts, option.facet) && option.print(a) != option.print(b))
            parts |= static_cast<Facets>(option.facet);
    return parts;
}

}  // namespace nacre::app
