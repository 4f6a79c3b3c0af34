#!/usr/bin/python3
"""Interactions that the literature reports: beside_literature.py PROGRAM [--rules RULES]

interactions/literature.json of the test data names complexes, a ligand, kinds of contact, and residues that must be among
its partners (residues_include) or are all of them (residues_are). Each finding is looked for with the rules of Mol* and
of PLIP, unless one is named. Fails if fewer than 36 are found by PLIP's, whose authors collected them with an earlier
version (2.4 finds 35), or fewer than 35 by Mol*'s: four name hydrogen bonds longer than its 3.5 Å, one takes guanine for
a guanidine, one bridge has two donors.
"""

import argparse
import json
import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "support"))
import test_data  # noqa: E402

LEAST = {"molstar": 35, "plip": 36}
KINDS = {
    "hydrogen bond": "hydrogen-bond",
    "salt bridge": "salt-bridge",
    "pi stacking": "pi-stacking",
    "cation-pi": "cation-pi",
    "halogen bond": "halogen-bond",
    "hydrophobic contact": "hydrophobic",
    "water bridge": "water-bridge",
    "metal": "metal",
}


def partners(program, path, ligand, rules):
    """By kind: the partners' (number, chain, side of the donor)."""
    name, chain, number = ligand.split(":")
    run = subprocess.run([program, "info", path, "--interactions", f"resn '{name}' and chain '{chain}' and resi {number}",
                          "--interaction-rules", rules, "--json", "-q"], check=True, capture_output=True, text=True)
    found = {}
    for contact in json.loads(run.stdout)[0]["interactions"]:
        b = contact["b"]
        found.setdefault(contact["kind"], []).append((b["number"], b["chain"]))
    return found


def kind_of(words):
    return next(kind for start, kind in KINDS.items() if words.startswith(start))


def names(residue, place):
    number, chain = place
    return residue == number or residue == f"{number}{chain}"


def holds(check, found):
    places = [place for words in check["kind"] for place in found.get(kind_of(words), [])]
    wanted = check.get("residues_are", check.get("residues_include"))
    missing = [residue for residue in wanted if not any(names(residue, place) for place in places)]
    extra = [place for place in places if not any(names(residue, place) for residue in wanted)]
    return missing, extra if "residues_are" in check else []


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--rules", choices=["molstar", "plip"])
    options = parser.parse_args()
    folder = test_data.needed_folder() / "interactions"
    bad = 0
    for rules in [options.rules] if options.rules else ["plip", "molstar"]:
        count = good = 0
        for entry in json.load(open(folder / "literature.json")):
            for check in entry["checks"]:
                missing, extra = holds(check, partners(options.program, folder / entry["file"], check["ligand"], rules))
                count += 1
                good += not missing and not extra
                if missing or extra:
                    print(f"{rules}: {entry['file']} {check['ligand']} {check['kind']}: missing {missing}, also {extra}")
        print(f"{rules}: {good} of {count} findings")
        bad += good < LEAST[rules]
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
