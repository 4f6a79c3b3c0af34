"""`nacre` within bounds: memory, time and threads, whatever a file says. bounds_test.py PROGRAM NO_THREADS NO_MEMORY"""
import json
import os
import pathlib
import resource
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import unittest

PROGRAM, NO_THREADS, NO_MEMORY = (sys.argv.pop(1) for _ in range(3))
SANITIZED = "NACRE_SANITIZED" in os.environ


def atoms(count, place, name="CA  ALA", element="C"):
    """PDB lines. @param place  of each by its number"""
    lines = []
    for n in range(count):
        x, y, z = place(n)
        lines.append(f"ATOM  {n % 100000:5}  {name} {'ABCDEFGHIJ'[n // 9999 % 10]}{n % 9999:4}    {x:8.3f}{y:8.3f}{z:8.3f}  1.00  0.00           {element}\n")
    return "".join(lines)


def ccp4(nodes, intervals, group=19):
    """A map of zeros and a one, whose cell is divided as stated."""
    words = [nodes, nodes, nodes, 2, 0, 0, 0, intervals, intervals, intervals]
    header = struct.pack("<10i", *words) + struct.pack("<6f", 50, 50, 50, 90, 90, 90) + struct.pack("<3i", 1, 2, 3)
    header += struct.pack("<3f2i", 0, 1, 0, group, 0)
    header = header.ljust(208, b"\0") + b"MAP " + b"\x44\x44\0\0"
    return header.ljust(1024, b"\0") + struct.pack("<f", 1) + bytes(4 * (nodes**3 - 1))


class BoundsTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix="nacre-bounds-"))
        (cls.folder / "gly.pdb").write_text(atoms(4, lambda n: (n * 1.5, 0, 0)))

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.folder)

    def run_nacre(self, *words, cpu=None, memory=None, input=None, **environment):
        """@param cpu  seconds of its time that it may take @param memory  bytes of address space"""
        def limit():
            if cpu:
                most = cpu * (6 if SANITIZED else 1)
                resource.setrlimit(resource.RLIMIT_CPU, (most, most))
            if memory and not SANITIZED:
                resource.setrlimit(resource.RLIMIT_AS, (memory, memory))
        environment = os.environ | {"TMPDIR": str(self.folder)} | environment
        return subprocess.run([PROGRAM, *words], capture_output=True, text=True, cwd=self.folder, preexec_fn=limit, input=input, env=environment)

    def refused(self, run, words):
        self.assertEqual(run.returncode, 1, (run.returncode, run.stderr[-500:]))
        self.assertEqual(run.stderr.count("\n"), 1, run.stderr[:500])
        self.assertIn(words, run.stderr)

    def test_crowds_are_refused_before_their_pairs_are_looked_at(self):
        (self.folder / "point.pdb").write_text(atoms(20000, lambda n: (0, 0, 0)))
        for style in ("surface", "spacefill"):
            self.refused(self.run_nacre("render", "point.pdb", "--style", style, "--size", "16x16", "-o", "a.png", cpu=15), "over one another")
        # Not in one place, and still neighbours of all others.
        (self.folder / "crowd.pdb").write_text(atoms(20000, lambda n: (n % 30 * .06, n // 30 % 30 * .06, n // 900 * .06)))
        self.refused(self.run_nacre("render", "crowd.pdb", "--style", "surface", "--size", "16x16", "-o", "a.png", cpu=15), "over one another")
        (self.folder / "waters.pdb").write_text(atoms(60000, lambda n: (n % 40 * .05, n // 40 % 40 * .05, n // 1600 * .05), "O   HOH", "O"))
        self.refused(self.run_nacre("render", "waters.pdb", "--water", "show", "--interactions", "all", "--style", "licorice", "--size", "16x16",
                                    "-o", "a.png", cpu=15), "too many")

    def test_surfaces_are_bounded_while_they_are_made(self):
        """The estimate assumes the surface per atom of a protein. Separate atoms have ten times as much."""
        (self.folder / "apart.pdb").write_text(atoms(27000, lambda n: (n % 30 * 6, n // 30 % 30 * 6, n // 900 * 6)))
        self.refused(self.run_nacre("render", "apart.pdb", "--style", "surface", "--surface-resolution", "0.13", "--size", "16x16", "-o", "a.png",
                                    memory=4 << 30, cpu=120), "million triangles, more than the limit")

    def test_maps_are_bounded_by_memory(self):
        """By their headers, before anything is allocated."""
        (self.folder / "forged.ccp4").write_bytes(ccp4(43, 900))
        (self.folder / "vast.ccp4").write_bytes(struct.pack("<3i", *[2**31 - 1] * 3) + ccp4(1, 1)[12:])
        (self.folder / "empty.dx").write_text("object 1 class gridpositions counts 300 300 300\norigin 0 0 0\ndelta 1 0 0\ndelta 0 1 0\ndelta 0 0 1\n"
                                              "object 3 class array type double rank 0 items 27000000 data follows\n1 2 3\n")
        (self.folder / "empty.cube").write_text("a\nb\n0 0 0 0\n300 1 0 0\n300 0 1 0\n300 0 0 1\n1 2 3\n")
        for name, words in (("forged.ccp4", "more than the limit"), ("vast.ccp4", "takes 1000000000000000 MB"), ("empty.dx", "cut short"), ("empty.cube", "cut short")):
            run = self.run_nacre("render", "gly.pdb", "--map", name, "--memory", "512", "--size", "16x16", "-o", "a.png", memory=3 << 30)
            self.refused(run, words)
            self.refused(self.run_nacre("info", name, memory=3 << 30), "cannot be filled" if name == "forged.ccp4" else words)
        (self.folder / "good.ccp4").write_bytes(ccp4(24, 24))
        self.assertEqual(self.run_nacre("render", "gly.pdb", "--map", "good.ccp4", "--memory", "64", "--size", "16x16", "-o", "a.png").returncode, 0)

    @unittest.skipIf(SANITIZED, "no library can be preloaded")
    def test_threads_that_do_not_start(self):
        preload = {"LD_PRELOAD": NO_THREADS}
        jobs = "".join(json.dumps({"input": "gly.pdb", "output": f"j{n}.png", "size": "16x16"}) + "\n" for n in range(6))
        for threads in ("0", "1", "2"):
            environment = preload | {"NACRE_TEST_THREADS": threads}
            run = self.run_nacre("render", "gly.pdb", "--style", "surface", "--size", "32x32", "-o", "a.png", **environment)
            self.assertEqual((run.returncode, run.stderr), (0, ""))
            run = self.run_nacre("batch", "-", "--jobs", "4", "-q", input=jobs, **environment)
            self.assertEqual((run.returncode, run.stdout.count('"done"')), (0, 6), run.stderr)
            for n in range(6):
                (self.folder / f"j{n}.png").unlink()
        self.refused(self.run_nacre("movie", "gly.pdb", "--spin", "y", "--seconds", "0.1", "--size", "16x16", "-o", "a.gif", **environment | {"NACRE_TEST_THREADS": "0"}),
                     "cannot start a thread")
        self.refused(self.run_nacre("serve", "--listen", "0", **environment | {"NACRE_TEST_THREADS": "0"}), "thread")

    @unittest.skipIf(SANITIZED, "no library can be preloaded")
    def test_memory_that_is_refused(self):
        """One line, though nothing can be allocated any more; of a batch, one job."""
        large = ("--size", "4000x4000", "--occlusion", "off")
        preload = {"LD_PRELOAD": NO_MEMORY, "NACRE_TEST_MOST_BYTES": str(16 << 20)}
        self.refused(self.run_nacre("render", "gly.pdb", *large, "-o", "a.png", **preload, NACRE_TEST_NONE_AFTER="1"), "error: out of memory\n")
        (self.folder / "large.pdb").write_text("REMARK\n" * (3 << 20))
        self.refused(self.run_nacre("info", "large.pdb", **preload, NACRE_TEST_NONE_AFTER="1"), "error: out of memory\n")
        self.refused(self.run_nacre("info", "large.pdb", **preload), "large.pdb: not enough memory\n")
        jobs = "".join(json.dumps({"input": "gly.pdb", "output": f"m{n}.png", "size": size, "occlusion": "off"}) + "\n"
                       for n, size in enumerate(("4000x4000", "16x16")))
        run = self.run_nacre("batch", "-", "--jobs", "1", "-q", input=jobs, **preload)
        told = [json.loads(line) for line in run.stdout.splitlines()]
        self.assertEqual([(one["status"], one.get("error")) for one in told], [("failed", "out of memory"), ("done", None)], run.stderr)

    def test_a_long_line_is_one_job(self):
        jobs = ('{"input": "' + "x" * (1 << 20) + '"}\n' + json.dumps({"input": "gly.pdb", "output": "after.png", "size": "16x16"}) + "\n")
        run = self.run_nacre("batch", "-", "-q", input=jobs)
        told = [json.loads(line) for line in run.stdout.splitlines()]
        self.assertEqual(sorted((one["job"], one["status"]) for one in told), [(1, "failed"), (2, "done")], run.stderr)
        self.assertIn("more than 1 MB", [one for one in told if one["job"] == 1][0]["error"])

    def test_errors_quote_no_books(self):
        jobs = json.dumps({"input": "gly.pdb", "output": "a.png", "zoom": "9" * 900000}) + "\n"
        run = self.run_nacre("batch", "-", "-q", input=jobs)
        self.assertEqual(json.loads(run.stdout)["status"], "failed")
        self.assertLess(len(json.loads(run.stdout)["error"]), 3000)
        run = self.run_nacre("render", "gly.pdb", "--zoom", "9" * 100000, "-o", "a.png")
        self.assertEqual(run.returncode, 2)
        self.assertLess(len(run.stderr), 3000)

    def test_a_closed_pipe_leaves_no_file(self):
        place = self.folder / "pipe"
        place.mkdir()
        read, write = os.pipe()
        os.close(read)
        run = subprocess.run([PROGRAM, "render", "sample:glucose", "--size", "64x64", "-o", "-"], stdout=write, stderr=subprocess.PIPE,
                             env=os.environ | {"TMPDIR": str(place)}, preexec_fn=lambda: signal.signal(signal.SIGPIPE, signal.SIG_DFL))
        os.close(write)
        self.assertNotEqual(run.returncode, 0)
        self.assertEqual(list(place.iterdir()), [])

    def test_an_assembly_that_is_too_large_says_so(self):
        loop = "".join(f"{n} 'point symmetry operation' 1 0 0 {n} 0 1 0 0 0 0 1 0\n" for n in range(1, 3001))
        (self.folder / "many.cif").write_text(
            "data_x\nloop_\n_atom_site.group_PDB\n_atom_site.id\n_atom_site.type_symbol\n_atom_site.label_atom_id\n_atom_site.label_comp_id\n"
            "_atom_site.label_asym_id\n_atom_site.label_seq_id\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n"
            "ATOM 1 C CA ALA A 1 0 0 0\n#\n_pdbx_struct_assembly.id 1\n_pdbx_struct_assembly.details x\n#\n"
            "_pdbx_struct_assembly_gen.assembly_id 1\n_pdbx_struct_assembly_gen.oper_expression '(1-3000)(1-3000)'\n"
            "_pdbx_struct_assembly_gen.asym_id_list A\n#\nloop_\n_pdbx_struct_oper_list.id\n_pdbx_struct_oper_list.type\n" +
            "".join(f"_pdbx_struct_oper_list.{key}\n" for key in ("matrix[1][1]", "matrix[1][2]", "matrix[1][3]", "vector[1]", "matrix[2][1]",
                    "matrix[2][2]", "matrix[2][3]", "vector[2]", "matrix[3][1]", "matrix[3][2]", "matrix[3][3]", "vector[3]")) + loop)
        self.refused(self.run_nacre("render", "many.cif", "--assembly", "1", "-o", "a.png"), "is left out: the assemblies have more than")


if __name__ == "__main__":
    unittest.main(verbosity=2)
