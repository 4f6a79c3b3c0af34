#pragma once
// Other uses of commands and their options besides parsing: shell completions, the manual page, help topics.

#include <span>
#include <string>
#include <vector>

#include "app/cli/command_spec.h"

namespace nacre::app {

/// Every spelling of an option: "-o", "--output".
std::vector<std::string> writtenNames(const OptionSpec& option);

/// The values that can be listed: both of "on|off", otherwise the words of the option's help that it accepts, unless it
/// accepts any word. Sets the option repeatedly.
std::vector<std::string> listChoices(const OptionSpec& option);

/// A suggestion for an unknown option: " (did you mean '--color'?)", or empty. Considers other programs' names, the
/// nearest name, names that contain it, and options that accept it as a value. Sets options.
std::string optionHint(const std::string& written, const CommandSpec& command);

/// Whether its value is a file or a folder.
bool takesFile(const OptionSpec& option);
/// Whether its value is several files, separated by commas.
bool takesFiles(const OptionSpec& option);

/// A script for bash, zsh or fish. @throws UsageError for another shell
std::string completionScript(const std::string& shell, const CommandSpec& program,
                             std::span<const CommandSpec> commands);

/// The manual page, in the macros of man(7).
std::string manualPage(const CommandSpec& program, std::span<const CommandSpec> commands);

/// docs/reference.md: every option of a picture.
std::string referencePage();
/// One line per keyword argument of Python's render(), with its type.
std::string pythonKeywords();

/// Output of `nacre help TOPIC`. @throws UsageError if there is no such topic or command
std::string helpTopic(const std::string& topic, std::span<const CommandSpec> commands);
std::vector<std::string> helpTopicNames();
bool isHelpTopic(const std::string& name);

}  // namespace nacre::app
