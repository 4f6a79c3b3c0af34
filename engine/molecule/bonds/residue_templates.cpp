#include "engine/molecule/bonds/residue_templates.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <unordered_map>

namespace nacre {
namespace {

// Bonds as "A-B" (single) and "A=B" (double), separated by spaces. Constitution as in any textbook of biochemistry.
constexpr std::string_view kPeptide = "N-CA CA-C C=O C-OXT ";
constexpr std::string_view kDeoxyribose =
    "OP3-P P=OP1 P-OP2 P-O5' O5'-C5' C5'-C4' C4'-O4' C4'-C3' C3'-O3' C3'-C2' C2'-C1' C1'-O4' ";
constexpr std::string_view kRiboseHydroxyl = "C2'-O2' ";
constexpr std::string_view kPurine = "C1'-N9 N9-C8 C8=N7 N7-C5 C5=C4 C4-N9 C5-C6 N1-C2 C2=N3 N3-C4 ";
constexpr std::string_view kPyrimidine = "C1'-N1 N1-C2 C2=O2 C2-N3 C4-C5 C5=C6 C6-N1 ";

struct Source {
    std::string_view names;  // of residues, separated by spaces
    std::string_view bonds;  // beyond those shared by the kind
};

constexpr Source kAminoAcids[] = {
    {"GLY", ""},
    {"ALA", "CA-CB"},
    {"SER", "CA-CB CB-OG"},
    {"CYS CYX CYM", "CA-CB CB-SG"},
    {"SEC", "CA-CB CB-SE"},
    {"THR", "CA-CB CB-OG1 CB-CG2"},
    {"VAL", "CA-CB CB-CG1 CB-CG2"},
    {"LEU", "CA-CB CB-CG CG-CD1 CG-CD2"},
    {"ILE", "CA-CB CB-CG1 CB-CG2 CG1-CD1"},
    {"MET", "CA-CB CB-CG CG-SD SD-CE"},
    {"MSE", "CA-CB CB-CG CG-SE SE-CE"},
    {"PRO", "CA-CB CB-CG CG-CD CD-N"},
    {"ASP ASH", "CA-CB CB-CG CG=OD1 CG-OD2"},
    {"ASN", "CA-CB CB-CG CG=OD1 CG-ND2"},
    {"GLU GLH", "CA-CB CB-CG CG-CD CD=OE1 CD-OE2"},
    {"GLN", "CA-CB CB-CG CG-CD CD=OE1 CD-NE2"},
    {"LYS LYN", "CA-CB CB-CG CG-CD CD-CE CE-NZ"},
    {"PYL", "CA-CB CB-CG CG-CD CD-CE CE-NZ NZ-C2 C2=O2 C2-CA2 CA2-CB2 CB2-CG2 CB2-CD2 CG2-CE2 CE2=N2 N2-CA2"},
    {"ARG", "CA-CB CB-CG CG-CD CD-NE NE-CZ CZ-NH1 CZ=NH2"},
    {"HIS HID HIE HIP HSD HSE HSP", "CA-CB CB-CG CG-ND1 CG=CD2 ND1=CE1 CD2-NE2 CE1-NE2"},
    {"PHE", "CA-CB CB-CG CG=CD1 CG-CD2 CD1-CE1 CD2=CE2 CE1=CZ CE2-CZ"},
    {"TYR", "CA-CB CB-CG CG=CD1 CG-CD2 CD1-CE1 CD2=CE2 CE1=CZ CE2-CZ CZ-OH"},
    {"TRP", "CA-CB CB-CG CG=CD1 CG-CD2 CD1-NE1 NE1-CE2 CD2=CE2 CD2-CE3 CE3=CZ3 CZ3-CH2 CH2=CZ2 CZ2-CE2"},
};

struct BaseSource {
    std::string_view names;  // of residues; names that start with D, and T, have no O2'
    bool purine;
    std::string_view bonds;
};

constexpr BaseSource kBases[] = {
    {"A DA", true, "C6=N1 C6-N6"},  {"G DG", true, "C6=O6 C6-N1 C2-N2"}, {"I DI", true, "C6=O6 C6-N1"},
    {"C DC", false, "N3=C4 C4-N4"}, {"U DU", false, "N3-C4 C4=O4"},      {"DT T", false, "N3-C4 C4=O4 C5-C7"},
};

// At modest resolution, the geometry of haems shows neither bonds nor orders: 4HHB's reach 2.4 Å. Orders as in the
// chemical component dictionary; the metal is bonded by distance.
constexpr Source kCofactors[] = {
    {"HEM",
     "CHA-C1A CHA=C4D CHB-C4A CHB=C1B CHC-C4B CHC=C1C CHD=C4C CHD-C1D C1A=C2A C1A-NA C2A-C3A C2A-CAA C3A=C4A C3A-CMA "
     "C4A-NA CAA-CBA CBA-CGA CGA=O1A CGA-O2A C1B-C2B C1B-NB C2B=C3B C2B-CMB C3B-C4B C3B-CAB C4B=NB CAB=CBB C1C-C2C "
     "C1C-NC C2C=C3C C2C-CMC C3C-C4C C3C-CAC C4C-NC CAC=CBC C1D-C2D C1D=ND C2D=C3D C2D-CMD C3D-C4D C3D-CAD C4D-ND "
     "CAD-CBD CBD-CGD CGD=O1D CGD-O2D"},
};

template <typename Visit>
void forEachWord(std::string_view text, const Visit& visit) {
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(' '), text.size());
        if (end > 0) visit(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
}

std::uint8_t indexOf(ResidueTemplate& residue, std::string_view atom) {
    const auto found = std::find(residue.atoms.begin(), residue.atoms.end(), Name(atom));
    const auto index = static_cast<std::uint8_t>(found - residue.atoms.begin());
    if (found == residue.atoms.end()) residue.atoms.push_back(atom);
    return index;
}

void addBonds(ResidueTemplate& residue, std::string_view bonds) {
    forEachWord(bonds, [&](std::string_view bond) {
        const std::size_t mark = bond.find_first_of("-=");
        const std::uint8_t a = indexOf(residue, bond.substr(0, mark));
        const std::uint8_t b = indexOf(residue, bond.substr(mark + 1));
        residue.bonds.push_back({a, b, static_cast<std::uint8_t>(bond[mark] == '=' ? 2 : 1)});
    });
}

struct NameHash {
    std::size_t operator()(const Name& name) const {
        return std::hash<std::string_view>()({name.bytes.data(), name.bytes.size()});
    }
};
using Table = std::unordered_map<Name, ResidueTemplate, NameHash>;

Table makeTable() {
    Table table;
    for (const Source& source : kAminoAcids) {
        forEachWord(source.names, [&](std::string_view name) {
            addBonds(table[name], kPeptide);
            addBonds(table[name], source.bonds);
        });
    }
    for (const BaseSource& source : kBases) {
        forEachWord(source.names, [&](std::string_view name) {
            ResidueTemplate& residue = table[name];
            addBonds(residue, kDeoxyribose);
            // Old files also name deoxynucleotides "A"; the O2' bond is then unused.
            if (name.front() != 'D' && name != "T") addBonds(residue, kRiboseHydroxyl);
            addBonds(residue, source.purine ? kPurine : kPyrimidine);
            addBonds(residue, source.bonds);
        });
    }
    for (const Source& source : kCofactors) {
        ResidueTemplate& residue = table[source.names];
        residue.polymer = false;
        addBonds(residue, source.bonds);
    }
    return table;
}

}  // namespace

const ResidueTemplate* bondTemplate(const Name& residueName) {
    static const Table table = makeTable();
    auto found = table.find(residueName);
    if (found == table.end()) found = table.find(threeLetterName(residueName));
    return found == table.end() ? nullptr : &found->second;
}

const ResidueTemplate* residueTemplate(const Name& residueName) {
    const ResidueTemplate* found = bondTemplate(residueName);
    return found && found->polymer ? found : nullptr;
}

Name threeLetterName(const Name& residueName) {
    const std::string_view name = residueName.view();
    if (name.size() != 4) return residueName;
    constexpr std::string_view kStates =
        "HISE=HIE HISD=HID HISA=HID HISB=HIE HISH=HIP HISP=HIP HIS1=HID HIS2=HIE CYSH=CYS CYSX=CYX CYS1=CYS CYS2=CYX "
        "LYSH=LYS LYSN=LYN ASPH=ASH GLUH=GLH ARGN=ARG ";
    if (const std::size_t at = kStates.find(std::string(name) + "="); at != std::string_view::npos)
        return Name(kStates.substr(at + name.size() + 1, 3));
    // "NALA" and "CALA" are the ends of a chain.
    const std::string_view inner = name.substr(1);
    const bool end = name[0] == 'N' || name[0] == 'C';
    return end && std::any_of(std::begin(kAminoAcids), std::end(kAminoAcids),
                              [&](const Source& source) { return source.names.find(inner) != std::string_view::npos; })
               ? Name(inner)
               : residueName;
}

Name currentAtomName(const Name& name) {
    if (name == Name("O1P")) return Name("OP1");
    if (name == Name("O2P")) return Name("OP2");
    if (name == Name("O3P")) return Name("OP3");
    if (name == Name("C5M")) return Name("C7");
    Name current = name;
    std::replace(current.bytes.begin(), current.bytes.end(), '*', '\'');
    return current;
}

}  // namespace nacre
