"""The maps of the pictures in docs/maps.md that no file has: tools/draw_maps.py DATA FOLDER.

potential.dx   the screened Coulomb potential of 3pqr.pqr's charges, kT/e: a sum, no solution of the Poisson-Boltzmann equation
orbital.cube   the highest occupied pi orbital of benzene by Hueckel's method, from Slater's 2p orbitals
groel.mrc      a density at 8 Å of one ring of GroEL's model
groel_b.mrc    how mobile its atoms are: their mean B factor about each node
"""
import gzip
import os
import sys

import numpy as np

data, folder = sys.argv[1:3]


def box(places, step, room):
    first = np.floor((places.min(axis=0) - room) / step) * step
    size = np.ceil((places.max(axis=0) + room - first) / step).astype(int) + 1
    return first, size


def nodes_of(first, size, step):
    return [first[i] + step * np.arange(size[i]) for i in range(3)]


def add_about(grid, axes, place, reach, function):
    """Adds a function of squared distances to the nodes within reach of a place."""
    spans = [slice(*np.searchsorted(axis, (p - reach, p + reach))) for axis, p in zip(axes, place)]
    near = [axis[span] - p for axis, span, p in zip(axes, spans, place)]
    square = near[0][:, None, None] ** 2 + near[1][None, :, None] ** 2 + near[2][None, None, :] ** 2
    grid[tuple(spans)] += function(square)


def write_dx(path, first, step, grid):
    counts = " ".join(map(str, grid.shape))
    with open(path, "w") as file:
        file.write(f"object 1 class gridpositions counts {counts}\norigin {first[0]} {first[1]} {first[2]}\n"
                   f"delta {step} 0 0\ndelta 0 {step} 0\ndelta 0 0 {step}\nobject 2 class gridconnections counts {counts}\n"
                   f"object 3 class array type double rank 0 items {grid.size} data follows\n")
        np.savetxt(file, grid.reshape(-1, 1), fmt="%.5g")


def write_mrc(path, first, step, grid):
    import mrcfile

    with mrcfile.new(path, overwrite=True) as mrc:
        mrc.set_data(np.ascontiguousarray(grid.transpose(2, 1, 0).astype("f4")))
        mrc.voxel_size = step
        mrc.header.origin = tuple(first)


def potential():
    rows = [line.split() for line in open(os.path.join(data, "3pqr.pqr")) if line.startswith(("ATOM", "HETATM"))]
    places = np.array([[float(v) for v in row[-5:-2]] for row in rows])
    charges = np.array([float(row[-2]) for row in rows])
    step, bjerrum, debye = 1.0, 7.13, 7.86  # Å; water at 25 °C with 0.15 mol/l of salt, but a dielectric constant of 20
    scale = bjerrum * 78.5 / 20
    first, size = box(places, step, 8)
    grid = np.zeros(size)
    axes = nodes_of(first, size, step)
    for place, charge in zip(places, charges):
        add_about(grid, axes, place, 20,
                  lambda square: scale * charge * np.exp(-np.sqrt(square) / debye) / np.sqrt(np.maximum(square, 1.5 ** 2)))
    write_dx(os.path.join(folder, "potential.dx"), first, step, grid)


def orbital():
    lines = open(os.path.join(data, "small", "benzene.xyz")).read().splitlines()[2:]
    atoms = [(line.split()[0], np.array([float(v) for v in line.split()[1:4]])) for line in lines if line.split()]
    carbons = np.array([place for name, place in atoms if name == "C"])
    middle = carbons.mean(axis=0)
    normal = np.linalg.svd(carbons - middle)[2][2]
    bonded = (np.linalg.norm(carbons[:, None] - carbons[None], axis=2) < 1.6) - np.eye(len(carbons))
    _, states = np.linalg.eigh(-bonded)  # in units of beta, which is negative
    weights = states[:, len(carbons) // 2 - 1]
    bohr, zeta, step = 0.529177210903, 1.625, 0.15  # Slater's exponent of carbon
    first, size = box(np.array([place for _, place in atoms]), step, 3)
    axes = nodes_of(first, size, step)
    grid = np.zeros(size)
    places = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1)
    for place, weight in zip(carbons, weights):
        off = (places - place) / bohr
        grid += weight * np.sqrt(zeta ** 5 / np.pi) * (off @ normal) * np.exp(-zeta * np.linalg.norm(off, axis=-1))
    with open(os.path.join(folder, "orbital.cube"), "w") as file:
        corner = first / bohr
        file.write(f"benzene\npi orbital\n{-len(atoms)} {corner[0]:.6f} {corner[1]:.6f} {corner[2]:.6f}\n")
        for axis in range(3):
            file.write(f"{size[axis]} " + " ".join(f"{step / bohr * (axis == i):.6f}" for i in range(3)) + "\n")
        for name, place in atoms:
            file.write(f"{6 if name == 'C' else 1} 0 " + " ".join(f"{v / bohr:.6f}" for v in place) + "\n")
        file.write("1 1\n")
        np.savetxt(file, grid.reshape(-1, 1), fmt="%.5e")


def ring():
    with gzip.open(os.path.join(data, "1aon-groel.pdb.gz"), "rt") as file:
        rows = [line for line in file if line.startswith("ATOM") and line[21] in "ABCDEFG"]
    places = np.array([[float(row[i:i + 8]) for i in (30, 38, 46)] for row in rows])
    mobility = np.array([float(row[60:66]) for row in rows])
    step, width = 2.0, 8.0 / (np.pi * np.sqrt(2))  # as ChimeraX's molmap has it
    first, size = box(places, step, 10)
    axes = nodes_of(first, size, step)
    density, weighted = np.zeros(size), np.zeros(size)
    for place, value in zip(places, mobility):
        add_about(density, axes, place, 4 * width, lambda square: np.exp(-square / (2 * width ** 2)))
        add_about(weighted, axes, place, 4 * width, lambda square: value * np.exp(-square / (2 * width ** 2)))
    write_mrc(os.path.join(folder, "groel.mrc"), first, step, density)
    write_mrc(os.path.join(folder, "groel_b.mrc"), first, step, np.where(density > 1e-3, weighted / np.maximum(density, 1e-3), np.nan))


os.makedirs(folder, exist_ok=True)
potential()
orbital()
ring()
