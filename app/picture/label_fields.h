#pragma once
// The fields of a label's text, such as {residue}.

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "engine/molecule/nearest_word.h"

namespace nacre::app {

enum class LabelScope { selection, chain, residue, atom };

struct LabelField {
    std::string_view name;
    LabelScope scope;
};
constexpr LabelField kLabelFields[] = {
    {"residue", LabelScope::residue}, {"letter", LabelScope::residue}, {"number", LabelScope::residue},
    {"chain", LabelScope::chain},     {"model", LabelScope::chain},    {"atom", LabelScope::atom},
    {"element", LabelScope::atom},    {"id", LabelScope::atom},        {"altloc", LabelScope::atom},
    {"b-factor", LabelScope::atom},   {"occupancy", LabelScope::atom}};

/// Calls plain(text) and field(entry) for the pieces of a label. Braces of markup, as in _{12}, are plain.
template <typename Plain, typename OnField>
void eachPiece(std::string_view text, const Plain& plain, const OnField& field) {
    std::size_t from = 0;
    const auto pass = [&](std::size_t to) {
        if (to > from) plain(text.substr(from, to - from));
    };
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '\\') {
            ++i;
            continue;
        }
        if (text[i] != '{') continue;
        const bool group = i > 0 && (text[i - 1] == '_' || text[i - 1] == '^');  // of markup, unless a field
        const std::size_t close = text.find('}', i);
        if (close == std::string_view::npos)
            throw std::invalid_argument("a brace is not closed in '" + std::string(text) + "'");
        const std::string_view name = text.substr(i + 1, close - i - 1);
        const LabelField* known = std::find_if(std::begin(kLabelFields), std::end(kLabelFields),
                                               [&](const LabelField& entry) { return entry.name == name; });
        if (known == std::end(kLabelFields) && group) continue;
        if (known == std::end(kLabelFields)) {
            std::vector<std::string> words;
            std::string list;
            for (const LabelField& entry : kLabelFields) {
                words.emplace_back(entry.name);
                list += (list.empty() ? "{" : ", {") + words.back() + "}";
            }
            throw std::invalid_argument("expected one of " + list + ", not '{" + std::string(name) + "}'" +
                                        suggestion(name, words));
        }
        // A raised or lowered field keeps its braces.
        pass(group ? i + 1 : i);
        field(*known);
        from = group ? close : close + 1;
        i = close;
    }
    pass(text.size());
}

}  // namespace nacre::app
