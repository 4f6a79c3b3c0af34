#!/usr/bin/python3
"""Debian's plipcmd 2.2 with the corrections to water bridges, acceptors and cation-pi contacts of PLIP 2.3.1, which
bookworm lacks: plip_corrected.py ARGUMENTS"""

import importlib.abc
import importlib.machinery
import importlib.util
import runpy
import shutil
import sys

BRIDGE = "(wbridge.water_orig_idx, wbridge.a_orig_idx)"
# By module: what stands there, what it becomes, how often.
CORRECTIONS = {
    "plip.structure.detection": [
        ("vecangle(vector(acc.a.coords, wl.oxy.coords)", "vecangle(vector(wl.oxy.coords, acc.a.coords)", 2),
    ],
    "plip.structure.preparation": [
        ("in filter(lambda at: at.OBAtom.IsHbondAcceptor(), all_atoms)", "in all_atoms", 1),
        ("a_set.append(data(a=atom, a_orig_atom", "if a_orig_atom.OBAtom.IsHbondAcceptor(): a_set.append(data(a=atom, a_orig_atom", 1),
        ("[hb.d.idx for hb in", "[hb.d_orig_idx for hb in", 1),
        ("if wb.d.idx not in donor_atoms_hbonds", "if wb.d_orig_idx not in donor_atoms_hbonds", 1),
        ("(wbridge.water.idx, wbridge.a.idx)", BRIDGE, 4),
        (f"wb_dict[{BRIDGE}].w_angle) < abs(", f"wb_dict[{BRIDGE}].w_angle) > abs(", 1),
        ("if wb_dict2[water][1][0] < abs(", "if wb_dict2[water][1][0] > abs(", 1),
        ("if whichrestype(stack.proteinring.atoms[0]) == 'HIS' and",
         "if picat.restype == 'HIS' and whichresnumber(stack.proteinring.atoms[0]) == picat.resnr and", 1),
    ],
}


class Corrected(importlib.machinery.SourceFileLoader):
    def get_code(self, name):
        source = self.get_data(self.path).decode()
        for old, new, count in CORRECTIONS[name]:
            if source.count(old) != count:
                sys.exit(f"{self.path}: {old!r} stands there {source.count(old)} times, not {count}")
            source = source.replace(old, new)
        return compile(source, self.path, "exec")


class Finder(importlib.abc.MetaPathFinder):
    def find_spec(self, name, path, target=None):
        if name not in CORRECTIONS:
            return None
        found = importlib.machinery.PathFinder.find_spec(name, path)
        return importlib.util.spec_from_file_location(name, found.origin, loader=Corrected(name, found.origin))


if __name__ == "__main__":
    sys.meta_path.insert(0, Finder())
    runpy.run_path(shutil.which("plipcmd"), run_name="__main__")
