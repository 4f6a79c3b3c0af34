#pragma once
// Options from JSON: jobs of a batch, Python's arguments. The same table, values and messages as the command line's.

#include <span>
#include <string>
#include <vector>

#include "app/picture/options.h"
#include "app/picture/usage_error.h"

namespace nacre::app {

/// An option as it was written.
struct OptionValue {
    std::string key;
    std::string value;  ///< of a flag: empty
};

/// What a JSON object says. Its keys are those of options, '_' standing for '-'; values are texts, numbers, of flags
/// and on|off booleans, of a size, an angle and their like also lists of numbers, and of what may be repeated lists, of
/// what takes two values pairs. "rules" is a list as saved views have it: [{"show": "ligand=licorice"}, {"hide":
/// "chain B"}]. null stands for what is left out. @param who  has no other option, for messages @throws UsageError
std::vector<OptionValue> optionValuesOf(const std::string& json, const std::string& who = "nacre render");

/// Sets options as one command line with all of these would, whatever their order; of what may not be repeated the last
/// one holds. @throws UsageError
void setOptions(std::span<const OptionValue> values, PictureDescription& description);

}  // namespace nacre::app
