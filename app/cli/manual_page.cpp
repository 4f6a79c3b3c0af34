// The manual page, from the options themselves.

#include <sstream>

#include "app/cli/option_words.h"

namespace nacre::app {
namespace {

/// Text that man(7) shows as it stands; dashes are minus signs, to be searched for and copied.
std::string roff(const std::string& text) {
    std::string out;
    bool lineStart = true;
    for (const char c : text) {
        if (lineStart && (c == '.' || c == '\'')) out += "\\&";
        if (c == '\\')
            out += "\\e";
        else if (c == '-')
            out += "\\-";
        else if (c == '\'')
            out += "\\(aq";
        else if (c == '`')
            out += "\\(ga";
        else if (c == '^')
            out += "\\(ha";
        else if (c == '~')
            out += "\\(ti";
        else
            out += c;
        lineStart = c == '\n';
    }
    return out;
}

/// As above in one paragraph: joins lines.
std::string roffFlow(std::string text) {
    for (char& c : text)
        if (c == '\n') c = ' ';
    return roff(text);
}

void addRoffOption(std::ostringstream& page, const OptionSpec& option) {
    page << ".TP\n";
    std::string names;
    if (option.positional()) names = "\\fI" + option.names + "\\fR" + (option.repeatable ? " ..." : "");
    for (const std::string& name : writtenNames(option))
        names += (names.empty() ? "\\fB" : ", \\fB") + roff(name) + "\\fR";
    page << names;
    if (!option.type.empty()) page << " \\fI" << roff(option.type) << "\\fR";
    page << '\n' << roffFlow(option.help) << (option.help.ends_with('.') ? "" : ".");
    if (!option.fallback.empty()) page << " Default: " << roffFlow(option.fallback) << '.';
    page << '\n';
}

/// Examples and environment with their layout.
void addRoffLines(std::ostringstream& page, const std::string& text) {
    if (text.empty()) return;
    page << ".nf\n";
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) page << (line.empty() ? "\\&" : roff(line)) << '\n';
    page << ".fi\n";
}

std::string synopsisOf(const CommandSpec& command) {
    std::string text = "\\fBnacre " + command.name + "\\fR";
    for (const OptionSpec& option : command.options)
        if (option.positional()) text += " \\fI" + option.names + "\\fR" + (option.repeatable ? " ..." : "");
    return text + " [\\fIOPTION\\fR]...";
}

}  // namespace

std::string manualPage(const CommandSpec& program, std::span<const CommandSpec> commands) {
    std::ostringstream page;
    page << ".TH NACRE 1 \"\" \"nacre\" \"User Commands\"\n"
         << ".SH NAME\nnacre \\- draw molecules\n.SH SYNOPSIS\n";
    for (const CommandSpec& command : commands)
        page << (&command == &commands.front() ? "" : ".br\n") << synopsisOf(command) << '\n';
    page << ".SH DESCRIPTION\n"
         << roffFlow(program.about)
         << " It reads PDB, mmCIF and other structure files, works out the bonds, and draws on Vulkan, with or without "
            "a "
            "GPU. \\fBnacre help\\fR \\fITOPIC\\fR explains: "
         <<
        [] {
            std::string names;
            for (const std::string& name : helpTopicNames()) names += (names.empty() ? "" : ", ") + name;
            return names;
        }()
         << ".\n";
    for (const OptionSpec& option : program.options) addRoffOption(page, option);
    page << ".SH COMMANDS\n";
    for (const CommandSpec& command : commands) {
        page << ".SS nacre " << command.name << '\n' << roffFlow(command.about) << ".\n";
        for (const OptionSpec& option : command.options) addRoffOption(page, option);
        if (!command.footer.empty()) page << ".PP\n";
        addRoffLines(page, command.footer);
    }
    page << ".SH EXIT STATUS\n.TP\n0\nDone.\n.TP\n1\nFailed, with one line on standard error.\n.TP\n2\nWrong usage.\n"
         << ".SH EXAMPLES AND ENVIRONMENT\n";
    addRoffLines(page, program.footer);
    return page.str();
}

}  // namespace nacre::app
