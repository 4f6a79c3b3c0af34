#pragma once
// Commands and their options as plain data, and what reads a command line by them.

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "app/picture/usage_error.h"

namespace nacre::app {

struct OptionSpec {
    std::string names;     ///< "-o,--output"; of what stands without a name: "INPUT"
    std::string type;      ///< of the value, for the help; empty: a flag
    std::string fallback;  ///< for the help: what holds without it
    std::string help;
    /// Takes the value; of a flag an empty one. @throws std::invalid_argument or Error for what it does not take
    std::function<void(const std::string&)> set;
    bool required = false;
    bool repeatable = false;    ///< each is taken as it is met, before all that is not repeatable
    std::string bare = {};      ///< value that its name alone stands for; else one of its type follows, "on|off"
    bool pair = false;          ///< takes two values; set() gets them with a line's end between
    std::string excludes = {};  ///< the name of another option
    std::vector<std::string> choices = {};  ///< words that it takes beside others, for completion

    bool positional() const { return names.front() != '-'; }
    bool flag() const { return type.empty() && !positional(); }
    /// "--output"
    std::string longName() const;
};

struct CommandSpec {
    std::string name, about;
    std::string footer;  ///< of the help
    std::vector<OptionSpec> options = {};

    /// @returns what holds until the next is added
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
    std::string name;  ///< of the command; empty: none was given
    std::string help;  ///< not empty: it was asked for, and this is it
};

/// Reads a command line: options in the order in which they are specified, whatever their order in it.
/// @param program  what may stand before a command @throws UsageError
ParsedCommand parseCommands(const CommandSpec& program, std::span<const CommandSpec> commands, int argc,
                            const char* const* argv);

}  // namespace nacre::app
