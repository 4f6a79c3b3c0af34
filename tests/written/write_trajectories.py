#!/usr/bin/python3
"""Writes trajectories by MDTraj, and what MDTraj reads in them and makes of them: write_trajectories.py FOLDER.

The molecules are three pentane-like chains in a box, of which frames 1 to 4 shake and turn; every atom lies in the box.
X.bin holds float32 little-endian: per frame the box (9 numbers) and the positions, in Angstrom.
"""
import sys

import h5py
import mdtraj
import numpy

folder = sys.argv[1]
random = numpy.random.default_rng(7)
topology = mdtraj.Topology()
first = []
for chain in range(3):
    residue = topology.add_residue("LIG", topology.add_chain())
    before = None
    for i in range(20):
        atom = topology.add_atom("C%d" % (i + 1), mdtraj.element.carbon, residue)
        if before:
            topology.add_bond(before, atom)
        before = atom
        first.append([1.4 * chain + 0.12 * (i % 2), 0.1 * i, 0.9 * chain + 0.05 * (i % 3)])
first = numpy.array(first)
whole = []
for frame in range(5):
    angle = 0.3 * frame
    turn = numpy.array([[numpy.cos(angle), -numpy.sin(angle), 0], [numpy.sin(angle), numpy.cos(angle), 0], [0, 0, 1]])
    whole.append(first @ turn.T + [0.2 * frame, 0.1, 0.3 * frame] + 0.005 * frame * random.standard_normal(first.shape))
whole = numpy.array(whole, dtype=numpy.float32)
lengths = numpy.tile([[4.0, 4.5, 5.0]], (5, 1))
angles = numpy.tile([[90.0, 90.0, 70.0]], (5, 1))
trajectory = mdtraj.Trajectory(whole, topology, time=10 + 2.5 * numpy.arange(5), unitcell_lengths=lengths, unitcell_angles=angles)


def dump(name, t):
    vectors = numpy.zeros((t.n_frames, 9)) if t.unitcell_vectors is None else t.unitcell_vectors.reshape(-1, 9)
    values = numpy.concatenate([vectors, t.xyz.reshape(t.n_frames, -1)], axis=1) * 10
    values.astype("<f4").tofile("%s/%s.bin" % (folder, name))


for name in ("xtc", "trr", "dcd", "nc"):
    trajectory.save("%s/t.%s" % (folder, name))
    dump(name, mdtraj.load("%s/t.%s" % (folder, name), top=topology))
# AMBER's restart file: the first frame alone.
trajectory[:1].save(folder + "/t.ncrst")
# HDF5: MDTraj's own, and H5MD with its units and box.
trajectory.save(folder + "/t.h5")
dump("h5", mdtraj.load(folder + "/t.h5"))
with h5py.File(folder + "/t.h5md", "w") as h5:
    group = h5.create_group("particles/all")
    positions = group.create_dataset("position/value", data=whole, chunks=(2, 30, 3), compression="gzip")
    positions.attrs["unit"] = "nm"
    group["position/time"] = trajectory.time
    edges = group.create_dataset("box/edges/value", data=trajectory.unitcell_vectors)
    edges.attrs["unit"] = "nm"
# H5MD that states what its particles are, in two frames; the second has other charges.
with h5py.File(folder + "/water.h5md", "w") as h5:
    group = h5.create_group("particles/water")
    place = numpy.array([[[0, 0, 0], [0.96, 0, 0], [-0.24, 0.93, 0]]])
    group["position/value"] = numpy.concatenate([place, place + 1])
    kinds = h5py.enum_dtype({"H": 1, "O": 8}, basetype="i")
    group.create_dataset("species", data=[8, 1, 1], dtype=kinds)
    group["mass"] = [15.999, 1.008, 1.008]
    group["charge/value"] = [[-0.8, 0.4, 0.4], [-0.6, 0.3, 0.3]]
    group["velocity/value"] = numpy.ones((2, 3, 3))
    group["box/edges"] = [20.0, 21.0, 22.0]
    group["box"].attrs["boundary"] = numpy.array(["periodic", "periodic", "none"], dtype="S8")
    h5["connectivity/bonds"] = [[0, 1], [0, 2], [0, 9]]
# Beads of numbered species, and labels as the NOMAD schema has them.
with h5py.File(folder + "/beads.h5md", "w") as h5:
    h5["particles/all/position/value"] = [[[0.0, 0, 0], [1, 0, 0], [2, 0, 0]]]
    h5["particles/all/species"] = [1, 2, 1]
    h5["particles/all/box/edges"] = [9.0, 9.0, 9.0]
    h5["particles/all/box"].attrs["boundary"] = "none"
with h5py.File(folder + "/numbers.h5md", "w") as h5:
    h5["particles/all/position/value"] = [[[0.0, 0, 0], [1.2, 0, 0]]]
    h5["particles/all/species"] = [6, 8]
# Sizes without data behind them.
for name, shape in (("atoms", (1, 1 << 40, 3)), ("frames", (1 << 40, 3, 3))):
    with h5py.File("%s/many_%s.h5md" % (folder, name), "w") as h5:
        h5.create_dataset("particles/all/position/value", shape=shape, chunks=(1, 3, 3), dtype="f4")
with h5py.File(folder + "/labels.h5md", "w") as h5:
    h5["particles/all/position/value"] = [[[0.0, 0, 0], [1.2, 0, 0]]]
    h5["particles/all/species_label"] = ["C", "O"]
# Positions within the head of their dataset.
with h5py.File(folder + "/compact.h5md", "w") as h5:
    layout = h5py.h5p.create(h5py.h5p.DATASET_CREATE)
    layout.set_layout(h5py.h5d.COMPACT)
    group = h5.create_group("particles/all/position")
    places = h5py.h5d.create(group.id, b"value", h5py.h5t.NATIVE_DOUBLE, h5py.h5s.create_simple((1, 2, 3)), layout)
    places.write(h5py.h5s.ALL, h5py.h5s.ALL, numpy.array([[[0.0, 0, 0], [1.2, 0, 0]]]))
    h5["particles/all/species"] = [6, 8]
# Few atoms, which XTC does not compress; and many, as waters are, which it compresses well.
few = trajectory.atom_slice(range(7))
few.save(folder + "/few.xtc")
dump("few", mdtraj.load(folder + "/few.xtc", top=few.topology))
water = mdtraj.Topology()
places = []
for i in range(4000):
    residue = water.add_residue("HOH", water.add_chain())
    corner = numpy.array([i % 16, i // 16 % 16, i // 256]) * 0.31
    for name, element, shift in (("O", "oxygen", (0, 0, 0)), ("H1", "hydrogen", (0.0957, 0, 0)), ("H2", "hydrogen", (-0.024, 0.0927, 0))):
        water.add_atom(name, getattr(mdtraj.element, element), residue)
        places.append(corner + shift)
places = numpy.array(places, dtype=numpy.float32)
waters = mdtraj.Trajectory(numpy.stack([places, places + 0.01 * random.standard_normal(places.shape), -1000 * places]), water)
waters.save(folder + "/water.xtc")
dump("water", mdtraj.load(folder + "/water.xtc", top=water))
# Superposed on the first by the first 20 atoms.
laid = mdtraj.Trajectory(whole.copy(), topology).superpose(mdtraj.Trajectory(whole.copy(), topology), 0, range(20))
dump("laid", laid)
far = numpy.square(laid.xyz[:, :20].astype(float) - whole[0, :20]).sum(axis=2)
numpy.sqrt(far.mean(axis=1)).astype("<f4").tofile(folder + "/rmsd.bin")
# Atom by atom in the box, so that bonds go across its faces.
vectors = trajectory.unitcell_vectors
shares = numpy.einsum("fai,fij->faj", whole, numpy.linalg.inv(vectors))
cut = mdtraj.Trajectory(numpy.einsum("fai,fij->faj", shares - numpy.floor(shares), vectors).astype(numpy.float32), topology,
                        unitcell_lengths=lengths, unitcell_angles=angles)
cut.save(folder + "/cut.trr")
with open(folder + "/t.xyz", "w") as xyz:
    xyz.write("60\n\n" + "".join("C %.4f %.4f %.4f\n" % tuple(10 * p) for p in whole[0]))
