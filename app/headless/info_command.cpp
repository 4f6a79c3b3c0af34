#include "app/headless/info_command.h"

#include <charconv>
#include <filesystem>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <ostream>

#include "app/headless/commands.h"
#include "app/headless/input.h"

namespace nacre::app {

using Json = nlohmann::ordered_json;

namespace {

/// The double that reads like the float: 7.075, not 7.074999809.
double asWritten(float value) {
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    double result = 0;
    std::from_chars(digits.data(), end, result);
    return result;
}

void put(Json& json, const char* key, const std::optional<std::int64_t>& value) {
    if (value) json[key] = *value;
}

void putAtomCounts(Json& json, const Molecule& molecule) {
    std::int64_t hetero = 0, alternate = 0, inserted = 0, negative = 0;
    for (const Atom& atom : molecule.atoms) {
        const Residue& residue = molecule.residues[atom.residue];
        hetero += atom.hetero;
        alternate += atom.alternate != '\0';
        inserted += residue.insertionCode != '\0';
        negative += residue.number < 0;
    }
    json["hetatm"] = hetero;
    json["altloc_atoms"] = alternate;
    json["insertion_code_atoms"] = inserted;
    json["negative_resnum_atoms"] = negative;
}

Json boxOf(const Molecule& molecule) {
    glm::vec3 low = molecule.atoms[0].position, high = low;
    for (const Atom& atom : molecule.atoms)
        for (int i = 0; i < 3; ++i) {
            low[i] = std::min(low[i], atom.position[i]);
            high[i] = std::max(high[i], atom.position[i]);
        }
    Json box = Json::array();
    for (const glm::vec3& corner : {low, high})
        box.push_back({asWritten(corner.x), asWritten(corner.y), asWritten(corner.z)});
    return box;
}

Json bondsByKind(const Molecule& molecule) {
    std::array<std::int64_t, 3> sources{};
    std::array<std::int64_t, 5> orders{};
    for (const Bond& bond : molecule.bonds) {
        ++sources[static_cast<std::size_t>(bond.source)];
        ++orders[bond.order <= 4 ? bond.order : 0];
    }
    return {{"total", molecule.bonds.size()},
            {"file", sources[0]},
            {"residue_template", sources[1]},
            {"distance", sources[2]},
            {"single", orders[1]},
            {"double", orders[2]},
            {"triple", orders[3]},
            {"aromatic", orders[4]},
            {"other", orders[0]}};
}

bool hasResidues(const std::string& format) { return format == "pdb" || format == "mmcif" || format == "mmjson"; }

/// A file's own words, made safe for a terminal.
std::string printable(std::string text) {
    for (char& c : text)
        if ((c >= 0 && c < ' ') || c == 127) c = '?';
    return text;
}

void line(std::ostream& out, const char* label, const std::string& text) {
    if (!text.empty()) out << "  " << std::left << std::setw(12) << label << printable(text) << '\n';
}

std::string listed(const Json& json, std::initializer_list<std::pair<const char*, const char*>> entries) {
    std::string text;
    for (const auto& [key, words] : entries)
        if (json.contains(key) && json[key].get<std::int64_t>() != 0)
            text +=
                (text.empty() ? "" : ", ") + std::string(words) + " " + std::to_string(json[key].get<std::int64_t>());
    return text;
}

}  // namespace

Json infoJson(const Molecule& molecule) {
    const FileSummary& file = molecule.file;
    Json json;
    json["format"] = file.format;
    if (!file.title.empty()) json["title"] = file.title;
    json["atoms"] = molecule.atoms.size();
    put(json, "models", file.models);
    put(json, "records", file.records);
    put(json, "total_atoms_all_models", file.totalAtomsAllModels);
    put(json, "total_atoms_all_records", file.totalAtomsAllRecords);
    put(json, "total_bonds_all_records", file.totalBondsAllRecords);
    put(json, "bonds", file.bonds);
    put(json, "conect_unique_pairs", file.conectUniquePairs);
    put(json, "chains", file.chains);
    put(json, "chains_auth", file.chainsAuth);
    put(json, "chains_label", file.chainsLabel);
    if (hasResidues(file.format)) putAtomCounts(json, molecule);
    put(json, "biomt_operators", file.biomtOperators);
    put(json, "assemblies", file.assemblies);
    put(json, "oper_list", file.operators);
    if (!molecule.atoms.empty()) json["bbox"] = boxOf(molecule);
    json["bonds_known"] = bondsByKind(molecule);
    json["warnings"] = molecule.warnings;
    return json;
}

std::string infoText(const std::string& name, const Json& json) {
    std::ostringstream out;
    out << name << " (" << json["format"].get<std::string>() << ")\n";
    line(out, "title", json.value("title", ""));
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
    line(out, "assemblies",
         listed(json,
                {{"assemblies", "assemblies"}, {"oper_list", "operators"}, {"biomt_operators", "BIOMT operators"}}));
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
    if (json.contains("bbox")) line(out, "box", json["bbox"][0].dump() + " to " + json["bbox"][1].dump() + " Å");
    for (const Json& warning : json["warnings"]) line(out, "warning", warning.get<std::string>());
    return out.str();
}

void infoCommand(const InfoOptions& options, std::ostream& out) {
    Json json = infoJson(loadMolecule(options.input));
    std::error_code error;
    const auto bytes = std::filesystem::file_size(options.input.path, error);
    if (!error) json["bytes"] = bytes;
    // A title may hold bytes that are no UTF-8; they become U+FFFD instead of an exception.
    if (options.json)
        out << json.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
    else
        out << infoText(options.input.path, json);
}

}  // namespace nacre::app
