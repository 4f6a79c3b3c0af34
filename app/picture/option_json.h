#pragma once
// Options from JSON: batch jobs and Python's arguments. Same table, values and messages as on the command line. Also
// the table as JSON Schema, for pages that offer options, and for programs that check requests.

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "app/picture/options.h"
#include "app/picture/usage_error.h"

namespace nacre::app {

/// An option as written.
struct OptionValue {
    std::string key;
    std::string value;  ///< of a flag: empty
};

/// Parses a JSON object of options. '_' in keys stands for '-'; values are texts, numbers, booleans (flags, and off),
/// lists of numbers (such as sizes and angles), lists (repeatable options) and pairs (options with two values).
/// "rules" is a list as in saved views: [{"show": "ligand=licorice"}, {"hide": "chain B"}]. null means not given.
/// @param who  accepts no other options, for messages @throws UsageError
std::vector<OptionValue> parseOptionValues(const std::string& json, const std::string& who = "nacre render");

/// Whether false switches an option off.
bool takesOff(const Option& option);

/// Sets options as one command line would, in any order; if an option that is not repeatable occurs twice, the last one
/// wins. @throws UsageError
void setOptions(std::span<const OptionValue> values, PictureDescription& description);

/// JSON Schema of an object of options, with the form of each value in "x-syntax" and some values in "examples".
/// @param has  whether an option is included
std::string optionSchema(const std::string& title, const std::function<bool(const Option&)>& has);

}  // namespace nacre::app
