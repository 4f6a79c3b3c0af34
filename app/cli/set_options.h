#pragma once
// Options from elsewhere than the command line: the same table, the same values, the same words for what is wrong.

#include <span>
#include <string>
#include <vector>

#include "app/cli/command_spec.h"

namespace nacre::app {

/// An option as it was written.
struct OptionValue {
    std::string name;   ///< without dashes; "input" for INPUT
    std::string value;  ///< of a flag: empty
};

/// The name of an option as JSON and Python have it: "output" of "-o,--output", "input" of "INPUT".
std::string plainName(const OptionSpec& option);

/// An option that notes what it is given, once it has taken it. @param values  outlive it
OptionSpec recorded(OptionSpec option, std::vector<OptionValue>& values);

/// What a JSON object says of a command's options. Its keys are their names, '_' standing for '-'; values are texts,
/// numbers, of flags and on|off booleans, of a size, an angle and their like also lists of numbers, and of what may be
/// repeated lists, of what takes two values those. "rules" is a list as saved views have it: [{"show":
/// "ligand=licorice"}, {"hide": "chain B"}]. null stands for what is left out. @throws UsageError
std::vector<OptionValue> optionValuesOf(const std::string& json, const CommandSpec& command);

/// Sets options as one command line with all of these would; of what may not be repeated the last one holds.
/// @throws UsageError
void setOptions(const CommandSpec& command, std::span<const OptionValue> values);

}  // namespace nacre::app
