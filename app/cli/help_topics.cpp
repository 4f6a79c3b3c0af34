// `nacre help TOPIC`: a text about several options, and those options' own help. An option's name is also a topic.

#include <algorithm>
#include <initializer_list>
#include <sstream>

#include "app/cli/option_words.h"
#include "app/mvs/node_table.h"
#include "app/picture/option_json.h"
#include "app/picture/options.h"
#include "engine/error.h"
#include "engine/molecule/nearest_word.h"

namespace nacre::app {
namespace {

struct HelpTopic {
    const char* name;
    const char* text;
    Topics topics;  ///< of the options of `render` that are shown with it
};

constexpr HelpTopic kTopics[] = {
    {"selections",
     "A selection names atoms. SEL in the help of an option stands for one.\n\n"
     "  chain A+B   resn HEM+ATP   resi 10-20+35   name CA+CB   elem FE   altloc A   model 1\n"
     "  protein  nucleic  polymer  ligand  mainligand  water  ion  backbone  sidechain  hydrogens\n"
     "  hetatm  all  none\n"
     "  /NAME   one of several INPUTs, named by `NAME=INPUT` or by its file (receptor.pdb: /receptor)\n"
     "  b > 50   occupancy < 1   ss helix   sequence GLN?A   /A:10-20@CA (as in ChimeraX)\n"
     "  and   or   not   ( )\n"
     "  within 5 of (SEL)   at most 5 Å away, SEL included; around 5 of (SEL): without SEL\n"
     "  byres (SEL)         its whole residues\n\n"
     "Rules apply in the given order, the last one wins:\n"
     "  nacre render 1hpv.pdb -o a.png --style licorice --hide water --show ligand=spacefill\n",
     static_cast<Topics>(Topic::rules)},
    {"colors",
     "A colour is a scheme, which colours each atom by a property, or a single colour: a CSS name (navy, lightgray), "
     "#rgb\n"
     "or #rrggbb; for backgrounds also #rrggbbaa. element:COLOR colours carbons in COLOR, other atoms by element.\n",
     Topic::color | Topic::background},
    {"styles", "A style says how atoms are drawn, all of them (--style) or those of a selection (--show).\n",
     Topic::style | Topic::mesh | Topic::levels | Topic::atoms | Topic::geometry},
    {"labels", "Text in the picture: labels, measurements, a legend, a scale bar and a title.\n",
     static_cast<Topics>(Topic::words)},
    {"interactions",
     "Interactions are drawn as dashed lines. `nacre info FILE --interactions SEL` lists them as text, CSV or JSON:\n"
     "  nacre render 1hpv.pdb -o a.png --pocket ligand\n"
     "  nacre info 1hpv.pdb --interactions ligand\n",
     static_cast<Topics>(Topic::interactions)},
    {"maps",
     "Density maps as contours, dots or slices. Options that may be repeated go by the order of the maps:\n"
     "  nacre render 3nzd.cif --map 3nzd.ccp4.gz --map 3nzd_diff.ccp4.gz --map-around ligand -o a.png\n",
     static_cast<Topics>(Topic::map)},
    {"formats",
     "The format of a structure file is recognised by its content, else by its ending; it may be compressed (gzip, xz, "
     "bzip2, "
     "zstd).\n"
     "INPUT may also be a built-in sample or a download. The ending of a picture file decides its format.\n",
     Topic::input | Topic::reading | Topic::trajectory | Topic::fit | Topic::files},
    {"views",
     "At zoom 1 the molecule's sphere fills 95 % of the shorter side. Rotations are right-handed, about the view's "
     "axes:\n"
     "x to the right, y up, z towards the viewer. `Shift S` in the window saves a view as JSON, whose keys are the\n"
     "options' names; `render --view` and `movie --views` draw it. Its molecule may be in the same folder.\n",
     Topic::view | Topic::camera | Topic::aim | Topic::size},
    {"light",
     "Ambient occlusion is computed once per molecule and style, and cached on disk if that took 50 ms or more.\n",
     Topic::look | Topic::lighting | Topic::occlusion | Topic::detail | Topic::effects | Topic::samples},
    {"devices", "Any Vulkan driver works; Mesa's lavapipe needs no GPU. `nacre devices` lists the devices.\n",
     Topic::device | Topic::path | Topic::frame | Topic::validation},
};

/// An option as in --help, already wrapped.
std::string described(const OptionSpec& option) {
    std::string text = "  " + option.names + (option.type.empty() ? "" : " " + option.type);
    if (!option.fallback.empty()) text += " [" + option.fallback + "]";
    text += "\n      ";
    for (const char c : option.help) text += c == '\n' ? std::string("\n      ") : std::string(1, c);
    return text + "\n";
}

/// Options of that name, "--halos" or "halos". Options with equal texts are grouped after the commands that have them.
std::string optionsNamed(const std::string& name, std::span<const CommandSpec> commands) {
    const std::string longName = name.starts_with('-') ? name : "--" + name;
    std::vector<std::pair<std::string, std::string>> texts;  // with their commands
    for (const CommandSpec& command : commands)
        for (const OptionSpec& option : command.options) {
            const std::vector<std::string> written = writtenNames(option);
            if (std::find(written.begin(), written.end(), longName) == written.end()) continue;
            const std::string text = described(option);
            const auto known = std::ranges::find_if(texts, [&](const auto& other) { return other.first == text; });
            if (known == texts.end())
                texts.emplace_back(text, "nacre " + command.name);
            else
                known->second += ", " + command.name;
        }
    std::string all;
    for (const auto& [text, names] : texts) all += (all.empty() ? "" : "\n") + names + ":\n" + text;
    return all;
}

/// Escapes text for man(7). Dashes become minus signs, so that readers can search for and copy them.
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

std::string formatSynopsis(const CommandSpec& command) {
    std::string text = "\\fBnacre " + command.name + "\\fR";
    for (const OptionSpec& option : command.options)
        if (option.positional()) text += " \\fI" + option.names + "\\fR" + (option.repeatable ? " ..." : "");
    return text + " [\\fIOPTION\\fR]...";
}

struct ReferenceGroup {
    const char* title;
    Topics topics;
};
constexpr ReferenceGroup kReferenceGroups[] = {
    {"Input", Topic::input | Topic::reading},
    {"Trajectories and several inputs", Topic::trajectory | Topic::fit},
    {"Representation", Topic::style | Topic::atoms},
    {"Colours", Topic::color | Topic::background},
    {"Selections", static_cast<Topics>(Topic::rules)},
    {"Interactions", static_cast<Topics>(Topic::interactions)},
    {"Cartoons and surfaces", static_cast<Topics>(Topic::mesh)},
    {"Density maps", static_cast<Topics>(Topic::map)},
    {"Geometry beside the molecule", static_cast<Topics>(Topic::geometry)},
    {"Camera", Topic::camera | Topic::aim},
    {"Looks and saved views", Topic::look | Topic::view | Topic::thumbnail},
    {"Light and effects", Topic::lighting | Topic::effects},
    {"Ambient occlusion", Topic::occlusion | Topic::detail},
    {"Labels, legend, title", static_cast<Topics>(Topic::words)},
    {"Size and quality", Topic::size | Topic::samples | Topic::levels | Topic::paper},
    {"Files", static_cast<Topics>(Topic::files)},
    {"Device", Topic::device | Topic::path | Topic::frame | Topic::validation | Topic::debug},
};

std::string referenceEntry(const Option& option) {
    const PictureDescription plain;
    std::string text = option.positional ? "**`INPUT`**" : "**`--" + std::string(option.key);
    if (!option.positional) text += (option.syntax.empty() ? "" : " " + option.syntax) + "`**";
    const std::string standard = option.standard == "=" ? option.value.print(plain) : option.standard;
    if (!standard.empty()) text += " (default: " + standard + ")";
    std::string help = option.help;
    std::replace(help.begin(), help.end(), '\n', ' ');
    return text + "\\\n" + help + ".\n";
}

bool isKeyword(const Option& option) {
    return has(kEveryTopic & ~kReading & ~(Topic::files | Topic::view), option.topic);
}

bool takesAny(const Option& option, std::initializer_list<const char*> texts) {
    return std::ranges::any_of(texts, [&](const char* text) {
        try {
            PictureDescription tried;
            option.value.parse(text, tried);
            return true;
        } catch (const std::invalid_argument&) {
            return false;
        } catch (const Error&) {
            return false;
        }
    });
}

/// The Python type of one value of an option.
std::string valueType(const Option& option) {
    if (option.syntax.find("FILE") != std::string::npos) return "str | PathLike[str]";
    if (option.syntax.starts_with("SEL=")) return "str | tuple[str | Mask, str]";
    if (option.key == "measure") return "str | tuple[str | Mask | int, ...]";
    std::string type = "str";
    if (takesAny(option, {"1", "8", "16"})) type += " | float";
    const bool numbers = takesAny(option, {"1,2", "1,2,3", "1,0,0,0"}) && !takesAny(option, {"some words", "a,b"});
    if (numbers || option.syntax == "WxH") type += " | Sequence[float]";
    if (takesOff(option)) type += " | bool";
    if (option.syntax.find("SEL") != std::string::npos) type += " | Mask";
    if (option.key == "interface" || option.key == "interactions") type += " | tuple[str | Mask, str | Mask]";
    if (option.key == "map-around") type += " | tuple[str | Mask, float]";
    return type;
}

std::string keywordType(const Option& option) {
    if (option.kind == Option::Kind::flag) return "bool";
    if (option.key == "color-from") return "str | PathLike[str] | Table | Sequence[str | Table]";
    const std::string type = valueType(option);
    return option.kind == Option::Kind::list ? type + " | Sequence[" + type + "]" : type;
}

}  // namespace

std::vector<std::string> helpTopicNames() {
    std::vector<std::string> names;
    for (const HelpTopic& topic : kTopics) names.emplace_back(topic.name);
    return names;
}

bool isHelpTopic(const std::string& name) {
    const std::vector<std::string> names = helpTopicNames();
    return std::find(names.begin(), names.end(), name) != names.end();
}

std::string helpTopic(const std::string& name, std::span<const CommandSpec> commands) {
    if (name == "reference") return referencePage();
    if (name == "keywords") return pythonKeywords();
    if (name == "molviewspec") return mvs::nodeTable();
    const std::string spelt = name == "colours" || name == "colour" || name == "color" ? "colors" : name;
    const auto topic = std::ranges::find_if(kTopics, [&](const HelpTopic& t) { return spelt == t.name; });
    if (topic == std::end(kTopics)) {
        std::string named = optionsNamed(name, commands);
        if (!named.empty()) return named;
        std::vector<std::string> known = helpTopicNames();
        std::string list;
        for (const std::string& one : known) list += (list.empty() ? "" : ", ") + one;
        for (const CommandSpec& command : commands) known.push_back(command.name);
        for (const Option& option : options()) known.emplace_back(option.key);
        throw UsageError("no help topic '" + name + "'" + suggestion(name, known) + ": topics are " + list +
                         ", every command and every option");
    }
    std::string text = topic->text;
    const auto render = std::ranges::find_if(commands, [](const CommandSpec& c) { return c.name == "render"; });
    for (const Option& option : options())
        if (has(topic->topics, option.topic))
            for (const OptionSpec& spec : render->options)
                if (spec.longName() == (option.positional ? "INPUT" : "--" + std::string(option.key)))
                    text += "\n" + described(spec);
    return text;
}

std::string manualPage(const CommandSpec& program, std::span<const CommandSpec> commands) {
    std::ostringstream page;
    page << ".TH NACRE 1 \"\" \"nacre\" \"User Commands\"\n"
         << ".SH NAME\nnacre \\- draw molecules\n.SH SYNOPSIS\n";
    for (const CommandSpec& command : commands)
        page << (&command == &commands.front() ? "" : ".br\n") << formatSynopsis(command) << '\n';
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

std::string referencePage() {
    std::string page =
        "# Reference of options\n\n"
        "Options of `nacre render`; the other commands take those that concern them. Jobs of `nacre batch` and Python\n"
        "have the same keys without dashes. `nacre help reference` writes this page.\n";
    for (const ReferenceGroup& group : kReferenceGroups) {
        page += std::string("\n## ") + group.title + "\n";
        for (const Option& option : options())
            if (has(group.topics, option.topic)) page += "\n" + referenceEntry(option);
    }
    return page;
}

std::string pythonKeywords() {
    std::string text;
    for (const Option& option : options()) {
        if (!isKeyword(option)) continue;
        std::string key(option.key);
        std::replace(key.begin(), key.end(), '-', '_');
        text += "    " + key + ": " + keywordType(option) + "\n";
    }
    return text;
}

}  // namespace nacre::app
