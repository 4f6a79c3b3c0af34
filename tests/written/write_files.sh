#!/bin/bash
# Usage: write_files.sh WRITE_SAMPLES FOLDER
# Makes FOLDER: the built-in samples as WRITE_SAMPLES writes them (own/), and as Open Babel, gemmi and RDKit write what
# they read of that (obabel/, gemmi/, rdkit/). Each is NAME.FORMAT, with NAME the sample's; _v3000.sdf tells the two
# versions of SDF apart, _core.cif the CIF of small molecules. several/ has all of them in one file.
set -euo pipefail
rm -rf "$2"
mkdir -p "$2"/{own,obabel,gemmi,rdkit,several}
"$1" "$2/own"
cd "$2"
quietly() { "$@" >log 2>&1 || { cat log >&2; exit 1; }; }
for name in dna glucose buckyball; do
    # PDB names atoms and residues, SDF states the orders of bonds.
    for format in pdb mol2 gro pqr cml; do quietly obabel own/$name.pdb -O obabel/$name.$format; done
    # A rigid molecule, in the order and with the names that it has. Of sugar it would leave out hydrogens.
    [[ $name == glucose ]] || quietly obabel own/$name.pdb -O obabel/$name.pdbqt -xrhpn
    quietly obabel -ipdb own/$name.pdb -omcif -O obabel/$name.cif
    quietly obabel -ipdb own/${name}_core.pdb -ocif -O obabel/${name}_core.cif
    quietly obabel own/$name.sdf -O obabel/$name.sdf
    quietly obabel own/$name.sdf -O obabel/${name}_v3000.sdf -x3
    quietly obabel own/$name.xyz -O obabel/$name.xyz
    for format in txyz mae; do quietly obabel own/$name.sdf -O obabel/$name.$format; done
    quietly obabel own/$name.sdf -olmpdat -O obabel/$name.lmp
    quietly gemmi convert own/$name.pdb gemmi/$name.cif
    quietly gemmi convert --to=mmjson own/$name.pdb gemmi/$name.json
    quietly gemmi convert gemmi/$name.cif gemmi/$name.pdb
    rm own/${name}_core.pdb
    gzip --no-name <gemmi/$name.cif >gemmi/$name.cif.gz
done
# All three one after the other, as models, frames or records.
for format in pdb sdf mol2 xyz; do
    quietly obabel own/{dna,glucose,buckyball}.pdb -O several/samples.$format
done
# Debian's Python, which has Debian's RDKit, whatever else there is.
quietly /usr/bin/python3 - <<'END'
from rdkit import Chem
for name in ("dna", "glucose", "buckyball"):
    molecule = Chem.MolFromMolFile(f"own/{name}.sdf", sanitize=False, removeHs=False)
    with open(f"rdkit/{name}_v3000.sdf", "w") as file:
        file.write(Chem.MolToV3KMolBlock(molecule, kekulize=False))
    with open(f"rdkit/{name}.sdf", "w") as file:
        file.write(Chem.MolToMolBlock(molecule, kekulize=False))
    with open(f"rdkit/{name}.xyz", "w") as file:
        file.write(Chem.MolToXYZBlock(molecule))
END
rm log
