#pragma once
// Commands and their options as plain data, and the parser for them.

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "app/picture/usage_error.h"

namespace nacre::app {

struct OptionSpec {
    std::string names;     ///< "-o,--output"; for a positional argument: "INPUT"
    std::string type;      ///< of the value, for the help; empty: a flag
    std::string fallback;  ///< the default, for the help
    std::string help;
    /// Sets the value; a flag gets an empty one. @throws std::invalid_argument or Error for an invalid value
    std::function<void(const std::string&)> set;
    bool required = false;
    bool repeatable = false;    ///< applied on each use, before all options that are not repeatable
    std::string bare = {};      ///< value if only the name is given; otherwise a value of its type follows, "on|off"
    bool pair = false;          ///< takes two values; set() gets them separated by a line end
    std::string excludes = {};  ///< the name of another option
    std::vector<std::string> choices = {};  ///< words that it accepts among others, for completion

    bool positional() const { return names.front() != '-'; }
    bool flag() const { return type.empty() && !positional(); }
    /// "--output"
    std::string longName() const;
};

struct CommandSpec {
    std::string name, about;
    std::string footer;  ///< of the help
    std::vector<OptionSpec> options = {};

    /// @returns a reference that is valid until the next add()
    OptionSpec& add(OptionSpec option) {
        options.push_back(std::move(option));
        return options.back();
    }
    /// An option with one value.
    OptionSpec& value(const std::string& names, const std::string& type, const std::string& fallback,
                      const std::string& help, std::function<void(const std::string&)> set) {
        return add({names, type, fallback, help, std::move(set)});
    }
    void flag(const std::string& names, bool& target, const std::string& help) {
        add({names, "", "", help, [&target](const std::string&) { target = true; }});
    }
};

struct ParsedCommand {
    std::string name;  ///< of the command; empty: none given
    std::string help;  ///< not empty: help was requested; its text
};

/// Parses a command line. Options are applied in the order of the specification.
/// @param program  options allowed before the command @throws UsageError
ParsedCommand parseCommands(const CommandSpec& program, std::span<const CommandSpec> commands, int argc,
                            const char* const* argv);

}  // namespace nacre::app
