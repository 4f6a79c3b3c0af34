#include "app/cli/info_command.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>
#include <iomanip>
#include <map>
#include <ostream>
#include <set>
#include <sstream>
#include <utility>

#include "app/cli/commands.h"
#include "app/cli/info_interactions.h"
#include "app/cli/progress.h"
#include "app/download/load_molecule.h"
#include "app/files/json_text.h"
#include "app/files/messages.h"
#include "app/input/input_files.h"
#include "app/input/map_input.h"
#include "app/picture/input_names.h"
#include "engine/error.h"
#include "engine/molecule/text.h"

namespace nacre::app {
namespace {

using MapJson = nlohmann::ordered_json;

/// Nine digits: the precision of a float.
double rounded(double value) {
    std::ostringstream text;
    text << std::setprecision(9) << value;
    return std::stod(text.str());
}
MapJson wholes(const glm::ivec3& v) { return {v.x, v.y, v.z}; }

std::string joined(const MapJson& list, const char* between) {
    std::string text;
    for (const MapJson& entry : list) text += (text.empty() ? "" : between) + entry.dump();
    return text;
}

}  // namespace

using Json = nlohmann::ordered_json;

namespace {

constexpr std::size_t kMostNames = 12;  // names per line of text

void line(std::ostream& out, const char* label, const std::string& text) {
    if (!text.empty()) out << "  " << std::left << std::setw(12) << label << printable(text) << '\n';
}

std::string toText(const Json& value) { return value.is_null() ? "" : value.get<std::string>(); }

std::string listed(const Json& json, std::initializer_list<std::pair<const char*, const char*>> entries) {
    std::string text;
    for (const auto& [key, words] : entries)
        if (json.contains(key) && !json[key].is_null() && json[key].get<std::int64_t>() != 0)
            text +=
                (text.empty() ? "" : ", ") + std::string(words) + " " + std::to_string(json[key].get<std::int64_t>());
    return text;
}

/// "HEM 4, PO4 2" of an object of counts.
std::string namesAndCounts(const Json& names) {
    std::string text;
    std::size_t shown = 0;
    for (const auto& [name, count] : names.items()) {
        if (++shown > kMostNames) return text + " and " + std::to_string(names.size() - kMostNames) + " more";
        text += (text.empty() ? "" : ", ") + name + " " + std::to_string(count.get<std::int64_t>());
    }
    return text;
}

/// Chains of the same sequence share an entry.
void sequences(std::ostream& out, const Json& chains) {
    struct Names {
        std::vector<std::string> inOrder;
        std::set<std::string> known;
    };
    std::map<std::string, Names> namesBySequence;
    std::vector<const Json*> first;
    for (const Json& chain : chains) {
        if (chain["sequence"].is_null()) continue;
        auto& names = namesBySequence[chain["sequence"]];
        if (names.inOrder.empty()) first.push_back(&chain);
        const std::string name = chain["name"].get<std::string>().empty() ? "(blank)" : chain["name"];
        if (names.known.insert(name).second) names.inOrder.push_back(name);  // once for all models
    }
    for (const Json* chain : first) {
        const std::string sequence = (*chain)["sequence"];
        const auto& names = namesBySequence[sequence].inOrder;
        std::string who = names.size() > 1 ? "chains" : "chain";
        for (std::size_t i = 0; i < std::min(names.size(), kMostNames); ++i) who += (i ? ", " : " ") + names[i];
        if (names.size() > kMostNames) who += " and " + std::to_string(names.size() - kMostNames) + " more";
        line(
            out, "sequence",
            who + ": " + (*chain)["polymer"].get<std::string>() + ", " + std::to_string(sequence.size()) + " residues");
        constexpr std::size_t kWidth = 60;
        for (std::size_t at = 0; at < sequence.size(); at += kWidth) line(out, "", sequence.substr(at, kWidth));
    }
}

void assemblies(std::ostream& out, const Json& list) {
    std::size_t shown = 0;
    for (const Json& entry : list) {
        if (++shown > kMostNames) return line(out, "", "and " + std::to_string(list.size() - kMostNames) + " more");
        std::string text = "--assembly " + entry["id"].get<std::string>() + ": " + entry["copies"].dump() +
                           (entry["copies"] == 1 ? " copy, " : " copies, ") + entry["atoms"].dump() + " atoms";
        if (!entry["details"].is_null()) text += ", " + entry["details"].get<std::string>();
        line(out, "", text);
    }
}

/// "assembly 1 of 12 entities: root.membrane (7), root.interior (5)"
std::string compartments(const Json& json) {
    std::map<std::string, int> entities;
    int all = 0;
    const Json& names = json["entity_names"];
    for (const Json& name : names) {
        const auto path = name.get<std::string>();
        const std::size_t point = path.find_last_of('.');
        if (point != std::string::npos) ++entities[path.substr(0, point)];
        ++all;
    }
    std::string text = "assembly " + json["packed"].get<std::string>();
    if (all > 0) text += " of " + std::to_string(all) + (all == 1 ? " entity" : " entities");
    std::size_t shown = 0;
    for (const auto& [name, count] : entities) {
        if (++shown > kMostNames) return text + " and " + std::to_string(entities.size() - kMostNames) + " more";
        text += (shown == 1 ? ": " : ", ") + name + " (" + std::to_string(count) + ")";
    }
    return text;
}

/// A number without the digits of its binary fraction.
std::string plainNumber(double value) {
    std::ostringstream out;
    out << std::setprecision(6) << value;
    return out.str();
}

/// "guessed 12 bonds: from distances"
std::string readingLine(const Json& entry) {
    const Json& why = entry["why"];
    const Json& from = entry["line"];
    ReadNote note{ReadAction::read, entry["what"], why.is_null() ? "" : why.get<std::string>(), entry["count"],
                  from.is_null() ? 0 : from.get<std::uint64_t>()};
    for (const ReadAction action : {ReadAction::guessed, ReadAction::leftOut})
        if (entry["action"] == readActionName(action)) note.action = action;
    return describeNote(note);
}

/// ", which repeats along a and b"; empty for a box that repeats along all of its vectors.
std::string describeRepeats(const Json& json) {
    std::string axes;
    for (std::size_t i = 0; i < 3; ++i)
        if (json["box_periodic"][i].get<bool>()) axes += (axes.empty() ? "" : " and ") + std::string(1, "abc"[i]);
    if (axes.empty()) return ", which does not repeat";
    return axes == "a and b and c" ? "" : ", which repeats along " + axes;
}

/// "A, B: HIV-1 protease; C: DNA": groups chains of one name.
std::string groupNames(const Json& names) {
    std::map<std::string, std::string> byName;
    for (const auto& [identifier, name] : names.items()) {
        std::string& of = byName[name.get<std::string>()];
        of += (of.empty() ? "" : ", ") + identifier;
    }
    std::string text;
    for (const auto& [name, of] : byName) text += (text.empty() ? "" : "; ") + of + ": " + name;
    return text;
}

}  // namespace

std::string infoText(const std::string& name, const Json& json) {
    std::ostringstream out;
    out << printable(name) << " (" << json["format"].get<std::string>() << ")\n";
    for (const char* key : {"title", "organism", "method"}) line(out, key, toText(json[key]));
    if (!json["resolution"].is_null()) line(out, "resolution", plainNumber(json["resolution"].get<double>()) + " Å");
    line(out, "atoms", std::to_string(json["atoms"].get<std::int64_t>()));
    line(out, "of these",
         listed(json, {{"hetatm", "hetero"},
                       {"altloc_atoms", "in alternate locations"},
                       {"insertion_code_atoms", "with insertion codes"},
                       {"negative_resnum_atoms", "in residues numbered below zero"}}));
    line(out, "file",
         listed(json, {{"models", "models"},
                       {"total_atoms_all_models", "atoms in all models"},
                       {"records", "records"},
                       {"total_atoms_all_records", "atoms in all records"},
                       {"bytes", "bytes"}}));
    line(out, "chains",
         listed(json, {{"chains", "identifiers"}, {"chains_auth", "by author"}, {"chains_label", "by label"}}));
    if (!json["chain_list"].is_null()) {
        sequences(out, json["chain_list"]);
        line(out, "chain names", groupNames(json["chain_names"]));
        line(out, "ligands", namesAndCounts(json["ligands"]));
        line(out, "their names", groupNames(json["component_names"]));
        line(out, "ions", namesAndCounts(json["ions"]));
        line(out, "water", listed(json, {{"waters", "molecules"}}));
    }
    line(out, "assemblies",
         listed(json,
                {{"assemblies", "assemblies"}, {"oper_list", "operators"}, {"biomt_operators", "BIOMT operators"}}));
    assemblies(out, json["assembly_list"]);
    if (!json["packed"].is_null()) line(out, "scene", compartments(json));
    line(out, "bonds",
         listed(json["bonds_known"], {{"total", "total"},
                                      {"file", "from the file"},
                                      {"residue_template", "from residue templates"},
                                      {"distance", "by distance"}}));
    line(out, "orders",
         listed(json["bonds_known"], {{"single", "single"},
                                      {"double", "double"},
                                      {"triple", "triple"},
                                      {"aromatic", "aromatic"},
                                      {"other", "other"}}));
    line(out, "of these",
         listed(json["bonds_known"],
                {{"between_residues", "between residues"}, {"disulfides", "disulfides"}, {"to_metals", "to metals"}}));
    if (!json["bbox"].is_null()) line(out, "box", json["bbox"][0].dump() + " to " + json["bbox"][1].dump() + " Å");
    if (!json["box_vectors"].is_null()) line(out, "cell", json["box_vectors"].dump() + " Å" + describeRepeats(json));
    if (!json["partial_charge"].is_null())
        line(out, "charge", plainNumber(json["partial_charge"].get<double>()) + " e, the sum of partial charges");
    const char* label = "reading";
    for (const Json& entry : json["reading"]) {
        if (entry["action"] == "read") continue;  // is above
        line(out, std::exchange(label, ""), readingLine(entry));
    }
    for (const Json& warning : json["warnings"]) line(out, "warning", warning.get<std::string>());
    return out.str();
}

namespace {

using InfoOutput = InfoOptions::Output;

/// One INPUT: its summary, and further output as text or CSV.
struct InfoOfInput {
    Json json;
    std::string text;
    bool isMap = false;
};

void appendInteractions(const Molecule& molecule, const InputOptions& input, const InfoOptions& options,
                        InfoOfInput& info) {
    ContactOptions contacts = options.picture.look.contacts;
    if (!input.further.empty())
        for (std::optional<Selection>* selection : {&contacts.of, &contacts.with})
            if (*selection) nameInputs(inputNames(input), **selection);
    if (options.frequencies) {
        const ContactFrequencies frequencies = contactFrequencies(molecule, contacts, input.trajectory);
        if (options.output == InfoOutput::csv) {
            info.text = frequencyCsv(molecule, frequencies);
        } else if (options.output == InfoOutput::text) {
            info.text += frequencyText(molecule, frequencies);
        } else {
            info.json["interactions_of"] = frequencies.of;
            info.json["interaction_frequencies"] = frequencyList(molecule, frequencies);
        }
        return;
    }
    const std::vector<Interaction> interactions = listInteractions(molecule, contacts, options.picture.look.assembly);
    if (options.output == InfoOutput::csv)
        info.text = interactionCsv(molecule, interactions);
    else if (options.output == InfoOutput::text)
        info.text += interactionText(molecule, interactions);
    else
        info.json["interactions"] = interactionList(molecule, interactions);
}

void putBytes(const std::string& path, Json& json) {
    std::error_code error;
    const auto bytes = std::filesystem::file_size(path, error);
    json["bytes"] = error ? Json() : Json(bytes);
}

/// The keys of every entry: those of molecules, and `map`.
Json emptyEntry(const std::string& name) {
    Json entry{{"file", name}, {"bytes", nullptr}};
    const Json keys = infoJson(Molecule());
    for (const auto& [key, value] : keys.items()) entry[key] = nullptr;
    entry["map"] = nullptr;
    return entry;
}

/// Output of `info --json` for a density map: format, and `map`: grid (nodes along a, b, c: of a crystal's whole cell,
/// else of the box), cell (a, b, c in Å and three angles in degrees), origin (position of the file's first node, Å),
/// axes (of a, b, c: the file's columns, rows and sections), space_group, box {size, start} in the file, and
/// min, max, mean and rms (deviation from the mean: 1 sigma) of the known values.
MapJson mapInfoJson(const DensityMap& map) {
    const glm::dvec3 first = map.place(glm::dvec3(map.firstNode()));
    const glm::dvec3 &l = map.cell.lengths, &a = map.cell.angles;
    MapJson json;
    json["format"] = map.format;
    glm::ivec3 sampling;  // intervals of the whole cell, whatever part of it the file has
    for (int i = 0; i < 3; ++i) sampling[i] = static_cast<int>(std::lround(l[i] / glm::length(map.step[i])));
    json["map"] = {{"grid", wholes(map.size)},
                   {"sampling", wholes(sampling)},
                   {"cell", {rounded(l.x), rounded(l.y), rounded(l.z), rounded(a.x), rounded(a.y), rounded(a.z)}},
                   {"origin", {rounded(first.x), rounded(first.y), rounded(first.z)}},
                   {"axes", map.axes},
                   {"space_group", map.spaceGroup},
                   {"crystal", map.periodic},
                   {"box", {{"size", wholes(map.boxSize)}, {"start", wholes(map.boxStart)}}},
                   {"min", rounded(map.statistics.min)},
                   {"max", rounded(map.statistics.max)},
                   {"mean", rounded(map.statistics.mean)},
                   {"rms", rounded(map.statistics.rms)}};
    const std::size_t nodes = map.values.size(), known = map.statistics.known;
    ReadNotes notes;
    addNote(notes, ReadAction::read, "values", "", static_cast<std::int64_t>(known));
    addNote(notes, ReadAction::leftOut, "values", "not known at these nodes", static_cast<std::int64_t>(nodes - known));
    notes.insert(notes.end(), map.notes.begin(), map.notes.end());
    json["reading"] = MapJson::array();
    for (const ReadNote& note : notes) json["reading"].push_back(noteJson(note));
    json["warnings"] = map.warnings;
    return json;
}

std::string mapInfoText(const std::string& name, const MapJson& json) {
    const MapJson& map = json["map"];
    std::ostringstream out;
    const auto line = [&](const char* label, const std::string& text) {
        out << "  " << std::left << std::setw(12) << label << text << '\n';
    };
    const auto number = [](const MapJson& value) {
        std::ostringstream text;
        text << std::setprecision(5) << value.get<double>();
        return text.str();
    };
    out << printable(name) << " (density map, " << json["format"].get<std::string>() << ")\n";
    line("grid", joined(map["grid"], " x ") + (map["crystal"].get<bool>() ? " nodes in the unit cell" : " nodes"));
    line("cell", joined(map["cell"], ", "));
    if (map["space_group"].get<int>() > 0) line("space group", map["space_group"].dump());
    line("origin", joined(map["origin"], ", ") + " Å");
    line("values", number(map["min"]) + " to " + number(map["max"]) + ", mean " + number(map["mean"]) + ", sigma " +
                       number(map["rms"]));
    for (const MapJson& warning : json["warnings"]) line("warning", warning.get<std::string>());
    return out.str();
}

/// Writes text immediately, JSON as a whole list at the end, or an entry per line.
class InfoWriter {
public:
    InfoWriter(const InfoOptions& options, std::ostream& out) : options_(options), out_(out) {}

    void add(const std::string& name, const InfoOfInput& info) {
        Json entry = emptyEntry(name);
        entry.update(info.json);
        switch (options_.output) {
            case InfoOutput::jsonLines:
                out_ << printableJson(entry.dump(-1, ' ', false, Json::error_handler_t::replace)) << '\n';
                break;
            case InfoOutput::json:
                list_.push_back(std::move(entry));
                break;
            case InfoOutput::text:
                out_ << std::exchange(between_, "\n") << (info.isMap ? mapInfoText(name, entry) : infoText(name, entry))
                     << info.text;
                break;
            case InfoOutput::csv:
                out_ << info.text;
                break;
        }
    }

    void finish() {
        if (!list_.empty()) out_ << jsonText(list_);
    }

private:
    const InfoOptions& options_;
    std::ostream& out_;
    const char* between_ = "";
    Json list_ = Json::array();
};

InfoOfInput infoOfMap(const InputOptions& input) {
    InfoOfInput info{mapInfoJson(readMapInput(input)), {}, true};
    putBytes(openedPath(input), info.json);
    return info;
}

InfoOfInput gatherInfo(const InputOptions& input, const InfoOptions& options) {
    if (isMap(input)) return infoOfMap(input);
    Progress progress;
    progress.begin("reading");
    const auto step = [&options] {
        if (options.onStep) options.onStep();
    };
    const auto onDownload = [&step, shown = downloadProgress(progress)](double share) {
        step();
        shown(share);
    };
    const Molecule molecule = loadMolecule(
        input, onDownload, [&step](double) { step(); }, step);
    step();
    progress.begin("summarising");
    InfoOfInput info{infoJson(molecule), {}, false};
    if (options.residues) {
        info.json["residues"] = residueList(molecule);
        info.text = residueText(info.json["residues"]);
    }
    if (options.picture.look.contacts.of) {
        progress.begin("finding interactions");
        appendInteractions(molecule, input, options, info);
    }
    putBytes(openedPath(input), info.json);
    return info;
}

/// Several INPUTs that form one scene.
void infoTogether(const InfoOptions& options, InfoWriter& writer) {
    InputOptions input = options.picture.input;
    input.alone = input.describedOnly = true;
    std::string names;
    for (const std::string& path : options.paths) {
        addInput(input, path);
        names += (names.empty() ? "" : " + ") + path;
    }
    writer.add(names, gatherInfo(input, options));
}

}  // namespace

void infoCommand(const InfoOptions& options, std::ostream& out) {
    InfoWriter writer(options, out);
    std::optional<Error> failure;  // the last one; earlier ones are printed at once
    if (options.together && options.paths.size() > 1) {
        infoTogether(options, writer);
    } else {
        for (const std::string& path : options.paths) try {
                InputOptions input = options.picture.input;
                input.alone = input.describedOnly = true;
                input.path = path;
                writer.add(path, gatherInfo(input, options));
            } catch (const Error& error) {
                if (failure) sayError(failure->what());
                failure = error;
            }
    }
    writer.finish();
    if (failure) throw *failure;
}

}  // namespace nacre::app
