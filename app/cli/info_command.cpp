#include "app/cli/info_command.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <iomanip>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>
#include <ostream>
#include <set>
#include <sstream>

#include "app/cli/commands.h"
#include "app/cli/info_interactions.h"
#include "app/cli/progress.h"
#include "app/download/load_molecule.h"
#include "app/files/json_text.h"
#include "app/files/messages.h"
#include "engine/error.h"
#include "engine/molecule/chain_summary.h"
#include "engine/molecule/counts.h"
#include "engine/molecule/element.h"

namespace nacre::app {

using Json = nlohmann::ordered_json;

namespace {

constexpr Element kSulfur = 16;
constexpr std::size_t kMostNames = 12;  // that a line of text lists

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

void putAtomCounts(Json& json, const MoleculeCounts& counts) {
    json["hetatm"] = counts.hetatm;
    json["altloc_atoms"] = counts.altlocAtoms;
    json["insertion_code_atoms"] = counts.insertionCodeAtoms;
    json["negative_resnum_atoms"] = counts.negativeResnumAtoms;
}

template <std::size_t Count>
Json vectors(const std::array<glm::vec3, Count>& values) {
    Json json = Json::array();
    for (const glm::vec3& value : values) json.push_back({asWritten(value.x), asWritten(value.y), asWritten(value.z)});
    return json;
}

Json bondsByKind(const Molecule& molecule) {
    std::array<std::int64_t, 3> sources{};
    std::array<std::int64_t, 5> orders{};
    std::int64_t between = 0, disulfides = 0, metal = 0;
    for (const Bond& bond : molecule.bonds) {
        const Atom &a = molecule.atoms[bond.a], &b = molecule.atoms[bond.b];
        between += a.residue != b.residue;
        disulfides += a.residue != b.residue && a.element == kSulfur && b.element == kSulfur;
        metal += isMetal(a.element) || isMetal(b.element);
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
            {"other", orders[0]},
            {"between_residues", between},
            {"disulfides", disulfides},
            {"to_metals", metal}};
}

bool hasResidues(const std::string& format) {
    for (const char* without : {"sdf-v2000", "sdf-v3000", "xyz", "cml", "cif-core"})
        if (format == without) return false;
    return true;
}

/// @param chains  those of the molecule, in its order
Json chainList(const Molecule& molecule, const std::vector<ChainSummary>& chains) {
    const bool several = std::any_of(molecule.chains.begin(), molecule.chains.end(),
                                     [&](const Chain& chain) { return chain.model != molecule.chains.front().model; });
    Json list = Json::array();
    for (std::size_t i = 0; i < chains.size(); ++i) {
        const ChainSummary& chain = chains[i];
        Json entry{{"name", chain.name}};
        if (several) entry["model"] = molecule.chains[i].model;
        if (!chain.sequence.empty()) {
            entry["polymer"] = chain.nucleotides > chain.aminoAcids ? "nucleic" : "protein";
            entry["length"] = chain.sequence.size();
            entry["sequence"] = chain.sequence;
        }
        if (!chain.ligands.empty()) entry["ligands"] = chain.ligands;
        if (!chain.ions.empty()) entry["ions"] = chain.ions;
        if (chain.waters > 0) entry["waters"] = chain.waters;
        list.push_back(entry);
    }
    return list;
}

/// Residues by name over all chains.
Json total(const std::vector<ChainSummary>& chains, std::map<std::string, std::size_t> ChainSummary::*names) {
    std::map<std::string, std::size_t> sum;
    for (const ChainSummary& chain : chains)
        for (const auto& [name, count] : chain.*names) sum[name] += count;
    return sum;
}

void putChains(Json& json, const Molecule& molecule) {
    const std::vector<ChainSummary> chains = summariseChains(molecule);
    std::size_t waters = 0;
    for (const ChainSummary& chain : chains) waters += chain.waters;
    json["chain_list"] = chainList(molecule, chains);
    json["ligands"] = total(chains, &ChainSummary::ligands);
    json["ions"] = total(chains, &ChainSummary::ions);
    json["waters"] = waters;
}

/// Atoms of each subchain.
std::vector<std::size_t> subchainSizes(const Molecule& molecule) {
    std::vector<std::size_t> sizes(molecule.subchains.size());
    for (const Residue& residue : molecule.residues) sizes[residue.subchain] += residue.atomCount;
    return sizes;
}

/// Copies and atoms count what the assembly's parts mention.
Json assemblyList(const Molecule& molecule) {
    const std::vector<std::size_t> sizes = subchainSizes(molecule);
    Json list = Json::array();
    for (const Assembly& assembly : molecule.assemblies) {
        std::size_t copies = 0, atoms = 0;
        for (const AssemblyPart& part : assembly.parts) {
            copies = std::max(copies, part.transforms.size());
            for (const std::uint32_t subchain : part.subchains) atoms += sizes[subchain] * part.transforms.size();
        }
        Json entry{{"id", assembly.id}};
        if (!assembly.details.empty()) entry["details"] = assembly.details;
        entry["copies"] = copies;
        entry["atoms"] = atoms;
        list.push_back(entry);
    }
    return list;
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
        if (!chain.contains("sequence")) continue;
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
        if (entry.contains("details")) text += ", " + entry["details"].get<std::string>();
        line(out, "", text);
    }
}

/// A number as people write it, without the digits that binary fractions add.
std::string plainNumber(double value) {
    std::ostringstream out;
    out << std::setprecision(6) << value;
    return out.str();
}

/// "A, B: HIV-1 protease; C: DNA": those of one name together.
std::string namesOf(const Json& json, const char* key) {
    std::map<std::string, std::string> byName;
    for (const auto& [identifier, name] : json.value(key, Json::object()).items()) {
        std::string& of = byName[name.get<std::string>()];
        of += (of.empty() ? "" : ", ") + identifier;
    }
    std::string text;
    for (const auto& [name, of] : byName) text += (text.empty() ? "" : "; ") + of + ": " + name;
    return text;
}

}  // namespace

Json infoJson(const Molecule& molecule) {
    const FileSummary& file = molecule.file;
    Json json;
    json["format"] = file.format;
    if (!file.title.empty()) json["title"] = file.title;
    if (!file.organism.empty()) json["organism"] = file.organism;
    if (!file.method.empty()) json["method"] = file.method;
    if (file.resolution) json["resolution"] = *file.resolution;
    const MoleculeCounts counts = countMolecule(molecule);
    json["atoms"] = counts.atoms;
    put(json, "models", file.models);
    put(json, "records", file.records);
    put(json, "total_atoms_all_models", file.totalAtomsAllModels);
    put(json, "total_atoms_all_records", file.totalAtomsAllRecords);
    put(json, "total_bonds_all_records", file.totalBondsAllRecords);
    put(json, "bonds", file.bonds);
    put(json, "bonds_all_models", file.bondsAllModels);
    put(json, "conect_unique_pairs", file.conectUniquePairs);
    put(json, "chains", file.chains);
    put(json, "chains_auth", file.chainsAuth);
    put(json, "chains_label", file.chainsLabel);
    if (hasResidues(file.format)) {
        putAtomCounts(json, counts);
        putChains(json, molecule);
    }
    if (!file.chainNames.empty()) json["chain_names"] = file.chainNames;
    if (!file.componentNames.empty()) json["component_names"] = file.componentNames;
    put(json, "biomt_operators", file.biomtOperators);
    put(json, "assemblies", file.assemblies);
    put(json, "oper_list", file.operators);
    if (!molecule.assemblies.empty()) json["assembly_list"] = assemblyList(molecule);
    if (counts.bbox) json["bbox"] = vectors(*counts.bbox);
    if (file.box) json["box_vectors"] = vectors(*file.box);
    if (!molecule.partialCharges.empty())
        json["partial_charge"] = std::accumulate(molecule.partialCharges.begin(), molecule.partialCharges.end(), 0.0);
    json["bonds_known"] = bondsByKind(molecule);
    json["warnings"] = molecule.warnings;
    return json;
}

std::string infoText(const std::string& name, const Json& json) {
    std::ostringstream out;
    out << printable(name) << " (" << json["format"].get<std::string>() << ")\n";
    line(out, "title", json.value("title", ""));
    line(out, "organism", json.value("organism", ""));
    line(out, "method", json.value("method", ""));
    if (json.contains("resolution")) line(out, "resolution", plainNumber(json["resolution"].get<double>()) + " Å");
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
    if (json.contains("chain_list")) {
        sequences(out, json["chain_list"]);
        line(out, "chain names", namesOf(json, "chain_names"));
        line(out, "ligands", namesAndCounts(json["ligands"]));
        line(out, "their names", namesOf(json, "component_names"));
        line(out, "ions", namesAndCounts(json["ions"]));
        line(out, "water", listed(json, {{"waters", "molecules"}}));
    }
    line(out, "assemblies",
         listed(json,
                {{"assemblies", "assemblies"}, {"oper_list", "operators"}, {"biomt_operators", "BIOMT operators"}}));
    if (json.contains("assembly_list")) assemblies(out, json["assembly_list"]);
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
    if (json.contains("bbox")) line(out, "box", json["bbox"][0].dump() + " to " + json["bbox"][1].dump() + " Å");
    if (json.contains("box_vectors")) line(out, "cell", json["box_vectors"].dump() + " Å");
    if (json.contains("partial_charge"))
        line(out, "charge", plainNumber(json["partial_charge"].get<double>()) + " e, the sum of partial charges");
    for (const Json& warning : json["warnings"]) line(out, "warning", warning.get<std::string>());
    return out.str();
}

namespace {

/// One INPUT: its summary, and what comes after it where it is for people, or alone as CSV.
struct InfoOfInput {
    Json json;
    std::string text;
};

InfoOfInput infoOf(const InputOptions& input, const InfoOptions& options) {
    Progress progress;
    progress.begin("reading");
    const Molecule molecule = loadMolecule(input, downloadProgress(progress));
    InfoOfInput info{infoJson(molecule), {}};
    if (options.residues) {
        info.json["residues"] = residueList(molecule);
        info.text = residueText(info.json["residues"]);
    }
    if (options.interactions) {
        InteractionRequest request = *options.interactions;
        request.rules = options.interactionRules;
        const std::vector<Interaction> interactions = interactionsOf(molecule, request);
        if (options.csv) info.text = interactionCsv(molecule, interactions);
        if (options.json) info.json["interactions"] = interactionList(molecule, interactions);
        if (!options.csv && !options.json) info.text += interactionText(molecule, interactions);
    }
    std::error_code error;
    const auto bytes = std::filesystem::file_size(input.path, error);
    if (!error) info.json["bytes"] = bytes;
    return info;
}

}  // namespace

void infoCommand(const InfoOptions& options, std::ostream& out) {
    const bool several = options.paths.size() > 1;
    Json list = Json::array();
    std::optional<Error> failure;  // the last one; those before it are said at once
    for (const std::string& path : options.paths) try {
            InputOptions input = options.picture.input;
            input.alone = true;
            input.path = path;
            Json json = several ? Json{{"file", path}} : Json::object();
            InfoOfInput info = infoOf(input, options);
            json.update(std::move(info.json));
            if (!options.json && !options.csv) out << (list.empty() ? "" : "\n") << infoText(path, json);
            if (!options.json) out << info.text;
            list.push_back(std::move(json));
        } catch (const Error& error) {
            if (failure) sayError(failure->what());
            failure = error;
        }
    if (options.json && !list.empty()) out << jsonText(several ? list : list.front());
    if (failure) throw *failure;
}

}  // namespace nacre::app
