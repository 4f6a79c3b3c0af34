// The only file that knows CLI11.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <list>

#include "app/cli/command_spec.h"
#include "app/cli/option_words.h"
#include "app/download/database_id.h"
#include "engine/error.h"
#include "engine/molecule/nearest_word.h"

namespace nacre::app {
namespace {

std::string oneLine(std::string text) {
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
}

/// Rewords "--size: given more than once", "--look: expected NAME|FILE": CLI11 says "At Most 1 required but received 2"
/// and "1 required NAME|FILE missing".
std::string numberOfValues(const std::string& said) {
    constexpr std::string_view kNeeds = " required ", kMissing = " missing";
    const std::size_t colon = said.find(": "), needs = said.find(kNeeds), missing = said.rfind(kMissing);
    if (colon == std::string::npos) return said;
    const std::string option = said.substr(0, colon + 2);
    if (said.find("At Most 1") != std::string::npos) return option + "given more than once";
    if (needs == std::string::npos || missing == std::string::npos || missing < needs) return said;
    const std::size_t from = needs + kNeeds.size();
    return option + "expected " + said.substr(from, missing - from);
}

/// Sets an option, with CLI11's exception for an invalid value.
void take(const OptionSpec& option, const std::string& text) {
    try {
        option.set(text);
    } catch (const std::invalid_argument& error) {
        throw CLI::ValidationError(option.longName(), error.what());
    } catch (const Error& error) {
        throw CLI::ValidationError(option.longName(), error.what());
    }
}

/// An option always has one value, or two: CLI11's options with many values swallow the INPUT.
CLI::Option* addOption(CLI::App& app, const OptionSpec& option) {
    if (option.flag())
        return app.add_flag_callback(
            option.names, [&option] { take(option, ""); }, option.help);
    if (option.positional() && option.repeatable)
        return app.add_option_function<std::vector<std::string>>(
            option.names,
            [&option](const std::vector<std::string>& all) {
                for (const std::string& text : all) take(option, text);
            },
            option.help);
    if (option.pair)  // exactly two per use, so that the INPUT is not swallowed
        return app
            .add_option_function<std::vector<std::string>>(
                option.names,
                [&option](const std::vector<std::string>& two) {
                    if (two.size() != 2) throw CLI::ValidationError(option.longName(), "takes two values");
                    take(option, two[0] + "\n" + two[1]);
                },
                option.help)
            ->expected(2)
            ->allow_extra_args(false)
            ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
            ->trigger_on_parse();
    CLI::Option* added = app.add_option_function<std::string>(
        option.names, [&option](const std::string& text) { take(option, text); }, option.help);
    if (option.repeatable) added->multi_option_policy(CLI::MultiOptionPolicy::TakeLast)->trigger_on_parse();
    return added;
}

void addOptions(CLI::App& app, const CommandSpec& command) {
    app.footer(command.footer);
    for (const OptionSpec& option : command.options) {
        CLI::Option* added = addOption(app, option);
        if (!option.flag()) added->type_name(option.type)->default_str(option.fallback);
        if (option.required) added->required();
        if (!option.excludes.empty()) added->excludes(app.get_option(option.excludes));
    }
}

/// Whether a word is one of "on|off", or resembles one and is no file.
bool isOneOf(std::string_view choices, const std::string& word) {
    std::vector<std::string> known(1);
    for (const char c : choices)
        if (c == '|')
            known.emplace_back();
        else
            known.back() += c;
    if (std::ranges::find(known, word) != known.end()) return true;
    return !nearestWord(word, known).empty() && !std::filesystem::exists(word);
}

/// Adds the implied value after option names that have one. Changed words are stored in `made`.
void completeBare(const CommandSpec& command, std::vector<const char*>& words, std::list<std::string>& made) {
    for (std::size_t i = 0; i < words.size() && std::string_view(words[i]) != "--"; ++i)
        for (const OptionSpec& option : command.options) {
            if (option.bare.empty() || option.longName() != words[i]) continue;
            if (i + 1 < words.size() && isOneOf(option.type, words[i + 1])) continue;
            words[i] = made.emplace_back(option.longName() + "=" + option.bare).c_str();
        }
}

/// CLI11 reports unknown options together with all other unplaced words, in reverse order.
void refuseUnknown(const std::string& name, const CommandSpec& command, std::span<const char* const> words) {
    std::vector<std::string> known{"--help"};
    for (const OptionSpec& option : command.options)
        if (!option.positional()) known.push_back(option.longName());
    for (const std::string word : words) {
        if (word == "--") return;
        if (!word.starts_with("--")) continue;
        const std::string option = word.substr(0, word.find('='));
        if (std::find(known.begin(), known.end(), option) != known.end()) continue;
        throw UsageError("nacre" + (name.empty() ? "" : " " + name) + " has no option " + option +
                         optionHint(option, command));
    }
}

/// The first example of a command's help: "nacre info 1bna.pdb". Empty if there is none.
std::string firstExample(const CommandSpec& command) {
    const std::string begin = "  nacre " + command.name + " ";
    const std::size_t at = command.footer.find(begin);
    if (at == std::string::npos) return {};
    return command.footer.substr(at + 2, command.footer.find('\n', at) - at - 2);
}

/// ", for example: nacre info 1bna.pdb"
std::string example(const CommandSpec& command) {
    const std::string first = firstExample(command);
    return first.empty() ? first : ", for example: " + first;
}

/// "nacre render INPUT -o FILE [OPTION...]": the minimal command.
std::string formatUsage(const CommandSpec& command) {
    std::string usage = "nacre " + command.name;
    for (const OptionSpec& option : command.options)
        if (option.positional()) usage += " " + option.names;
    for (const OptionSpec& option : command.options)
        if (option.required && !option.positional())
            usage += " " + option.names.substr(0, option.names.find(',')) + " " + option.type;
    return usage + " [OPTION...]";
}

bool needsWords(const CommandSpec& command) {
    return std::any_of(command.options.begin(), command.options.end(),
                       [](const OptionSpec& option) { return option.required; });
}

bool looksLikeInput(const std::string& word) {
    std::error_code error;
    return word.find_first_of(".:/") != std::string::npos || std::filesystem::exists(word, error);
}

[[noreturn]] void refuseWord(const std::string& word, const std::vector<std::string>& commands) {
    std::string list;
    for (const std::string& command : commands) list += (list.empty() ? "" : ", ") + command;
    const std::string near = suggestion(word, commands), meant = near.empty() ? meantInput(word) : "",
                      input = looksLikeInput(word) ? word : meant;
    if (!input.empty())
        throw UsageError("a command comes before '" + input + "': `nacre view " + input + "` shows it, `nacre render " +
                         input + " -o picture.png` draws it, `nacre info " + input + "` summarises it");
    throw UsageError("no command '" + word + "'" + (near.empty() ? ": commands are " + list : near));
}

}  // namespace

std::string OptionSpec::longName() const {
    const std::size_t dashes = names.find("--");
    return dashes == std::string::npos ? names : names.substr(dashes);
}

ParsedCommand parseCommands(const CommandSpec& program, std::span<const CommandSpec> commands, int argc,
                            const char* const* argv) {
    CLI::App app(program.about, program.name);
    addOptions(app, program);
    std::vector<std::string> names;
    const std::span given(argv, static_cast<std::size_t>(argc));
    for (const CommandSpec& command : commands) {
        CLI::App& added = *app.add_subcommand(command.name, command.about);
        // CLI11 compares each option with all earlier ones: adding those of all commands doubles the time of `nacre
        // --help`.
        if (std::find(given.begin(), given.end(), command.name) != given.end()) addOptions(added, command);
        names.push_back(command.name);
    }

    std::vector<const char*> words(argv, argv + argc);
    ParsedCommand parsed;
    // `nacre help render` is `nacre render --help`.
    if (words.size() > 1 && std::string_view(words[1]) == "help") {
        words.erase(words.begin() + 1);
        words.resize(std::min<std::size_t>(words.size(), 2));
        words.push_back("--help");
    }
    const CommandSpec* chosen = &program;
    if (words.size() > 1 && words[1][0] != '-') {
        const auto at = std::find(names.begin(), names.end(), words[1]);
        if (at == names.end()) refuseWord(words[1], names);
        chosen = &commands[static_cast<std::size_t>(at - names.begin())];
        parsed.name = chosen->name;
    }
    std::list<std::string> made;
    completeBare(*chosen, words, made);
    if (words.size() > 1) refuseUnknown(parsed.name, *chosen, std::span(words).subspan(parsed.name.empty() ? 1 : 2));
    if (words.size() == 2 && needsWords(*chosen)) throw UsageError("usage: " + formatUsage(*chosen) + example(*chosen));
    try {
        app.parse(static_cast<int>(words.size()), words.data());
    } catch (const CLI::CallForHelp&) {
        parsed.help = app.help();
    } catch (const CLI::RequiredError& error) {
        throw UsageError(oneLine(error.what()) + example(*chosen));
    } catch (const CLI::ArgumentMismatch& error) {
        throw UsageError(numberOfValues(oneLine(error.what())));
    } catch (const CLI::ParseError& error) {
        throw UsageError(oneLine(error.what()));
    }
    // A command that follows an option of the program.
    for (const CLI::App* command : app.get_subcommands()) parsed.name = command->get_name();
    if (app.get_subcommands().size() > 1) throw UsageError("more than one command");
    return parsed;
}

}  // namespace nacre::app
