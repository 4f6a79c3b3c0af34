#include "app/input/molecule_info.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <numeric>

#include "engine/molecule/chain_summary.h"
#include "engine/molecule/chemistry/chemistry.h"
#include "engine/molecule/element.h"

namespace nacre::app {

using Json = nlohmann::ordered_json;

namespace {

constexpr Element kSulfur = 16;

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
    const std::vector<std::uint8_t> perceived = perceivedOrders(molecule);
    for (std::size_t i = 0; i < molecule.bonds.size(); ++i) {
        const Bond& bond = molecule.bonds[i];
        const Atom &a = molecule.atoms[bond.a], &b = molecule.atoms[bond.b];
        between += a.residue != b.residue;
        disulfides += a.residue != b.residue && a.element == kSulfur && b.element == kSulfur;
        metal += isMetal(a.element) || isMetal(b.element);
        ++sources[static_cast<std::size_t>(bond.source)];
        ++orders[perceived[i] <= 4 ? perceived[i] : 0];
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
    for (const char* without :
         {"sdf-v2000", "sdf-v3000", "xyz", "cml", "cif-core", "poscar", "xsf", "tinker", "inpcrd", "gsd"})
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

/// Rows of one shape, in a stable order: what was read, guessed and left out.
Json readingList(const Molecule& molecule) {
    Json list = Json::array();
    for (const ReadNote& note : readingOf(molecule)) {
        Json entry{{"action", readActionName(note.action)}, {"what", note.what}, {"count", note.count}};
        if (!note.why.empty()) entry["why"] = note.why;
        if (note.line > 0) entry["line"] = note.line;
        list.push_back(entry);
    }
    return list;
}

/// Atoms of each subchain.
std::vector<std::size_t> subchainSizes(const Molecule& molecule) {
    std::vector<std::size_t> sizes(molecule.subchains.size());
    for (const Residue& residue : molecule.residues) sizes[residue.subchain] += residue.atomCount;
    return sizes;
}

/// Copies and atoms are counted from the assembly's parts.
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
    if (!file.entityNames.empty()) json["entity_names"] = file.entityNames;
    if (!file.packed.empty()) json["packed"] = file.packed;
    put(json, "biomt_operators", file.biomtOperators);
    put(json, "assemblies", file.assemblies);
    put(json, "oper_list", file.operators);
    if (!molecule.assemblies.empty()) json["assembly_list"] = assemblyList(molecule);
    if (counts.bbox) json["bbox"] = vectors(*counts.bbox);
    if (file.box) json["box_vectors"] = vectors(*file.box);
    if (file.box && file.boxOrigin != glm::vec3(0)) json["box_origin"] = vectors(std::array{file.boxOrigin})[0];
    if (!molecule.partialCharges.empty())
        json["partial_charge"] = std::accumulate(molecule.partialCharges.begin(), molecule.partialCharges.end(), 0.0);
    json["bonds_known"] = bondsByKind(molecule);
    json["reading"] = readingList(molecule);
    json["warnings"] = molecule.warnings;
    return json;
}

}  // namespace nacre::app
