#include "app/input/molecule_info.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <numeric>

#include "engine/molecule/chain_summary.h"
#include "engine/molecule/chemistry/drawn_orders.h"
#include "engine/molecule/element.h"

namespace nacre::app {

using Json = nlohmann::ordered_json;

namespace {

constexpr Element kSulfur = 16;

/// The double with the float's decimal representation: 7.075, not 7.074999809.
double asWritten(float value) {
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    double result = 0;
    std::from_chars(digits.data(), end, result);
    return result;
}

template <typename Value>
Json orNull(const std::optional<Value>& value) {
    return value ? Json(*value) : Json();
}

Json orNull(const std::string& text) { return text.empty() ? Json() : Json(text); }

/// @param has  whether the format has residues
void putAtomCounts(Json& json, const MoleculeCounts& counts, bool has) {
    const auto put = [&](const char* key, std::size_t count) { json[key] = has ? Json(count) : Json(); };
    put("hetatm", counts.hetatm);
    put("altloc_atoms", counts.altlocAtoms);
    put("insertion_code_atoms", counts.insertionCodeAtoms);
    put("negative_resnum_atoms", counts.negativeResnumAtoms);
}

template <std::size_t Count>
Json vectors(const std::array<glm::vec3, Count>& values) {
    Json json = Json::array();
    for (const glm::vec3& value : values) json.push_back({asWritten(value.x), asWritten(value.y), asWritten(value.z)});
    return json;
}

/// @param drawn  drawn orders of the bonds
Json bondsByKind(const Molecule& molecule, const std::vector<std::uint8_t>& drawn) {
    std::array<std::int64_t, 3> sources{};
    std::array<std::int64_t, 5> orders{};
    std::int64_t between = 0, disulfides = 0, metal = 0;
    for (std::size_t i = 0; i < molecule.bonds.size(); ++i) {
        const Bond& bond = molecule.bonds[i];
        const Atom &a = molecule.atoms[bond.a], &b = molecule.atoms[bond.b];
        between += a.residue != b.residue;
        disulfides += a.residue != b.residue && a.element == kSulfur && b.element == kSulfur;
        metal += isMetal(a.element) || isMetal(b.element);
        ++sources[static_cast<std::size_t>(bond.source)];
        ++orders[drawn[i] <= 4 ? drawn[i] : 0];
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
    Json list = Json::array();
    for (std::size_t i = 0; i < chains.size(); ++i) {
        const ChainSummary& chain = chains[i];
        const bool polymer = !chain.sequence.empty();
        list.push_back({{"name", chain.name},
                        {"model", molecule.chains[i].model},
                        {"polymer", !polymer                               ? Json()
                                    : chain.nucleotides > chain.aminoAcids ? Json("nucleic")
                                                                           : Json("protein")},
                        {"length", chain.sequence.size()},
                        {"sequence", orNull(chain.sequence)},
                        {"ligands", chain.ligands},
                        {"ions", chain.ions},
                        {"waters", chain.waters}});
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

void putChains(Json& json, const Molecule& molecule, bool has) {
    if (!has) {
        for (const char* key : {"chain_list", "ligands", "ions", "waters"}) json[key] = nullptr;
        return;
    }
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

/// Counts copies and atoms from the assembly's parts.
Json assemblyList(const Molecule& molecule) {
    Json list = Json::array();
    if (molecule.assemblies.empty()) return list;
    const std::vector<std::size_t> sizes = subchainSizes(molecule);
    for (const Assembly& assembly : molecule.assemblies) {
        std::size_t copies = 0, atoms = 0;
        for (const AssemblyPart& part : assembly.parts) {
            copies = std::max(copies, part.transforms.size());
            for (const std::uint32_t subchain : part.subchains) atoms += sizes[subchain] * part.transforms.size();
        }
        list.push_back(
            {{"id", assembly.id}, {"details", orNull(assembly.details)}, {"copies", copies}, {"atoms", atoms}});
    }
    return list;
}

}  // namespace

Json noteJson(const ReadNote& note) {
    return {{"action", readActionName(note.action)},
            {"what", note.what},
            {"count", note.count},
            {"why", orNull(note.why)},
            {"line", note.line > 0 ? Json(note.line) : Json()}};
}

Json infoJson(const Molecule& molecule) {
    const FileSummary& file = molecule.file;
    const MoleculeCounts counts = countMolecule(molecule);
    const bool residues = hasResidues(file.format);
    Json json;
    json["format"] = file.format;
    json["title"] = orNull(file.title);
    json["organism"] = orNull(file.organism);
    json["method"] = orNull(file.method);
    json["resolution"] = orNull(file.resolution);
    json["atoms"] = counts.atoms;
    json["models"] = orNull(file.models);
    json["records"] = orNull(file.records);
    json["total_atoms_all_models"] = orNull(file.totalAtomsAllModels);
    json["total_atoms_all_records"] = orNull(file.totalAtomsAllRecords);
    json["total_bonds_all_records"] = orNull(file.totalBondsAllRecords);
    json["bonds"] = orNull(file.bonds);
    json["bonds_all_models"] = orNull(file.bondsAllModels);
    json["conect_unique_pairs"] = orNull(file.conectUniquePairs);
    json["chains"] = orNull(file.chains);
    json["chains_auth"] = orNull(file.chainsAuth);
    json["chains_label"] = orNull(file.chainsLabel);
    putAtomCounts(json, counts, residues);
    putChains(json, molecule, residues);
    json["chain_names"] = file.chainNames;
    json["component_names"] = file.componentNames;
    json["entity_names"] = file.entityNames;
    json["packed"] = orNull(file.packed);
    json["biomt_operators"] = orNull(file.biomtOperators);
    json["assemblies"] = orNull(file.assemblies);
    json["oper_list"] = orNull(file.operators);
    json["assembly_list"] = assemblyList(molecule);
    json["bbox"] = counts.bbox ? vectors(*counts.bbox) : Json();
    json["box_vectors"] = file.box ? vectors(*file.box) : Json();
    json["box_periodic"] = file.box ? Json(file.boxRepeats) : Json();
    json["box_origin"] =
        file.box && file.boxOrigin != glm::vec3(0) ? Json(vectors(std::array{file.boxOrigin})[0]) : Json();
    json["partial_charge"] =
        molecule.partialCharges.empty()
            ? Json()
            : Json(std::accumulate(molecule.partialCharges.begin(), molecule.partialCharges.end(), 0.0));
    const std::vector<std::uint8_t> drawn = drawnOrders(molecule);
    json["bonds_known"] = bondsByKind(molecule, drawn);
    json["reading"] = Json::array();
    for (const ReadNote& note : listReadNotes(molecule, drawn)) json["reading"].push_back(noteJson(note));
    json["warnings"] = molecule.warnings;
    return json;
}

}  // namespace nacre::app
