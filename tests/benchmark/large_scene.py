#!/usr/bin/env python3
"""Writes a mesoscale model as mmCIF: proteins of PDB files, each an entity with many places in one assembly.

    tests/benchmark/large_scene.py --instances 1000000 --proteins 50 -o large.cif FILE.pdb...

Every chain of 400 to 4,000 protein atoms is a protein. Where the files have too few, they come again, mirrored. Places
lie on a jittered cubic lattice that the proteins fill, each turned at random. The same arguments write the same bytes.
"""

import argparse
import gzip
import math
import random


def chains(path):
    """Lists of (element, atom, residue, number, x, y, z), of the first model."""
    found = {}
    with (gzip.open(path, "rt") if path.endswith(".gz") else open(path)) as lines:
        for line in lines:
            if line.startswith("ENDMDL"):
                break
            if not line.startswith("ATOM  ") or line[16] not in " A" or line[12:16].strip().startswith("H"):
                continue
            name = line[12:16]
            element = line[76:78].strip() or name.strip("0123456789 ")[:1]
            place = (float(line[30:38]), float(line[38:46]), float(line[46:54]))
            found.setdefault(line[21], []).append(
                (element, name.strip(), line[17:20].strip(), int(line[22:26]), *place))
    return [atoms for atoms in found.values() if 400 <= len(atoms) <= 4000]


def proteins(paths, count):
    known = [atoms for path in paths for atoms in chains(path)]
    if not known:
        raise SystemExit("no chain of 400 to 4,000 protein atoms")
    made = []
    for i in range(count):
        side = -1 if i // len(known) % 2 else 1
        atoms = known[i % len(known)]
        middle = [sum(a[k] for a in atoms) / len(atoms) for k in (4, 5, 6)]
        made.append([(*a[:4], side * (a[4] - middle[0]), a[5] - middle[1], a[6] - middle[2]) for a in atoms])
    return made


def turn(rng):
    """A random rotation, from a unit quaternion."""
    q = [rng.gauss(0, 1) for _ in range(4)]
    size = math.sqrt(sum(c * c for c in q))
    w, x, y, z = (c / size for c in q)
    return ((1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)),
            (2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)),
            (2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)))


def write(out, made, instances, seed):
    rng = random.Random(seed)
    out.write("data_large\n_struct.title 'mesoscale model'\nloop_\n_entity.id\n_entity.type\n")
    for i in range(len(made)):
        out.write(f"{i + 1} polymer\n")
    out.write("loop_\n_pdbx_struct_assembly.id\n_pdbx_struct_assembly.details\n1 'all places'\n"
              "loop_\n_pdbx_struct_assembly_gen.assembly_id\n_pdbx_struct_assembly_gen.oper_expression\n"
              "_pdbx_struct_assembly_gen.asym_id_list\n")
    ends = [instances * i // len(made) for i in range(len(made) + 1)]
    for i in range(len(made)):
        if ends[i] < ends[i + 1]:
            out.write(f"1 {ends[i] + 1}-{ends[i + 1]} P{i + 1}\n")
    out.write("loop_\n_pdbx_struct_oper_list.id\n")
    for row in "123":
        for column in "123":
            out.write(f"_pdbx_struct_oper_list.matrix[{row}][{column}]\n")
        out.write(f"_pdbx_struct_oper_list.vector[{row}]\n")
    side = math.ceil(instances ** (1 / 3))
    radii = [max(math.hypot(*a[4:]) for a in atoms) for atoms in made]
    step = 1.5 * sum(radii) / len(radii)
    places = list(range(instances))
    rng.shuffle(places)
    for i, place in enumerate(places):
        cell = (place % side, place // side % side, place // side // side)
        shift = [(c - side / 2 + rng.uniform(-0.2, 0.2)) * step for c in cell]
        rows = " ".join("%.5f %.5f %.5f %.3f" % (*row, s) for row, s in zip(turn(rng), shift))
        out.write(f"{i + 1} {rows}\n")
    out.write("loop_\n_atom_site.group_PDB\n_atom_site.id\n_atom_site.type_symbol\n_atom_site.label_atom_id\n"
              "_atom_site.label_comp_id\n_atom_site.label_asym_id\n_atom_site.label_entity_id\n"
              "_atom_site.label_seq_id\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n")
    number = 0
    for i, atoms in enumerate(made):
        for element, name, residue, at, x, y, z in atoms:
            number += 1
            out.write(f'ATOM {number} {element} "{name}" {residue} P{i + 1} {i + 1} {at} {x:.3f} {y:.3f} {z:.3f}\n')


def main():
    options = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    options.add_argument("files", nargs="+")
    options.add_argument("--instances", type=int, default=1_000_000)
    options.add_argument("--proteins", type=int, default=50)
    options.add_argument("--seed", type=int, default=1)
    options.add_argument("-o", "--output", required=True)
    given = options.parse_args()
    made = proteins(given.files, given.proteins)
    with open(given.output, "w") as out:
        write(out, made, given.instances, given.seed)


if __name__ == "__main__":
    main()
