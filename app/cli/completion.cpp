// Shell completions. Each script is self-contained: it does not run nacre during typing.

#include <algorithm>

#include "app/cli/option_words.h"

namespace nacre::app {
namespace {

std::string wordList(const std::vector<std::string>& words, const char* between) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
    return text;
}

std::vector<std::string> completionWords(const CommandSpec& command) {
    std::vector<std::string> names;
    for (const OptionSpec& option : command.options)
        for (std::string& name : writtenNames(option)) names.push_back(std::move(name));
    names.emplace_back("--help");
    return names;
}

std::vector<std::string> commandWords(std::span<const CommandSpec> commands) {
    std::vector<std::string> names;
    for (const CommandSpec& command : commands) names.push_back(command.name);
    names.emplace_back("help");
    return names;
}

/// The first line, without characters that are special in shells.
std::string plainHelp(const std::string& help) {
    std::string text = help.substr(0, help.find('\n'));
    std::erase_if(text, [](char c) { return std::string_view("'\"`$\\[]{}").find(c) != std::string_view::npos; });
    std::replace(text.begin(), text.end(), ':', ',');
    return text;
}

const OptionSpec* findPositional(const CommandSpec& command) {
    for (const OptionSpec& option : command.options)
        if (option.positional()) return &option;
    return nullptr;
}

std::string bashScript(const CommandSpec& program, std::span<const CommandSpec> commands) {
    const std::string all = wordList(commandWords(commands), " ");
    std::string script =
        "# Completion of nacre for bash: source <(nacre completion bash)\n_nacre() {\n"
        "    local current=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} command= i\n"
        "    for ((i = 1; i < COMP_CWORD; ++i)); do\n"
        "        case ${COMP_WORDS[i]} in\n            " +
        wordList(commandWords(commands), "|") +
        ") command=${COMP_WORDS[i]}; break ;;\n        esac\n    done\n    COMPREPLY=()\n"
        "    case \"$command $before\" in\n";
    std::vector<std::string> files, lists, others;
    for (const CommandSpec& command : commands)
        for (const OptionSpec& option : command.options) {
            if (option.flag() || option.positional()) continue;
            std::vector<std::string> patterns;
            for (const std::string& name : writtenNames(option))
                patterns.push_back("'" + command.name + " " + name + "'");
            const std::vector<std::string> choices = listChoices(option);
            if (takesFiles(option))
                lists.push_back(wordList(patterns, "|"));
            else if (choices.empty())
                (takesFile(option) ? files : others).push_back(wordList(patterns, "|"));
            else
                script += "        " + wordList(patterns, "|") + ")\n            COMPREPLY=($(compgen " +
                          (takesFile(option) ? "-f " : "") + "-W '" + wordList(choices, " ") +
                          "' -- \"$current\"))\n            return ;;\n";
        }
    if (!others.empty()) script += "        " + wordList(others, "|\\\n        ") + ")\n            return ;;\n";
    if (!files.empty())
        script +=
            "        " + wordList(files, "|\\\n        ") +
            ")\n            compopt -o filenames 2>/dev/null\n            COMPREPLY=($(compgen -f -- \"$current\"))\n"
            "            return ;;\n";
    if (!lists.empty())
        script +=
            "        " + wordList(lists, "|\\\n        ") +
            ")\n            COMPREPLY=($(compgen -f -P \"${current%\"${current##*,}\"}\" -- \"${current##*,}\"))\n"
            "            return ;;\n";
    script += "        'help '*)\n            COMPREPLY=($(compgen -W '" + all + " " + wordList(helpTopicNames(), " ") +
              "' -- \"$current\"))\n            return ;;\n    esac\n    local words=\n    case $command in\n        "
              "'') words='" +
              all + " " + wordList(completionWords(program), " ") + "' ;;\n";
    for (const CommandSpec& command : commands)
        script += "        " + command.name + ") words='" + wordList(completionWords(command), " ") + "' ;;\n";
    script +=
        "    esac\n    if [[ $current == -* || -z $command ]]; then\n"
        "        COMPREPLY=($(compgen -W \"$words\" -- \"$current\"))\n";
    for (const CommandSpec& command : commands)
        if (const OptionSpec* input = findPositional(command))
            if (const std::vector<std::string> choices = listChoices(*input); !choices.empty())
                script += "    elif [[ $command == " + command.name + " ]]; then\n        COMPREPLY=($(compgen -W '" +
                          wordList(choices, " ") + "' -- \"$current\"))\n";
    script +=
        "    else\n        compopt -o filenames 2>/dev/null\n        COMPREPLY=($(compgen -f -- \"$current\"))\n"
        "    fi\n}\ncomplete -F _nacre nacre\n";
    return script;
}

std::string zshValue(const OptionSpec& option) {
    if (option.flag()) return "";
    const std::vector<std::string> choices = listChoices(option);
    const std::string what = ":" + plainHelp(option.positional() ? option.names : option.type) + ":";
    const std::string words = "(" + wordList(choices, " ") + ")";
    if (takesFiles(option)) return what + "_sequence _files";
    if (!choices.empty() && takesFile(option))
        return what + "{_alternative \"words\\:word\\:" + words + "\" \"files\\:file\\:_files\"}";
    if (!choices.empty()) return what + words;
    return what + (takesFile(option) || option.positional() ? "_files" : " ");
}

std::string zshArguments(const CommandSpec& command) {
    std::string text;
    for (const OptionSpec& option : command.options) {
        if (option.positional()) {
            text += " \\\n                '" + std::string(option.repeatable ? "*" : "1") + zshValue(option) + "'";
            continue;
        }
        for (const std::string& name : writtenNames(option))
            text += " \\\n                '" + std::string(option.repeatable ? "*" : "") + name + "[" +
                    plainHelp(option.help) + "]" + zshValue(option) + "'";
    }
    return text + " \\\n                '--help[Options and examples]'";
}

std::string zshScript(const CommandSpec& program, std::span<const CommandSpec> commands) {
    std::string script =
        "#compdef nacre\n# Completion of nacre for zsh: source <(nacre completion zsh), after compinit\n"
        "_nacre() {\n    local curcontext=$curcontext state line\n    local -a commands\n    commands=(\n";
    for (const CommandSpec& command : commands)
        script += "        '" + command.name + ":" + plainHelp(command.about) + "'\n";
    script += "        'help:Explain a command or a topic'\n    )\n    _arguments -C \\\n";
    for (const OptionSpec& option : program.options)
        script += "        '" + option.longName() + "[" + plainHelp(option.help) + "]' \\\n";
    script +=
        "        '1: :->command' '*:: :->rest' && return\n    case $state in\n"
        "        command) _describe command commands ;;\n        rest)\n            case $line[1] in\n";
    for (const CommandSpec& command : commands)
        script += "            " + command.name + ")\n                _arguments" + zshArguments(command) + " ;;\n";
    std::vector<std::string> topics = commandWords(commands);
    for (const std::string& topic : helpTopicNames()) topics.push_back(topic);
    script += "            help) _values topic " + wordList(topics, " ") +
              " ;;\n            esac ;;\n    esac\n}\n"
              "if [[ $funcstack[1] == _nacre ]]; then _nacre \"$@\"; else compdef _nacre nacre; fi\n";
    return script;
}

std::string fishScript(const CommandSpec& program, std::span<const CommandSpec> commands) {
    std::string script = "# Completion of nacre for fish: nacre completion fish | source\n";
    const std::string begin = "complete -c nacre -n __fish_use_subcommand";
    script += begin + " -f\n";
    for (const CommandSpec& command : commands)
        script += begin + " -a " + command.name + " -d '" + plainHelp(command.about) + "'\n";
    script += begin + " -a help -d 'Explain a command or a topic'\n";
    for (const OptionSpec& option : program.options)
        script += begin + " -l " + option.longName().substr(2) + " -d '" + plainHelp(option.help) + "'\n";
    script += "complete -c nacre -n '__fish_seen_subcommand_from help' -f -a '" +
              wordList(commandWords(commands), " ") + " " + wordList(helpTopicNames(), " ") + "'\n";
    for (const CommandSpec& command : commands) {
        const std::string seen = "complete -c nacre -n '__fish_seen_subcommand_from " + command.name + "'";
        for (const OptionSpec& option : command.options) {
            if (option.positional()) {
                if (const std::vector<std::string> choices = listChoices(option); !choices.empty())
                    script += seen + " -f -a '" + wordList(choices, " ") + "'\n";
                continue;
            }
            script += seen;
            for (const std::string& name : writtenNames(option))
                script += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
            const std::vector<std::string> choices = listChoices(option);
            if (takesFiles(option))
                script += " -x -a '(__fish_complete_list , __fish_complete_path)'";
            else if (!choices.empty())
                script += (takesFile(option) ? " -r -F -a '" : " -x -a '") + wordList(choices, " ") + "'";
            else if (!option.flag())
                script += takesFile(option) ? " -r -F" : " -x";
            script += " -d '" + plainHelp(option.help) + "'\n";
        }
    }
    return script;
}

}  // namespace

std::string completionScript(const std::string& shell, const CommandSpec& program,
                             std::span<const CommandSpec> commands) {
    if (shell == "bash") return bashScript(program, commands);
    if (shell == "zsh") return zshScript(program, commands);
    if (shell == "fish") return fishScript(program, commands);
    throw UsageError("completion: expected bash, zsh or fish, not '" + shell + "'");
}

}  // namespace nacre::app
