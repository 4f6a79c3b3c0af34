#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "engine/molecule/bonds/possible_bonds.h"
#include "engine/molecule/formats/mmcif_model.h"
#include "engine/molecule/text.h"

namespace nacre {

namespace {

constexpr std::size_t kMaxAlternates = 16;

/// Finds atoms by their residue and name. A file may have one huge residue and connections to each of its atoms.
class AtomIndex {
public:
    explicit AtomIndex(const Molecule& molecule) : molecule_(molecule) {
        for (std::uint32_t i = 0; i < molecule.residues.size(); ++i) {
            const Residue& residue = molecule.residues[i];
            const std::string_view insertion(&residue.insertionCode, residue.insertionCode ? 1 : 0);
            residues_.emplace(
                key(molecule.chains[residue.chain].name, std::to_string(residue.number), insertion, residue.name), i);
        }
    }

    /// Adds residues by labelKey().
    void addLabels() {
        for (std::uint32_t i = 0; i < molecule_.residues.size() && !labels_; ++i) {
            const Residue& residue = molecule_.residues[i];
            const bool numbered = residue.labelNumber != kNoLabelNumber;
            residues_.emplace(labelKey(molecule_.subchains[residue.subchain],
                                       numbered ? std::to_string(residue.labelNumber) : std::string(), residue.name),
                              i);
        }
        labels_ = true;
    }

    /// Key of mmCIF's own identifiers, not the author's. @param number  empty outside polymers
    static std::string labelKey(std::string_view chain, std::string_view number, const Name& component) {
        return "\t" + key(chain, number, "", component);
    }

    static std::string key(std::string_view chain, std::string_view number, std::string_view insertion,
                           const Name& component) {
        std::string key(chain);
        key.append(1, '\n').append(number).append(1, '\n').append(insertion.substr(0, 1));
        return key.append(1, '\n').append(component.view());
    }

    /// At most kMaxAlternates atoms. @param alternate  '\0': any
    std::vector<std::uint32_t> find(const std::string& residue, const Name& name, char alternate) {
        const std::vector<std::uint32_t>& atoms = listAtoms(residue);
        const Place place(name.bytes, static_cast<unsigned char>(alternate));
        auto at = std::lower_bound(atoms.begin(), atoms.end(), place,
                                   [&](std::uint32_t atom, const Place& sought) { return makePlace(atom) < sought; });
        std::vector<std::uint32_t> found;
        for (; at != atoms.end() && found.size() < kMaxAlternates; ++at) {
            const Atom& atom = molecule_.atoms[*at];
            if (atom.name != name || (alternate && atom.alternate != alternate)) break;
            found.push_back(*at);
        }
        std::sort(found.begin(), found.end());
        return found;
    }

private:
    using Place = std::pair<std::array<char, 8>, unsigned char>;
    Place makePlace(std::uint32_t atom) const {
        return {molecule_.atoms[atom].name.bytes, static_cast<unsigned char>(molecule_.atoms[atom].alternate)};
    }

    /// Atoms of all runs of the residue, sorted on first use.
    const std::vector<std::uint32_t>& listAtoms(const std::string& residue) {
        const auto [known, added] = atoms_.try_emplace(residue);
        if (!added) return known->second;
        const auto runs = residues_.equal_range(residue);
        for (auto run = runs.first; run != runs.second; ++run) {
            const Residue& r = molecule_.residues[run->second];
            for (std::uint32_t i = 0; i < r.atomCount; ++i) known->second.push_back(r.firstAtom + i);
        }
        std::stable_sort(known->second.begin(), known->second.end(),
                         [&](std::uint32_t a, std::uint32_t b) { return makePlace(a) < makePlace(b); });
        return known->second;
    }

    const Molecule& molecule_;
    std::multimap<std::string, std::uint32_t> residues_;       // no hash that a file could aim at
    std::map<std::string, std::vector<std::uint32_t>> atoms_;  ///< of residues that were asked for
    bool labels_ = false;
};

/// The column names of one partner of a connection.
struct Partner {
    const char *authAsym, *labelAsym, *authSeq, *labelSeq, *insertion, *comp, *authComp, *atom, *alternate;
};
constexpr Partner kPartners[2] = {
    {"ptnr1_auth_asym_id", "ptnr1_label_asym_id", "ptnr1_auth_seq_id", "ptnr1_label_seq_id", "pdbx_ptnr1_pdb_ins_code",
     "ptnr1_label_comp_id", "ptnr1_auth_comp_id", "ptnr1_label_atom_id", "pdbx_ptnr1_label_alt_id"},
    {"ptnr2_auth_asym_id", "ptnr2_label_asym_id", "ptnr2_auth_seq_id", "ptnr2_label_seq_id", "pdbx_ptnr2_pdb_ins_code",
     "ptnr2_label_comp_id", "ptnr2_auth_comp_id", "ptnr2_label_atom_id", "pdbx_ptnr2_label_alt_id"}};

/// By the author's identifiers if the row has them, else by the labels.
std::vector<std::uint32_t> findAtoms(AtomIndex& index, const MmcifTable& table, std::size_t row,
                                     const Partner& partner) {
    const auto text = [&](const char* first, const char* second) {
        return table.get(row, {first, second}).value_or("");
    };
    const std::string_view alternate = text(partner.alternate, partner.alternate), atom = text(partner.atom, "");
    const auto find = [&](const std::string& residue) {
        return index.find(residue, atom, alternate.empty() ? '\0' : alternate[0]);
    };
    std::vector<std::uint32_t> found;
    if (table.get(row, {partner.authSeq}))
        found = find(AtomIndex::key(text(partner.authAsym, partner.labelAsym), text(partner.authSeq, ""),
                                    text(partner.insertion, ""), text(partner.authComp, partner.comp)));
    if (found.empty()) {
        index.addLabels();
        found = find(AtomIndex::labelKey(text(partner.labelAsym, partner.authAsym), text(partner.labelSeq, ""),
                                         text(partner.comp, partner.authComp)));
    }
    // Some programs write the author's numbers into the columns of labels.
    if (found.empty())
        found = find(AtomIndex::key(text(partner.authAsym, partner.labelAsym), text(partner.authSeq, partner.labelSeq),
                                    text(partner.insertion, ""), text(partner.authComp, partner.comp)));
    return found;
}

/// Whether a row is a bond between atoms of the model itself: covalent or a metal's coordination, but not a hydrogen
/// bond.
bool isBond(const MmcifTable& table, std::size_t row) {
    const std::string type = lowerCase(table.get(row, {"conn_type_id"}).value_or(""));
    const auto first = table.get(row, {"ptnr1_symmetry"}), second = table.get(row, {"ptnr2_symmetry"});
    const bool mate = first && second && *first != *second;
    return !mate && (startsWith(type, "covale") || type == "disulf" || type == "metalc");
}

}  // namespace

int mmcifBondOrder(std::optional<std::string_view> text) {
    const std::string order = lowerCase(text.value_or("sing").substr(0, 4));
    if (order == "doub") return 2;
    if (order == "trip") return 3;
    return order == "arom" || order == "delo" ? 4 : 1;
}

void addStructConnBonds(MoleculeBuilder& builder, const MmcifTable& connections) {
    const Molecule& molecule = builder.molecule();
    std::optional<AtomIndex> index;
    for (std::size_t row = 0; row < connections.rows(); ++row) {
        if (!isBond(connections, row)) continue;
        if (!index) index.emplace(molecule);
        const auto first = findAtoms(*index, connections, row, kPartners[0]);
        const auto second = findAtoms(*index, connections, row, kPartners[1]);
        const std::uint64_t line = connections.lineNumber(row);
        if (first.empty() || second.empty()) builder.leaveOut("connections", "_struct_conn names absent atoms", line);
        bool near = false, far = false;
        const int order = mmcifBondOrder(connections.get(row, {"pdbx_value_order"}));
        for (const std::uint32_t a : first)
            for (const std::uint32_t b : second) {
                const char p = molecule.atoms[a].alternate, q = molecule.atoms[b].alternate;
                if (a == b || (p != q && p != '\0' && q != '\0')) continue;
                if (!mayBeBonded(molecule, a, b)) {
                    far = true;
                    continue;
                }
                near = true;
                builder.addBond(a, b, order, line);
            }
        if (far && !near) builder.leaveOut("connections", "_struct_conn of atoms at a distance that no bond has", line);
    }
}

void addComponent(MoleculeBuilder& builder, const MmcifTable& atoms, const MmcifTable& bonds) {
    using Axes = std::array<const char*, 3>;
    static constexpr Axes kSources[] = {
        {"pdbx_model_cartn_x_ideal", "pdbx_model_cartn_y_ideal", "pdbx_model_cartn_z_ideal"},
        {"model_cartn_x", "model_cartn_y", "model_cartn_z"},
        {"x", "y", "z"}};
    const auto complete = [&](const Axes& axes) {
        for (std::size_t row = 0; row < atoms.rows(); ++row)
            for (const char* axis : axes)
                if (!atoms.get(row, {axis})) return false;
        return true;
    };
    const Axes* source = nullptr;
    for (const Axes& axes : kSources)
        if (!source && complete(axes)) source = &axes;
    if (!source) cannotRead(builder.name(), "the chemical component has no coordinates");

    std::map<std::string, std::uint32_t, std::less<>> records;
    for (std::size_t row = 0; row < atoms.rows(); ++row) {
        const std::string name(atoms.get(row, {"atom_id"}).value_or(""));
        records.emplace(name, static_cast<std::uint32_t>(row));
        const auto axis = [&](std::size_t i) { return *atoms.get(row, {(*source)[i]}); };
        const auto position = builder.position({axis(0), axis(1), axis(2)}, atoms.lineNumber(row));
        if (!position) continue;
        Atom atom;
        atom.position = *position;
        atom.name = Name(name);
        atom.element = builder.element(atoms.get(row, {"type_symbol"}).value_or(""), atoms.lineNumber(row));
        atom.hetero = true;
        const auto charge = parseInteger(atoms.get(row, {"charge"}).value_or("0"));
        if (charge && *charge >= -20 && *charge <= 20) atom.charge = static_cast<std::int8_t>(*charge);
        builder.addAtom(atom, "", 1, '\0', atoms.get(row, {"comp_id"}).value_or(""));
    }
    for (std::size_t row = 0; row < bonds.rows(); ++row) {
        const auto a = records.find(bonds.get(row, {"atom_id_1"}).value_or(""));
        const auto b = records.find(bonds.get(row, {"atom_id_2"}).value_or(""));
        if (a == records.end() || b == records.end() || a == b) {
            builder.leaveOut("bonds", "_chem_comp_bond names absent atoms", bonds.lineNumber(row));
            continue;
        }
        builder.addBond(builder.atomOfRecord(a->second), builder.atomOfRecord(b->second),
                        mmcifBondOrder(bonds.get(row, {"value_order", "type"})), bonds.lineNumber(row));
    }
    builder.molecule().file.models = 1;
    builder.molecule().file.bonds = static_cast<std::int64_t>(bonds.rows());
}

}  // namespace nacre
