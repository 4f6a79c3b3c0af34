// The texts of label_from_* and tooltip_from_*.

#include <map>
#include <optional>
#include <stdexcept>

#include "app/mvs/scene_parts.h"
#include "app/mvs/text_format.h"

namespace nacre::app::mvs {
namespace {

constexpr std::size_t kMostTexts = 2000;

/// Columns that join rows to one text.
std::vector<std::string> groupColumns(const Node& node) {
    const Json* named = node.param("group_by_fields");
    if (!named || !named->is_array()) return {findColumn(node, "group_id")};
    std::vector<std::string> columns;
    for (const Json& each : *named)
        if (each.is_string()) columns.push_back(each.get<std::string>());
    return columns;
}

/// The joined values of the group columns; empty: the row has its own text.
std::string joinColumns(const AnnotationRow& row, std::size_t columns) {
    std::string group;
    for (std::size_t i = 1; i <= columns; ++i) {
        if (!row.values[i]) return {};
        group += *row.values[i] + '\0';
    }
    return columns == 0 ? "all" : group;
}

}  // namespace

std::vector<std::pair<std::string, std::vector<bool>>> readTextGroups(const Node& node, const char* field,
                                                                      const Structure& s, SceneFiles& files,
                                                                      SceneWarnings& warnings) {
    std::vector<std::pair<std::string, std::vector<bool>>> texts;
    const Json* format = node.param("text_format");
    std::optional<TextFormat> words;
    try {
        words.emplace(format && format->is_string() ? format->get<std::string>() : "{}");
    } catch (const std::invalid_argument& why) {
        warnings.add(node, why.what() + std::string(": it is left out"));
        return texts;
    }
    std::vector<std::string> columns = groupColumns(node);
    const std::size_t joining = columns.size();
    columns.insert(columns.end(), words->fields().begin(), words->fields().end());
    std::map<std::string, std::size_t> groups;  // index in `texts`; SIZE_MAX: without a text
    for (const AnnotationRow& row : readRows(node, field, s, files, columns)) {
        const std::string group = joinColumns(row, joining);
        const auto known = group.empty() ? groups.end() : groups.find(group);
        std::size_t place = texts.size();
        if (known != groups.end()) {
            place = known->second;
        } else {
            const auto text = words->of(row.values, 1 + joining);
            if (!text) place = SIZE_MAX;
            if (!group.empty()) groups.emplace(group, place);
            if (text && texts.size() == kMostTexts) {
                warnings.add(node,
                             "it has more than " + std::to_string(kMostTexts) + " texts; the others are left out");
                break;
            }
            if (text) texts.emplace_back(*text, std::vector<bool>(s.molecule->atoms.size()));
        }
        if (place != SIZE_MAX) s.atoms->add(row.expression, texts[place].second);
    }
    return texts;
}

}  // namespace nacre::app::mvs
