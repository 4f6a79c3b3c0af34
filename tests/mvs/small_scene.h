#pragma once
// A small structure, a small map, and scenes of them.

#include <string>

#include "app/mvs/build_scene.h"
#include "engine/error.h"
#include "engine/scene/build/scene_guide.h"

namespace nacre::app::mvs {

/// Of tables of atoms.
inline const std::string kAtomColumns = R"(loop_
_atom_site.group_PDB
_atom_site.id
_atom_site.type_symbol
_atom_site.label_atom_id
_atom_site.label_comp_id
_atom_site.label_asym_id
_atom_site.label_entity_id
_atom_site.label_seq_id
_atom_site.auth_seq_id
_atom_site.auth_asym_id
_atom_site.Cartn_x
_atom_site.Cartn_y
_atom_site.Cartn_z
)";

/// Two residues of chain A (label A), a ligand B and a water C, as mmCIF has them.
inline const std::string kStructure = R"(data_TEST
_cell.length_a 30
_cell.length_b 40
_cell.length_c 50
_cell.angle_alpha 90
_cell.angle_beta 90
_cell.angle_gamma 90
_symmetry.space_group_name_H-M 'P 21 21 21'
loop_
_entity.id
_entity.type
1 polymer
2 non-polymer
3 water
loop_
_entity_poly.entity_id
_entity_poly.type
1 polypeptide(L)
)" + kAtomColumns + R"(ATOM 11 N N ALA A 1 1 101 X 1 2 3
ATOM 12 C CA ALA A 1 1 101 X 2 2 3
ATOM 13 C C ALA A 1 1 101 X 3 2 3
ATOM 14 O O ALA A 1 1 101 X 3 3 3
ATOM 15 N N GLY A 1 2 102 X 4 2 3
ATOM 16 C CA GLY A 1 2 102 X 5 2 3
HETATM 17 C C1 LIG B 2 . 200 X 9 2 3
HETATM 18 O O1 LIG B 2 . 200 X 10 2 3
HETATM 19 O O HOH C 3 . 301 X 1 9 3
)";

/// 27 nodes, 1 Å apart from the origin on: 1 in the middle, else 0.
inline const char* const kMap = R"(object 1 class gridpositions counts 3 3 3
origin 0 0 0
delta 1 0 0
delta 0 1 0
delta 0 0 1
object 2 class gridconnections counts 3 3 3
object 3 class array type double rank 0 items 27 data follows
0 0 0 0 0 0 0 0 0
0 0 0 0 1 0 0 0 0
0 0 0 0 0 0 0 0 0
)";

inline std::string volume(const std::string& params, const std::string& children = "", const std::string& beside = "") {
    return R"({"root": {"kind": "root", "children": [{"kind": "download", "params": {"url": "m.dx"}, "children": [
        {"kind": "parse", "params": {"format": "dx"}, "children": [{"kind": "volume", "children": [)" +
           beside + R"({"kind": "volume_representation", "params": )" + params + R"(, "children": [)" + children +
           "]}]}]}]}]}}";
}

inline std::string scene(const std::string& children, const std::string& more = "",
                         const std::string& type = R"("model")") {
    return R"({"root": {"kind": "root", "children": [{"kind": "download", "params": {"url": "a.cif"}, "children": [
        {"kind": "parse", "params": {"format": "mmcif"}, "children": [
        {"kind": "structure", "params": {"type": )" +
           type + R"(}, "children": [)" + children + "]}]}]}" + more + R"(]}, "metadata": {"version": "1"}})";
}

inline std::string component(const std::string& selector, const std::string& children) {
    return R"({"kind": "component", "params": {"selector": )" + selector + R"(}, "children": [)" + children + "]}";
}

inline std::string balls(const std::string& children = "") {
    return R"({"kind": "representation", "params": {"type": "ball_and_stick"}, "children": [)" + children + "]}";
}

inline Molecule built(const std::string& json, const std::string& annotations = "") {
    const SceneTree tree = parseScene(json, "scene.mvsj");
    SceneSources sources;
    sources.fetch = [&](const std::string& uri) {
        if (uri == "a.cif") return kStructure;
        if (uri == "b.json") return annotations;
        if (uri == "m.dx") return std::string(kMap);
        throw Error("cannot fetch", uri, "there is none");
    };
    return buildScene(tree, 0, "scene.mvsj", sources);
}

}  // namespace nacre::app::mvs
