#include "app/picture/option_schema.h"

#include "app/files/json_text.h"

namespace nacre::app {

std::string optionSchema(const std::string& title, const std::function<bool(const Option&)>& has) {
    nlohmann::ordered_json properties;
    for (const Option& row : options()) {
        if (row.help.empty() || !has(row)) continue;
        nlohmann::ordered_json property{{"type", row.kind == Option::Kind::flag ? "boolean" : "string"},
                                        {"description", row.help}};
        if (!row.syntax.empty()) property["x-syntax"] = row.syntax;
        std::vector<std::string> examples = row.choices;
        for (const Option::Control::Choice& choice : row.control.choices)
            if (row.choices.empty()) examples.push_back(choice.value);
        if (!examples.empty()) property["examples"] = examples;
        properties[std::string(row.key)] = std::move(property);
    }
    return jsonText({{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                     {"title", title},
                     {"type", "object"},
                     {"required", {"input"}},
                     {"properties", properties}});
}

}  // namespace nacre::app
