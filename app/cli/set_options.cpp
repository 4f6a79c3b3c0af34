#include "app/cli/set_options.h"

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>

#include "app/cli/option_words.h"
#include "app/files/json_text.h"
#include "engine/error.h"
#include "engine/molecule/nearest_word.h"

namespace nacre::app {
namespace {

using Json = nlohmann::ordered_json;

const OptionSpec& optionOf(const std::string& name, const CommandSpec& command) {
    std::vector<std::string> names;
    for (const OptionSpec& option : command.options) {
        names.push_back(plainName(option));
        if (names.back() == name) return option;
    }
    throw UsageError("nacre " + command.name + " has no option \"" + name + "\"" + suggestion(name, names));
}

[[noreturn]] void refuse(const std::string& name, const std::string& why) {
    throw UsageError("\"" + name + "\": " + why);
}

/// A text or number, or numbers that belong together: [640, 480] is "640x480" of a size, and "640,480" otherwise.
std::string textOf(const Json& value, const OptionSpec& option) {
    if (value.is_string()) return value.get<std::string>();
    if (option.positional() || takesFile(option))
        refuse(plainName(option), "expected a text, not " + value.dump(-1, ' ', false, Json::error_handler_t::replace));
    if (value.is_number()) return value.dump();
    if (value.is_boolean() && option.type == "on|off") return value.get<bool>() ? "on" : "off";
    if (value.is_array() && !value.empty() &&
        std::all_of(value.begin(), value.end(), [](const Json& number) { return number.is_number(); })) {
        std::string text;
        for (const Json& number : value) text += (text.empty() ? "" : option.type == "WxH" ? "x" : ",") + number.dump();
        return text;
    }
    refuse(plainName(option),
           "expected a text or a number, not " + value.dump(-1, ' ', false, Json::error_handler_t::replace));
}

void addValue(std::vector<OptionValue>& values, const Json& value, const OptionSpec& option) {
    const std::string name = plainName(option);
    if (value.is_null()) return;
    if (option.flag()) {
        if (!value.is_boolean()) refuse(name, "expected true or false");
        if (value.get<bool>()) values.push_back({name, ""});
    } else if (option.pair) {
        // ["SEL", "SEL"], or a list of such.
        if (value.is_array() && !value.empty() && value[0].is_array()) {
            for (const Json& two : value) addValue(values, two, option);
            return;
        }
        if (!value.is_array() || value.size() != 2) refuse(name, "expected two values");
        values.push_back({name, textOf(value[0], option) + "\n" + textOf(value[1], option)});
    } else if (option.repeatable && value.is_array()) {
        for (const Json& one : value) values.push_back({name, textOf(one, option)});
    } else {
        values.push_back({name, textOf(value, option)});
    }
}

void addRules(std::vector<OptionValue>& values, const Json& rules, const CommandSpec& command) {
    if (!rules.is_array()) refuse("rules", "expected a list");
    for (const Json& rule : rules) {
        if (!rule.is_object() || rule.size() != 1) refuse("rules", "expected each rule as {\"option\": \"value\"}");
        const OptionSpec& option = optionOf(rule.begin().key(), command);
        if (!option.repeatable) refuse("rules", "\"" + rule.begin().key() + "\" is no rule");
        values.push_back({rule.begin().key(), textOf(rule.begin().value(), option)});
    }
}

void set(const OptionSpec& option, const std::string& value) {
    // Names of files would end there.
    if (value.find('\0') != std::string::npos) throw UsageError(plainName(option) + ": it holds a NUL");
    try {
        option.set(value);
    } catch (const std::invalid_argument& error) {
        throw UsageError(plainName(option) + ": " + error.what());
    } catch (const Error& error) {
        throw UsageError(plainName(option) + ": " + error.what());
    }
}

void checkTogether(const CommandSpec& command, std::span<const OptionValue> values) {
    const auto given = [&](const OptionSpec& option) {
        return std::any_of(values.begin(), values.end(),
                           [name = plainName(option)](const OptionValue& v) { return v.name == name; });
    };
    for (const OptionSpec& option : command.options) {
        if (option.required && !given(option)) throw UsageError("\"" + plainName(option) + "\" is required");
        if (option.excludes.empty() || !given(option)) continue;
        const std::string other = option.excludes.substr(option.excludes.find_first_not_of('-'));
        if (given(optionOf(other, command)))
            throw UsageError("\"" + plainName(option) + "\" excludes \"" + other + "\"");
    }
}

}  // namespace

std::string plainName(const OptionSpec& option) {
    const std::string longName = option.longName();
    if (!option.positional()) return longName.substr(longName.find_first_not_of('-'));
    std::string name = option.names;
    std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
    return name;
}

OptionSpec recorded(OptionSpec option, std::vector<OptionValue>& values) {
    option.set = [name = plainName(option), set = option.set, &values](const std::string& value) {
        set(value);
        values.push_back({name, value});
    };
    return option;
}

std::vector<OptionValue> optionValuesOf(const std::string& json, const CommandSpec& command) {
    std::string twice;
    Json object;
    try {
        object = parseJson<Json>(json, twice);
    } catch (const std::invalid_argument& error) {
        throw UsageError(error.what());
    }
    if (!object.is_object()) throw UsageError("it is no JSON object");
    if (!twice.empty()) refuse(twice, "it is there twice");
    std::vector<OptionValue> values;
    for (const auto& [key, value] : object.items()) {
        std::string name = key;
        std::replace(name.begin(), name.end(), '_', '-');
        if (name == "rules")
            addRules(values, value, command);
        else
            addValue(values, value, optionOf(name, command));
    }
    return values;
}

void setOptions(const CommandSpec& command, std::span<const OptionValue> values) {
    checkTogether(command, values);
    for (const OptionValue& value : values) {
        const OptionSpec& option = optionOf(value.name, command);
        if (option.repeatable || option.pair) set(option, value.value);
    }
    for (const OptionSpec& option : command.options) {
        if (option.repeatable || option.pair) continue;
        const auto last = std::find_if(values.rbegin(), values.rend(),
                                       [name = plainName(option)](const OptionValue& v) { return v.name == name; });
        if (last != values.rend()) set(option, last->value);
    }
}

}  // namespace nacre::app
