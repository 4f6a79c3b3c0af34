#pragma once
// What else than the parser is made from commands and their options: completions of shells, the manual page, help
// topics.

#include <span>
#include <string>
#include <vector>

#include "app/cli/command_spec.h"

namespace nacre::app {

/// Every way to write an option: "-o", "--output".
std::vector<std::string> writtenNames(const OptionSpec& option);

/// The values that can be listed: of "on|off" both, otherwise the words of the option's help that it takes, unless it
/// takes any word whatever. Sets the option, again and again.
std::vector<std::string> choicesOf(const OptionSpec& option);

/// " (did you mean '--color'?)", or nothing: what was probably meant by an option that a command lacks. What other
/// programs call so, the nearest name, the names that it is a part of, or the options that take it as a value. Sets
/// options.
std::string optionHint(const std::string& written, const CommandSpec& command);

/// Whether its value is a file or a folder.
bool takesFile(const OptionSpec& option);
/// Whether it is several, with commas between them.
bool takesFiles(const OptionSpec& option);

/// A script for bash, zsh or fish. @throws UsageError if it is another shell
std::string completionScript(const std::string& shell, const CommandSpec& program,
                             std::span<const CommandSpec> commands);

/// The manual page, in the macros of man(7).
std::string manualPage(const CommandSpec& program, std::span<const CommandSpec> commands);

/// docs/reference.md: every option of a picture.
std::string referencePage();
/// A line for each keyword argument of Python's render(), with its type.
std::string pythonKeywords();

/// What `nacre help TOPIC` says. @throws UsageError if there is no such topic or command
std::string helpTopic(const std::string& topic, std::span<const CommandSpec> commands);
std::vector<std::string> helpTopicNames();
bool isHelpTopic(const std::string& name);

}  // namespace nacre::app
