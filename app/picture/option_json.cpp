#include "app/picture/option_json.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/files/json_text.h"
#include "engine/error.h"
#include "engine/molecule/nearest_word.h"

namespace nacre::app {
namespace {

using JobJson = nlohmann::ordered_json;
using Kind = Option::Kind;

const Option& wantedOption(const std::string& key, const std::string& who) {
    if (const Option* found = findOption(key)) return *found;
    std::vector<std::string> keys;
    for (const Option& option : options())
        if (has(kEveryTopic, option.topic)) keys.emplace_back(option.key);
    throw UsageError(who + " has no option \"" + key + "\"" + suggestion(key, keys));
}

[[noreturn]] void refuseKey(std::string_view key, const std::string& why) {
    throw UsageError("\"" + std::string(key) + "\": " + why);
}

/// A value for a message; of a long one only the beginning.
std::string shownJson(const JobJson& value) {
    constexpr std::size_t kMost = 60, kMostEntries = 8;
    if (value.is_structured() && value.size() > kMostEntries)
        return (value.is_array() ? "a list of " : "an object of ") + std::to_string(value.size()) + " entries";
    const std::string text = value.dump(-1, ' ', true, JobJson::error_handler_t::replace);
    return text.size() > kMost ? text.substr(0, kMost) + "..." : text;
}

/// Whether an option's syntax has a word as an alternative: "off" of "angstrom|nm|off".
bool takesWord(const Option& option, std::string_view word) {
    const std::string words = "|" + std::string(option.syntax) + "|";
    return words.find("|" + std::string(word) + "|") != std::string::npos;
}

/// The text that switches an option on or off, if there is one.
std::optional<std::string> switchText(bool on, const Option& option) {
    if (!takesOff(option)) return std::nullopt;
    if (!on) return takesWord(option, "off") ? "off" : "hide";
    for (const char* word : {"on", "auto", "show"})
        if (takesWord(option, word)) return word;
    // "dashed|off": the first word.
    const std::string word(option.syntax.substr(0, option.syntax.find('|')));
    if (std::ranges::all_of(word, [](char c) { return c >= 'a' && c <= 'z'; })) return word;
    const std::string usual = option.standard == "=" ? option.value.print(PictureDescription{}) : option.standard;
    const bool number = !usual.empty() && usual.front() >= '0' && usual.front() <= '9';
    return number ? std::optional(usual) : std::nullopt;
}

/// A text, a number, or a group of numbers: [640, 480] is "640x480" for a size, and "640,480" otherwise.
std::string jobText(const JobJson& value, const Option& option) {
    if (value.is_string()) return value.get<std::string>();
    const bool file = option.positional || option.syntax.find("FILE") != std::string::npos ||
                      option.syntax.find("DIR") != std::string::npos;
    if (file) refuseKey(option.key, "expected a text, not " + shownJson(value));
    if (value.is_number()) return value.dump();
    if (value.is_boolean())
        if (const auto text = switchText(value.get<bool>(), option)) return *text;
    constexpr std::size_t kMostNumbers = 16;  // of any option
    if (value.is_array() && !value.empty() && value.size() <= kMostNumbers &&
        std::all_of(value.begin(), value.end(), [](const JobJson& number) { return number.is_number(); })) {
        std::string text;
        for (const JobJson& number : value)
            text += (text.empty() ? "" : option.syntax == "WxH" ? "x" : ",") + number.dump();
        return text;
    }
    refuseKey(option.key, "expected a text or a number, not " + shownJson(value));
}

void addJobValue(std::vector<OptionValue>& values, const JobJson& value, const Option& option) {
    const std::string key(option.key);
    if (value.is_null()) return;
    if (option.kind == Kind::flag) {
        if (!value.is_boolean()) refuseKey(key, "expected true or false");
        if (value.get<bool>()) values.push_back({key, ""});
    } else if (option.kind == Kind::pair) {
        // ["SEL", "SEL"], or a list of these.
        if (value.is_array() && !value.empty() && value[0].is_array()) {
            for (const JobJson& two : value) addJobValue(values, two, option);
            return;
        }
        if (!value.is_array() || value.size() != 2) refuseKey(key, "expected two values");
        values.push_back({key, jobText(value[0], option) + "\n" + jobText(value[1], option)});
    } else if (option.kind == Kind::list && value.is_array()) {
        for (const JobJson& one : value) values.push_back({key, jobText(one, option)});
    } else {
        values.push_back({key, jobText(value, option)});
    }
}

void addJobRules(std::vector<OptionValue>& values, const JobJson& rules, const std::string& who) {
    if (!rules.is_array()) refuseKey("rules", "expected a list");
    for (const JobJson& rule : rules) {
        if (!rule.is_object() || rule.size() != 1) refuseKey("rules", "expected each rule as {\"option\": \"value\"}");
        const Option& option = wantedOption(rule.begin().key(), who);
        if (option.kind != Kind::list) refuseKey("rules", "\"" + rule.begin().key() + "\" is not a rule");
        values.push_back({rule.begin().key(), jobText(rule.begin().value(), option)});
    }
}

void setJobOption(const Option& option, const std::string& value, PictureDescription& description) {
    const std::string key(option.key);
    // File names would end there.
    if (value.find('\0') != std::string::npos) throw UsageError(key + ": it contains a NUL character");
    try {
        setOption(option, value, description);
    } catch (const std::invalid_argument& error) {
        throw UsageError(key + ": " + error.what());
    } catch (const Error& error) {
        throw UsageError(key + ": " + error.what());
    }
}

void checkTogether(std::span<const OptionValue> values) {
    const auto isGiven = [&](std::string_view key) {
        return std::ranges::any_of(values, [&](const OptionValue& v) { return v.key == key; });
    };
    for (const Option& option : options()) {
        if (!option.excludes.empty() && isGiven(option.key) && isGiven(option.excludes))
            throw UsageError("\"" + std::string(option.key) + "\" excludes \"" + std::string(option.excludes) + "\"");
    }
}

bool isRepeated(const Option& option) { return option.kind == Kind::list || option.kind == Kind::pair; }

}  // namespace

bool takesOff(const Option& option) { return takesWord(option, "off") || takesWord(option, "hide"); }

std::vector<OptionValue> parseOptionValues(const std::string& json, const std::string& who) {
    std::string twice;
    JobJson object;
    try {
        object = parseJson<JobJson>(json, twice);
    } catch (const std::invalid_argument& error) {
        throw UsageError(error.what());
    }
    if (!object.is_object()) throw UsageError("it is not a JSON object");
    if (!twice.empty()) refuseKey(twice, "it occurs twice");
    std::vector<OptionValue> values;
    for (const auto& [name, value] : object.items()) {
        std::string key = name;
        std::replace(key.begin(), key.end(), '_', '-');
        if (key == "rules")
            addJobRules(values, value, who);
        else
            addJobValue(values, value, wantedOption(key, who));
    }
    return values;
}

void setOptions(std::span<const OptionValue> values, PictureDescription& description) {
    checkTogether(values);
    for (const OptionValue& value : values)
        if (const Option& option = wantedOption(value.key, "nacre"); isRepeated(option))
            setJobOption(option, value.value, description);
    for (const Option& option : options()) {
        if (isRepeated(option) || !has(kEveryTopic, option.topic)) continue;
        const auto last =
            std::find_if(values.rbegin(), values.rend(), [&](const OptionValue& v) { return v.key == option.key; });
        if (last != values.rend()) setJobOption(option, last->value, description);
    }
}

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
