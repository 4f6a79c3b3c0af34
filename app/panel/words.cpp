#include "app/panel/words.h"

#include "app/picture/options.h"

namespace nacre::app {

std::string choiceLabel(std::string_view key, std::string_view value) {
    for (const auto& choice : option(key).control.choices)
        if (choice.value == value) return choice.label;
    constexpr std::string_view kCarbons = "element:";
    if (key == "color" && value.starts_with('#')) return "One colour, " + std::string(value);
    if (key == "color" && value.starts_with(kCarbons))
        return "By element, carbon " + std::string(value.substr(kCarbons.size()));
    return std::string(value);
}

std::string colorWord(const Coloring& coloring) {
    for (const NamedColor& color : swatches())
        if (coloring.scheme == ColorScheme::uniform && (coloring.color | 0xff000000) == color.packed())
            return color.name;
    return choiceLabel("color", coloringText(coloring));
}

std::span<const NamedColor> swatches() {
    static constexpr NamedColor kColors[] = {{"Orange", 0xe69f00}, {"Sky blue", 0x56b4e9}, {"Green", 0x009e73},
                                             {"Yellow", 0xf0e442}, {"Blue", 0x0072b2},     {"Vermilion", 0xd55e00},
                                             {"Pink", 0xcc79a7},   {"Red", 0xc0282d},      {"Purple", 0x7b3fa0},
                                             {"Brown", 0x8c5a2b},  {"White", 0xf5f5f5},    {"Grey", 0x8a8f96}};
    return kColors;
}

}  // namespace nacre::app
