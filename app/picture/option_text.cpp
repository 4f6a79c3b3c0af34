#include "app/picture/option_text.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "app/picture/appearance_values.h"
#include "engine/molecule/text.h"
#include "engine/srgb.h"

namespace nacre::app {

std::string numberText(double value) { return formatted("%.12g", value); }

std::string exactText(double value) {
    std::array<char, 40> digits{};
    for (int precision = 1; precision <= 17; ++precision) {
        std::snprintf(digits.data(), digits.size(), "%.*g", precision, value);
        const bool plain = std::strchr(digits.data(), 'e') == nullptr;  // 30, where one digit would give 3e+01
        const bool readable = plain || std::abs(value) < 1e-4 || std::abs(value) >= 1e15;
        if (readable && std::strtod(digits.data(), nullptr) == value) break;
    }
    return digits.data();
}

const char* styleName(Style style) {
    for (const auto& [name, one] : kStyles)
        if (one == style) return name;
    return "";
}

std::string backgroundText(const std::array<float, 4>& color) {
    for (const char* name : {"white", "black", "gray", "lightgray", "transparent"})
        if (color == parseColor(name)) return name;
    return formatted(color[3] < 1 ? "#%02x%02x%02x%02x" : "#%02x%02x%02x", toByte(color[0]), toByte(color[1]),
                     toByte(color[2]), toByte(color[3]));
}

std::string clipText(const Clip& clip) {
    if (!clip.on()) return "off";
    const std::string near = clip.near > -Clip::kNone ? numberText(clip.near) : "";
    return clip.far < Clip::kNone ? near + "," + numberText(clip.far) : near;
}

std::pair<std::string, std::string> ruleText(const Rule& rule) {
    switch (rule.action) {
        case Rule::Action::show:
            return {"show", rule.selection.text + "=" + styleName(rule.style) +
                                (rule.opacity ? ":opacity=" + numberText(*rule.opacity) : std::string()) +
                                (rule.material ? std::string(":material=") +
                                                     kMaterialNames[static_cast<std::size_t>(*rule.material)]
                                               : std::string())};
        case Rule::Action::hide:
            return {"hide", rule.selection.text};
        case Rule::Action::color:
            return {"color-by", rule.selection.text + "=" + coloringText(rule.coloring)};
    }
    return {};
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

}  // namespace nacre::app
