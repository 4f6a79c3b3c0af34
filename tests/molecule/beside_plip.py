#!/usr/bin/python3
"""Interactions beside PLIP 2.4: beside_plip.py PROGRAM [--details] [FILE...]

plip (Debian's with the corrections of plip_corrected.py) reads each PDB file (those of interactions/ of the test data if none is named), PROGRAM reads the same text with
--interaction-rules plip, once for each ligand that plip reports. Contacts are the same if their kind and atoms are:
of charged groups and rings, if they share atoms on both sides. Fails if, summed over the files, fewer than 95 % of the
contacts of plip are found, or fewer than 95 % of ours are plip's, for any kind.
"""

import argparse
import collections
import gzip
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "support"))
import test_data  # noqa: E402

LEAST_SHARE = 0.95
CORRECTED = pathlib.Path(__file__).parent / "plip_corrected.py"
KINDS = {
    "hydrophobic_interaction": "hydrophobic",
    "hydrogen_bond": "hydrogen-bond",
    "water_bridge": "water-bridge",
    "salt_bridge": "salt-bridge",
    "pi_stack": "pi-stacking",
    "pi_cation_interaction": "cation-pi",
    "halogen_bond": "halogen-bond",
    "metal_complex": "metal",
}


def text_of(path):
    return (gzip.open(path, "rt") if path.suffix == ".gz" else open(path)).read()


def ids_of(text):
    """plip's number of an atom -> its position among the atoms of the first model: it counts TER lines, too."""
    ids, number, position, after_ter = {}, 0, 0, False
    for line in text.splitlines():
        if line.startswith(("ATOM", "HETATM")):
            position += 1
            number += 2 if after_ter else 1
            after_ter = False
            ids[number] = position
        elif line.startswith("TER"):
            after_ter = True
        elif line.startswith("ENDMDL"):
            break
    return ids


def numbers(element, tag):
    return frozenset(int(idx.text) for idx in element.find(tag))


def contact_of_plip(kind, element, ids):
    """The atoms of both sides (ligand, receptor), and of the water."""
    one = lambda tag: frozenset([ids[int(element.findtext(tag))]])
    several = lambda tag: frozenset(ids[number] for number in numbers(element, tag))
    if kind == "hydrophobic":
        return one("ligcarbonidx"), one("protcarbonidx"), frozenset()
    if kind == "hydrogen-bond":
        return one("donoridx"), one("acceptoridx"), frozenset()
    if kind == "water-bridge":
        return one("donor_idx"), one("acceptor_idx"), one("water_idx")
    if kind == "halogen-bond":
        return one("don_idx"), one("acc_idx"), frozenset()
    if kind == "metal":
        return one("metal_idx"), one("target_idx"), frozenset()
    return several("lig_idx_list"), several("prot_idx_list"), frozenset()


def contacts_of_plip(report, ids):
    """By ligand, as a tuple of its members: (kind, sides)."""
    ligands = {}
    for site in xml.etree.ElementTree.parse(report).getroot().iter("bindingsite"):
        members = tuple(member.text for member in site.find("identifiers/members"))
        found = ligands.setdefault(members, [])
        for tag, kind in KINDS.items():
            found += [(kind, contact_of_plip(kind, element, ids)) for element in site.iter(tag)]
    return ligands


def contacts_of_program(program, path, members):
    terms = []
    for member in members:
        name, chain, number = member.split(":")
        chain = "Z+''" if chain == "Z" else f"'{chain}'"  # plip's name for a blank one
        terms.append(f"(chain {chain} and resi {number} and resn {name})")
    run = subprocess.run([program, "info", path, "--interactions", " or ".join(terms), "--interaction-rules", "plip",
                          "--json", "-q"], check=True, capture_output=True, text=True)
    found = []
    for contact in json.loads(run.stdout)[0]["interactions"]:
        a, b = contact["a"]["ids"], contact["b"]["ids"]
        if contact["kind"] in ("hydrogen-bond", "water-bridge", "halogen-bond"):
            a, b = (a, b) if contact["donor"] == "a" else (b, a)
            a, b = a[:1], b[:1]
        waters = frozenset(identifier for water in contact.get("waters", []) for identifier in water["ids"])
        found.append((contact["kind"], (frozenset(a), frozenset(b), waters)))
    return found


def same(one, other):
    (kind, (a, b, water)), (kind_of_other, (c, d, water_of_other)) = one, other
    if kind != kind_of_other or water != water_of_other:
        return False
    straight = bool(a & c) and bool(b & d)
    # plip tells two hydroxyl groups that may both donate twice.
    return straight or (kind in ("hydrogen-bond", "hydrophobic", "metal", "salt-bridge", "pi-stacking", "cation-pi") and
                        bool(a & d) and bool(b & c))


def compare(name, theirs, ours, counts, details):
    for contact in theirs:
        hit = any(same(contact, other) for other in ours)
        counts[contact[0]]["plip"] += 1
        counts[contact[0]]["found"] += hit
        if details and not hit:
            print(f"{name}: missed", contact[0], *[sorted(side) for side in contact[1]])
    for contact in ours:
        hit = any(same(contact, other) for other in theirs)
        counts[contact[0]]["ours"] += 1
        counts[contact[0]]["confirmed"] += hit
        if details and not hit:
            print(f"{name}: unconfirmed", contact[0], *[sorted(side) for side in contact[1]])


def report_of(path, text, folder):
    plain = folder / path.name.removesuffix(".gz")
    plain.write_text(text)
    subprocess.run([sys.executable, "-B", CORRECTED, "-f", plain, "-x", "-o", folder], check=True, capture_output=True)
    return plain, folder / "report.xml"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("files", nargs="*", type=pathlib.Path)
    parser.add_argument("--details", action="store_true", help="print each contact that differs")
    parser.add_argument("--reports", type=pathlib.Path, help="folder that keeps plip's reports for the next run")
    options = parser.parse_args()
    files = options.files or sorted(test_data.needed_folder().glob("interactions/*.pdb.gz"))
    if not shutil.which("plipcmd"):
        test_data.cannot_judge("plip is not installed")
    counts = collections.defaultdict(collections.Counter)
    for path in files:
        text = text_of(path)
        with tempfile.TemporaryDirectory() as temporary:
            folder = (options.reports or pathlib.Path(temporary)) / path.name.split(".")[0]
            folder.mkdir(parents=True, exist_ok=True)
            plain, report = folder / path.name.removesuffix(".gz"), folder / "report.xml"
            if not report.exists():
                plain, report = report_of(path, text, folder)
            for members, theirs in contacts_of_plip(report, ids_of(text)).items():
                compare(path.name, theirs, contacts_of_program(options.program, plain, members), counts,
                        options.details)
    bad = False
    print(f"{'kind':15} {'plip':>5} {'found':>6} {'ours':>5} {'confirmed':>9}")
    for kind, count in sorted(counts.items()):
        print(f"{kind:15} {count['plip']:5} {count['found']:6} {count['ours']:5} {count['confirmed']:9}")
        bad |= count["found"] < LEAST_SHARE * count["plip"] or count["confirmed"] < LEAST_SHARE * count["ours"]
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
