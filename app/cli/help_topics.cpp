// `nacre help TOPIC`: a text about several options, and those options' own help.

#include <algorithm>

#include "app/cli/option_words.h"
#include "app/mvs/node_table.h"
#include "app/picture/options.h"
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
     "  protein  nucleic  polymer  ligand  water  ion  backbone  sidechain  hydrogens  hetatm  all  none\n"
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

/// An option as it stands in --help, wrapped by hand already.
std::string described(const OptionSpec& option) {
    std::string text = "  " + option.names + (option.type.empty() ? "" : " " + option.type);
    if (!option.fallback.empty()) text += " [" + option.fallback + "]";
    text += "\n      ";
    for (const char c : option.help) text += c == '\n' ? std::string("\n      ") : std::string(1, c);
    return text + "\n";
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
    const auto topic =
        std::find_if(std::begin(kTopics), std::end(kTopics), [&](const HelpTopic& t) { return spelt == t.name; });
    if (topic == std::end(kTopics)) {
        std::vector<std::string> known = helpTopicNames();
        std::string list;
        for (const std::string& one : known) list += (list.empty() ? "" : ", ") + one;
        for (const CommandSpec& command : commands) known.push_back(command.name);
        throw UsageError("no help topic '" + name + "'" + suggestion(name, known) + ": topics are " + list +
                         " and every command");
    }
    std::string text = topic->text;
    const auto render =
        std::find_if(commands.begin(), commands.end(), [](const CommandSpec& c) { return c.name == "render"; });
    for (const Option& option : options())
        if (has(topic->topics, option.topic))
            for (const OptionSpec& spec : render->options)
                if (spec.longName() == (option.positional ? "INPUT" : "--" + std::string(option.key)))
                    text += "\n" + described(spec);
    return text;
}

}  // namespace nacre::app
