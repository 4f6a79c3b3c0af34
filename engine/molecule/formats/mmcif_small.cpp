// Small-molecule CIF (dictionary cif_core), as in the Cambridge and the Crystallography Open Database.
#include <algorithm>
#include <cmath>
#include <gemmi/symmetry.hpp>
#include <gemmi/unitcell.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <map>
#include <numeric>
#include <unordered_map>

#include "engine/molecule/assemblies.h"
#include "engine/molecule/displacement.h"
#include "engine/molecule/element.h"
#include "engine/molecule/formats/cell_sites.h"
#include "engine/molecule/formats/mmcif_model.h"
#include "engine/molecule/space_group.h"
#include "engine/molecule/text.h"

namespace nacre {

namespace {

/// A number without its standard uncertainty; empty if missing.
std::optional<double> number(const MmcifTable& table, std::size_t row, std::initializer_list<const char*> columns) {
    const auto text = table.get(row, columns);
    return text ? MmcifCell(*text).number() : std::nullopt;
}

gemmi::UnitCell readCell(const std::string& name, const MmcifTable& table) {
    static constexpr const char* kColumns[6] = {"length_a",    "length_b",   "length_c",
                                                "angle_alpha", "angle_beta", "angle_gamma"};
    std::array<double, 6> value{};
    for (std::size_t i = 0; i < value.size(); ++i) {
        const auto given = table.rows() > 0 ? number(table, 0, {kColumns[i]}) : std::nullopt;
        const double high = i < 3 ? 1e6 : 180;
        if (!given || !(*given > 0 && *given < high))
            cannotRead(name,
                       std::string("_cell_") + kColumns[i] +
                           " is missing or impossible, without which fractional coordinates mean nothing",
                       table.lineNumber(0));
        value[i] = *given;
    }
    gemmi::UnitCell cell;
    cell.set(value[0], value[1], value[2], value[3], value[4], value[5]);
    if (!(cell.volume > 1e-6 && std::isfinite(cell.volume))) cannotRead(name, "the unit cell has no volume");
    return cell;
}

/// Symbols of a sum formula: "C12 H8 Cu" has C, H and Cu.
std::vector<Element> elementsOfFormula(std::string_view formula) {
    std::vector<Element> elements;
    const Words words = splitWords(formula);
    for (std::size_t i = 0; i < words.count; ++i) {
        const std::string_view symbol =
            words[i].substr(0, std::min(words[i].find_first_of("0123456789."), std::size_t{2}));
        if (const Element element = elementFromSymbol(symbol)) elements.push_back(element);
    }
    return elements;
}

/// By a site's label: "C27" is carbon, "Cu1" and "CL2" are copper and chlorine; the symbol precedes the label's digits.
/// Minerals have "Wat1", "OW3" and "O-H1" for the oxygen of waters and hydroxyls, and "T1" or "M2" for sites that
/// several elements share. @param formula  its elements have precedence
Element elementOfLabel(std::string_view label, const std::vector<Element>& formula) {
    std::size_t letters = 0;
    while (letters < label.size() && isLetter(label[letters])) ++letters;
    const std::string start = lowerCase(label.substr(0, letters));
    if (start == "wat" || start == "wa" || start == "ow" || start == "oh") return elementFromSymbol("O");
    // Crystals of elements far beyond uranium do not exist: "NH1" is nitrogen.
    constexpr Element kHeaviest = 98, kDeuterium = 119;
    const auto known = [&](std::size_t length) {
        const Element element = letters < length ? Element{0} : elementFromSymbol(label.substr(0, length));
        return element <= kHeaviest || element == kDeuterium ? element : Element{0};
    };
    const bool usable = formula.size() > 1;
    for (const Element element : {known(2), known(1)})
        if (usable && element != 0 && std::ranges::find(formula, element) != formula.end()) return element;
    return known(2) != 0 ? known(2) : known(1);
}

/// Disorder groups 1, 2, ... become alternate locations A, B, ...; -1 marks disorder about a special position.
char readAlternate(const MmcifTable& atoms, std::size_t row) {
    const auto group = number(atoms, row, {"disorder_group"});
    if (!group || *group == 0 || !(std::abs(*group) <= 26)) return '\0';
    return static_cast<char>('A' + static_cast<int>(std::abs(*group)) - 1);
}

Atom readAtom(MoleculeBuilder& builder, const MmcifTable& atoms, std::size_t row, const std::vector<Element>& formula) {
    Atom atom;
    const auto label = atoms.get(row, {"label"}).value_or("");
    const auto type = atoms.get(row, {"type_symbol"});
    atom.name = Name(label);
    if (type) {
        atom.element = builder.element(*type, atoms.lineNumber(row));
    } else {
        atom.element = elementOfLabel(label, formula);
        if (atom.element == 0) builder.element(label, atoms.lineNumber(row));  // counts it as unknown
        builder.guess("elements", "from site labels");
    }
    atom.alternate = readAlternate(atoms, row);
    atom.hetero = true;
    const auto inRange = [](std::optional<double> value) { return value && std::abs(*value) <= 1e9; };
    if (const auto share = number(atoms, row, {"occupancy"}); inRange(share))
        atom.occupancy = static_cast<float>(*share);
    if (const auto b = number(atoms, row, {"b_iso_or_equiv"}); inRange(b))
        atom.temperatureFactor = static_cast<float>(*b);
    else if (const auto u = number(atoms, row, {"u_iso_or_equiv"}); inRange(u))
        atom.temperatureFactor = static_cast<float>(*u * kEightPiSquared);
    return atom;
}

/// Fractional coordinates; empty, with a note, if one is not a number, or '?' as for hydrogens that were not located.
std::optional<gemmi::Fractional> readPosition(MoleculeBuilder& builder, const MmcifTable& atoms, std::size_t row) {
    static constexpr const char* kColumns[3] = {"fract_x", "fract_y", "fract_z"};
    std::array<double, 3> value{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto text = atoms.get(row, {kColumns[axis]});
        const auto given = text ? MmcifCell(*text).number() : std::nullopt;
        if (given && std::abs(*given) <= 1e6) {
            value[axis] = *given;
            continue;
        }
        if (text)
            builder.leaveOutAtom(std::string(kColumns[axis]) + " of row " + std::to_string(row + 1) +
                                     " of _atom_site is not a finite number: '" + printable(*text) + "'",
                                 atoms.lineNumber(row));
        else
            builder.leaveOut("atoms", "no usable coordinates", atoms.lineNumber(row));
        return std::nullopt;
    }
    return gemmi::Fractional(value[0], value[1], value[2]);
}

/// Operations that the file lists, else those of its space group.
std::vector<gemmi::Op> listOperations(const SmallMoleculeTables& tables) {
    std::vector<gemmi::Op> operations;
    const MmcifTable& symmetry = tables.symmetry;
    for (std::size_t row = 0; row < symmetry.rows(); ++row) {
        const auto text = symmetry.get(row, {"pos_as_xyz", "operation_xyz"});
        if (!text) throw AssemblyFault("a symmetry operation is missing");
        const std::optional<gemmi::Op> operation = parseTriplet(*text);
        if (!operation) throw AssemblyFault("'" + printable(*text) + "' is not a symmetry operation");
        operations.push_back(*operation);
    }
    if (!operations.empty() || tables.spaceGroup.empty()) return operations;
    const gemmi::SpaceGroup* group = findSpaceGroup(tables.spaceGroup);
    if (!group) throw AssemblyFault("there is no space group '" + printable(tables.spaceGroup) + "'");
    for (const gemmi::Op operation : group->operations()) operations.push_back(operation);
    return operations;
}

constexpr float kSameSite = 0.1f;        // Å
constexpr std::size_t kMostOnSite = 26;  // A to Z

/// Atoms by position, to find those on one site. Tests few atoms per query, whatever their number and positions.
class SitePlaces {
public:
    /// @param order  indices of atoms; fully occupied ones are left out
    SitePlaces(const std::vector<Atom>& atoms, const std::vector<std::uint32_t>& order) : atoms_(atoms), order_(order) {
        cubes_.reserve(order.size());
        for (std::uint32_t rank = 0; rank < order.size(); ++rank) {
            const Atom& atom = atoms[order[rank]];
            if (atom.occupancy >= 1) continue;
            std::vector<std::uint32_t>& cube = cubes_[makeKey(glm::floor(glm::dvec3(atom.position) / kCube))];
            if (cube.size() <= kMostAround) cube.push_back(rank);
        }
    }

    /// Higher ranks, ascending, of atoms within kSameSite of this one. Empty also in a crowd.
    std::vector<std::uint32_t> behind(std::uint32_t rank) const {
        const glm::vec3& place = atoms_[order_[rank]].position;
        // Within half a cube of a position there are eight cubes.
        const glm::i64vec3 low = glm::floor(glm::dvec3(place) / kCube - 0.5);
        std::vector<std::uint32_t> found;
        std::size_t around = 0;
        for (int corner = 0; corner < 8; ++corner) {
            const auto cube = cubes_.find(makeKey(low + glm::i64vec3(corner & 1, corner >> 1 & 1, corner >> 2)));
            if (cube == cubes_.end()) continue;
            if ((around += cube->second.size()) > kMostAround) return {};
            for (const std::uint32_t other : cube->second)
                if (other > rank && glm::distance(atoms_[order_[other]].position, place) <= kSameSite)
                    found.push_back(other);
        }
        std::sort(found.begin(), found.end());
        return found;
    }

private:
    static constexpr double kCube = 2.0 * kSameSite;
    static constexpr std::size_t kMostAround = 8 * kMostOnSite;

    /// Cubes with equal keys cost time, but do not change the result.
    static std::uint64_t makeKey(const glm::i64vec3& cube) {
        std::uint64_t key = 0;
        for (int axis = 0; axis < 3; ++axis) key = (key ^ static_cast<std::uint64_t>(cube[axis])) * 0x9e3779b97f4a7c15u;
        return key ^ key >> 32;
    }

    const std::vector<Atom>& atoms_;
    const std::vector<std::uint32_t>& order_;
    std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cubes_;
};

/// Atoms of different elements on one site, with occupancies of at most one in total, become alternate locations, the
/// most frequent first. The same applies to disordered atoms marked by "?" after the label of the other.
void separateSharedSites(MoleculeBuilder& builder) {
    std::vector<Atom>& atoms = builder.molecule().atoms;
    constexpr float kFull = 1.01f;
    std::vector<std::uint32_t> order(atoms.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return atoms[a].position.x < atoms[b].position.x; });
    const auto share = [&](std::vector<std::uint32_t>& site, float whole) {
        const bool labelled = std::ranges::any_of(site, [&](std::uint32_t i) { return atoms[i].alternate; });
        if (site.size() < 2 || site.size() > kMostOnSite || labelled || whole > kFull) return;
        std::stable_sort(site.begin(), site.end(), [&](std::uint32_t a, std::uint32_t b) {
            return atoms[a].occupancy != atoms[b].occupancy ? atoms[a].occupancy > atoms[b].occupancy : a < b;
        });
        for (std::size_t k = 0; k < site.size(); ++k) atoms[site[k]].alternate = static_cast<char>('A' + k);
        builder.guess("alternate locations", "elements that share a site: the most frequent is drawn",
                      static_cast<std::int64_t>(site.size()));
    };
    const SitePlaces places(atoms, order);
    std::size_t sites = 0;
    for (std::uint32_t i = 0; i < order.size(); ++i) {
        const Atom& first = atoms[order[i]];
        if (first.alternate || first.occupancy >= 1) continue;
        std::vector<std::uint32_t> site{order[i]};
        float whole = first.occupancy;
        for (const std::uint32_t j : places.behind(i)) {
            site.push_back(order[j]);
            whole += atoms[order[j]].occupancy;
        }
        share(site, whole);
        sites += first.alternate != '\0';
    }
    if (sites > 0)
        builder.warn("sites that several elements share: " + std::to_string(sites) +
                     "; the element of the highest occupancy is drawn, the others are alternate locations");
    std::map<std::string, std::uint32_t, std::less<>> byLabel;
    for (std::uint32_t i = 0; i < atoms.size(); ++i) byLabel.emplace(atoms[i].name.view(), i);
    for (Atom& atom : atoms) {
        const std::string_view label = atom.name.view();
        if (atom.alternate || label.size() < 2 || label.back() != '?') continue;
        const auto other = byLabel.find(label.substr(0, label.size() - 1));
        if (other == byLabel.end() || atoms[other->second].alternate > 'A') continue;
        atoms[other->second].alternate = 'A';
        atom.alternate = 'B';
        builder.guess("alternate locations", "from question marks in labels");
    }
}

/// Names of a tensor's columns: of _atom_site_aniso, with "aniso_" in front in _atom_site.
struct TensorColumns {
    int i, j;
    const char *u, *matrixU, *anisoU, *b, *matrixB, *anisoB, *beta, *anisoBeta;
};
constexpr TensorColumns kTensorColumns[6] = {
    {0, 0, "u_11", "matrix_u_11", "aniso_u_11", "b_11", "matrix_b_11", "aniso_b_11", "beta_11", "aniso_beta_11"},
    {1, 1, "u_22", "matrix_u_22", "aniso_u_22", "b_22", "matrix_b_22", "aniso_b_22", "beta_22", "aniso_beta_22"},
    {2, 2, "u_33", "matrix_u_33", "aniso_u_33", "b_33", "matrix_b_33", "aniso_b_33", "beta_33", "aniso_beta_33"},
    {0, 1, "u_12", "matrix_u_12", "aniso_u_12", "b_12", "matrix_b_12", "aniso_b_12", "beta_12", "aniso_beta_12"},
    {0, 2, "u_13", "matrix_u_13", "aniso_u_13", "b_13", "matrix_b_13", "aniso_b_13", "beta_13", "aniso_beta_13"},
    {1, 2, "u_23", "matrix_u_23", "aniso_u_23", "b_23", "matrix_b_23", "aniso_b_23", "beta_23", "aniso_beta_23"}};

/// The tensor in Cartesian axes of U_ij (or B_ij = 8 pi^2 U_ij) in units of the reciprocal axes, by which the file
/// scales them, or of beta_ij = 2 pi^2 a*_i a*_j U_ij (R. W. Grosse-Kunstleve and P. D. Adams, J. Appl. Cryst. 35
/// (2002) 477). Empty without six numbers.
std::optional<Displacement> readDisplacement(const gemmi::UnitCell& cell, const MmcifTable& table, std::size_t row) {
    const double reciprocal[3] = {cell.ar, cell.br, cell.cr};
    glm::dmat3 ofAxes(0.0);
    for (const TensorColumns& c : kTensorColumns) {
        double u = 0;
        if (const auto own = number(table, row, {c.u, c.matrixU, c.anisoU}))
            u = *own;
        else if (const auto b = number(table, row, {c.b, c.matrixB, c.anisoB}))
            u = *b / kEightPiSquared;
        else if (const auto beta = number(table, row, {c.beta, c.anisoBeta}))
            u = *beta * 4 / (kEightPiSquared * reciprocal[c.i] * reciprocal[c.j]);
        else
            return std::nullopt;
        ofAxes[c.i][c.j] = ofAxes[c.j][c.i] = u;
    }
    glm::dmat3 turn(0.0);  // columns: cell edge times its reciprocal length
    for (int row3 = 0; row3 < 3; ++row3)
        for (int column = 0; column < 3; ++column)
            turn[column][row3] = cell.orth.mat[row3][column] * reciprocal[column];
    return toDisplacement(turn * ofAxes * glm::transpose(turn));
}

/// Whether any of a row's numbers is stated.
bool statesDisplacement(const MmcifTable& table, std::size_t row) {
    return std::ranges::any_of(kTensorColumns, [&](const TensorColumns& c) {
        return table.get(row, {c.u, c.matrixU, c.anisoU, c.b, c.matrixB, c.anisoB, c.beta, c.anisoBeta}).has_value();
    });
}

enum class Tensors : std::uint8_t { ofEachRow, ofSomeRows };  ///< what a table is expected to state

/// @param sites  atoms by their labels
void addDisplacements(MoleculeBuilder& builder, const gemmi::UnitCell& cell, const MmcifTable& table, Tensors tensors,
                      const std::map<std::string, std::uint32_t, std::less<>>& sites) {
    std::vector<Displacement>& all = builder.molecule().displacements;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        if (tensors == Tensors::ofSomeRows && !statesDisplacement(table, row)) continue;
        const auto site = sites.find(table.get(row, {"label"}).value_or(""));
        const auto u = readDisplacement(cell, table, row);
        if (!u || site == sites.end()) {
            builder.leaveOut("anisotropic displacements", u ? "of no atom" : "not six usable numbers",
                             table.lineNumber(row));
            continue;
        }
        all.resize(builder.molecule().atoms.size());
        all[site->second] = *u;
    }
}

}  // namespace

void addSmallMolecule(MoleculeBuilder& builder, const SmallMoleculeTables& tables) {
    const gemmi::UnitCell cell = readCell(builder.name(), tables.cell);
    std::vector<gemmi::Op> operations;
    std::string fault;
    try {
        operations = listOperations(tables);
    } catch (const AssemblyFault& without) {
        fault = without.what();
    }
    const bool formulated = tables.chemical.rows() > 0;
    const std::vector<Element> formula =
        elementsOfFormula(formulated ? tables.chemical.get(0, {"formula_sum"}).value_or("") : std::string_view());
    CellSites sites(cell, operations);
    std::map<std::string, std::uint32_t, std::less<>> byLabel;
    std::uint32_t placed = 0;
    for (std::size_t row = 0; row < tables.atoms.rows(); ++row) {
        const auto fractional = readPosition(builder, tables.atoms, row);
        if (!fractional) continue;
        Atom atom = readAtom(builder, tables.atoms, row, formula);
        const gemmi::Position position = cell.orthogonalize(*fractional);
        bool near = true;
        for (int axis = 0; axis < 3; ++axis) {
            near = near && std::abs(position.at(axis)) <= kFarthestCoordinate;
            atom.position[axis] = static_cast<float>(position.at(axis));
        }
        if (!near) {
            builder.leaveOutAtom("the position in row " + std::to_string(row + 1) + " of _atom_site is too far away",
                                 tables.atoms.lineNumber(row));
            continue;
        }
        builder.addAtom(atom, "", 1, '\0', "", sites.add(*fractional));
        byLabel.emplace(tables.atoms.get(row, {"label"}).value_or(""), placed++);
    }
    addDisplacements(builder, cell, tables.atoms, Tensors::ofSomeRows, byLabel);
    addDisplacements(builder, cell, tables.displacements, Tensors::ofEachRow, byLabel);
    separateSharedSites(builder);
    builder.molecule().file.models = 1;
    builder.molecule().file.totalAtomsAllModels = std::int64_t{placed};
    if (!fault.empty()) builder.warn("the unit cell is left out: " + fault);
    sites.addUnitCell(builder);
}

}  // namespace nacre
