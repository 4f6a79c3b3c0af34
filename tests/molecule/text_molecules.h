#pragma once
// The same atom in every text format, with the coordinates that a test asks for.

#include <functional>
#include <string>
#include <vector>

namespace nacre::test {

struct AtomText {
    std::string name;  ///< of a file of the format
    std::function<std::string(const std::string& x)> with;
};

/// @param x  is written as it stands, so that it may be no number
inline std::vector<AtomText> oneAtomTexts() {
    const auto padded = [](const std::string& x) { return std::string(x.size() < 8 ? 8 - x.size() : 0, ' ') + x; };
    return {{"a.pdb",
             [=](const std::string& x) {
                 return "ATOM      1  C   LIG A   1    " + padded(x) + "   0.000   0.000  1.00  0.00           C\n";
             }},
            {"a.pdbqt",
             [=](const std::string& x) {
                 return "ATOM      1  C   LIG A   1    " + padded(x) + "   0.000   0.000  1.00  0.00     0.000 C \n";
             }},
            {"a.pqr", [](const std::string& x) { return "ATOM 1 C LIG 1 " + x + " 0.000 0.000 0.0000 1.7000\n"; }},
            {"a.xyz", [](const std::string& x) { return "1\n\nC " + x + " 0 0\n"; }},
            {"a.gro",
             [=](const std::string& x) {
                 return "title\n1\n    1LIG      C    1" + padded(x) + "     0.0     0.0\n   1.0   1.0   1.0\n";
             }},
            {"a.mol2",
             [](const std::string& x) {
                 return "@<TRIPOS>MOLECULE\na\n1 0\nSMALL\nNO_CHARGES\n@<TRIPOS>ATOM\n1 C " + x + " 0 0 C.3\n";
             }},
            {"a.sdf",
             [](const std::string& x) {
                 return "a\n\n\n  1  0  0     0  0            999 V2000\n" + x + " 0.0 0.0 C 0 0\nM  END\n";
             }},
            {"b.sdf",
             [](const std::string& x) {
                 return "a\n\n\n  0  0  0     0  0            999 V3000\nM  V30 BEGIN CTAB\nM  V30 COUNTS 1 0 0 0 0\n"
                        "M  V30 BEGIN ATOM\nM  V30 1 C " +
                        x + " 0 0 0\nM  V30 END ATOM\nM  V30 END CTAB\nM  END\n";
             }},
            {"a.cml",
             [](const std::string& x) {
                 return "<cml><molecule><atomArray>\n<atom id='a' elementType='C' x3='" + x +
                        "' y3='0' z3='0'/>\n</atomArray></molecule></cml>";
             }},
            {"a.cif",
             [](const std::string& x) {
                 return "data_a\nloop_\n_atom_site.type_symbol\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n"
                        "_atom_site.Cartn_z\nC " +
                        x + " 0 0\n";
             }},
            {"component.cif",
             [](const std::string& x) {
                 return "data_a\n_chem_comp_atom.atom_id C\n_chem_comp_atom.type_symbol C\n_chem_comp_atom.x " + x +
                        "\n_chem_comp_atom.y 0\n_chem_comp_atom.z 0\n";
             }},
            {"small.cif",
             [](const std::string& x) {
                 return "data_a\n_cell_length_a 1\n_cell_length_b 1\n_cell_length_c 1\n_cell_angle_alpha 90\n"
                        "_cell_angle_beta 90\n_cell_angle_gamma 90\nloop_\n_atom_site_label\n_atom_site_fract_x\n"
                        "_atom_site_fract_y\n_atom_site_fract_z\nC1 " +
                        x + " 0 0\n";
             }},
            {"a.json", [](const std::string& x) {
                 return "{\"data_a\": {\"atom_site\": {\"type_symbol\": [\"C\"],\n\"Cartn_x\": [\"" + x +
                        "\"], \"Cartn_y\": [0], \"Cartn_z\": [0]}}}";
             }}};
}

}  // namespace nacre::test
