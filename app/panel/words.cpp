#include "app/panel/words.h"

#include "app/viewer/presets.h"

namespace nacre::app {

std::span<const StyleWord> styleWords() {
    static const StyleWord kWords[] = {
        {"Automatic", std::nullopt},   {"Spacefill", Style::spacefill}, {"Ball and stick", Style::ballAndStick},
        {"Licorice", Style::licorice}, {"Cartoon", Style::cartoon},     {"Surface", Style::surface}};
    return kWords;
}

std::string colorWord(const Coloring& coloring) {
    const std::string text = coloringText(coloring);
    for (const ColorWord& word : colorWords())
        if (text == word.option) return word.word;
    for (const NamedColor& color : swatches())
        if (coloring.scheme == ColorScheme::uniform && (coloring.color | 0xff000000) == color.packed())
            return color.name;
    return text;
}

std::span<const NamedColor> swatches() {
    static constexpr NamedColor kColors[] = {{"Orange", 0xe69f00}, {"Sky blue", 0x56b4e9}, {"Green", 0x009e73},
                                             {"Yellow", 0xf0e442}, {"Blue", 0x0072b2},     {"Vermilion", 0xd55e00},
                                             {"Pink", 0xcc79a7},   {"Red", 0xc0282d},      {"Purple", 0x7b3fa0},
                                             {"Brown", 0x8c5a2b},  {"White", 0xf5f5f5},    {"Grey", 0x8a8f96}};
    return kColors;
}

std::span<const NamedColor> backgrounds() {
    static constexpr NamedColor kColors[] = {{"White", 0xffffff},      {"Light grey", 0xd3d3d3}, {"Grey", 0x808080},
                                             {"Night blue", 0x102040}, {"Black", 0x000000},      {"Paper", 0xfaf4e6}};
    return kColors;
}

}  // namespace nacre::app
