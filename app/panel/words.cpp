#include "app/panel/words.h"

#include "app/picture/options.h"

namespace nacre::app {

std::string wordOf(std::string_view key, std::string_view value) {
    for (const auto& choice : option(key).control.choices)
        if (choice.value == value) return choice.label;
    constexpr std::string_view kCarbons = "element:";
    if (key == "color" && value.starts_with('#')) return "One colour, " + std::string(value);
    if (key == "color" && value.starts_with(kCarbons))
        return "By element, carbon " + std::string(value.substr(kCarbons.size()));
    return std::string(value);
}

std::string selectionWords(const std::string& text) {
    constexpr std::string_view kNear = "byres (within ", kOf = " of (";
    if (text == "mainligand" || text == "(mainligand)") return "the ligand";
    const std::size_t of = text.find(kOf);
    if (!text.starts_with(kNear) || of == std::string::npos) return text;
    const std::size_t from = of + kOf.size();
    std::size_t end = from;
    for (int depth = 1; end < text.size(); ++end)
        if ((depth += text[end] == '(' ? 1 : text[end] == ')' ? -1 : 0) == 0) break;
    const std::string inner = text.substr(from, end - from);
    const std::string rest = text.substr(std::min(end + 2, text.size()));
    if (!rest.empty() && rest != " and polymer and not (" + inner + ")") return text;
    return "residues within " + text.substr(kNear.size(), of - kNear.size()) + " Å of " + selectionWords(inner);
}

std::string colorWord(const Coloring& coloring) {
    for (const NamedColor& color : swatches())
        if (coloring.scheme == ColorScheme::uniform && (coloring.color | 0xff000000) == color.packed())
            return color.name;
    return wordOf("color", coloringText(coloring));
}

std::span<const NamedColor> swatches() {
    static constexpr NamedColor kColors[] = {{"Orange", 0xe69f00}, {"Sky blue", 0x56b4e9}, {"Green", 0x009e73},
                                             {"Yellow", 0xf0e442}, {"Blue", 0x0072b2},     {"Vermilion", 0xd55e00},
                                             {"Pink", 0xcc79a7},   {"Red", 0xc0282d},      {"Purple", 0x7b3fa0},
                                             {"Brown", 0x8c5a2b},  {"White", 0xf5f5f5},    {"Grey", 0x8a8f96}};
    return kColors;
}

}  // namespace nacre::app
