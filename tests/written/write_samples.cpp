// Writes the built-in samples as files: `write_samples FOLDER` writes NAME.pdb, .sdf, .xyz, .bcif and .mmtf for each of
// them. What other programs make of the text ones becomes the files of all other formats: see write_files.sh.

#include <cstdio>
#include <exception>
#include <fstream>
#include <iostream>
#include <stdexcept>

#include "engine/molecule/element.h"
#include "engine/molecule/read.h"
#include "tests/molecule/bcif_writer.h"
#include "tests/support/written_files.h"
#include "tests/written/mmtf_of.h"

namespace nacre::test {
namespace {

template <typename... Values>
std::string line(const char* format, Values... values) {
    char text[128];
    std::snprintf(text, sizeof text, format, values...);
    return text;
}

std::string atomSymbol(const Atom& atom) { return std::string(elementSymbol(atom.element)); }

/// ATOM and HETATM, and CONECT where residues are not a template's.
std::string writePdb(const Molecule& molecule) {
    std::string text;
    for (std::size_t i = 0; i < molecule.atoms.size(); ++i) {
        const Atom& atom = molecule.atoms[i];
        const Residue& residue = molecule.residues[atom.residue];
        const std::string name(atom.name.view());
        const std::string padded = name.size() < 4 ? " " + name : name;
        text += line("%-6s%5d %-4s %3s %c%4d    %8.3f%8.3f%8.3f%6.2f%6.2f          %2s\n",
                     atom.hetero ? "HETATM" : "ATOM", static_cast<int>(i + 1), padded.c_str(),
                     std::string(residue.name.view()).c_str(), molecule.chains[residue.chain].name[0], residue.number,
                     atom.position.x, atom.position.y, atom.position.z, 1.0, 0.0, atomSymbol(atom).c_str());
    }
    for (const Bond& bond : molecule.bonds)
        if (bond.source == BondSource::file) text += line("CONECT%5u%5u\n", bond.a + 1, bond.b + 1);
    return text + "END\n";
}

std::string writeSdf(const Molecule& molecule) {
    std::string text =
        molecule.file.title + "\n\n\n" +
        line("%3zu%3zu  0  0  0  0  0  0  0  0999 V2000\n", molecule.atoms.size(), molecule.bonds.size());
    for (const Atom& atom : molecule.atoms)
        text += line("%10.4f%10.4f%10.4f %-3s 0  0  0  0  0  0\n", atom.position.x, atom.position.y, atom.position.z,
                     atomSymbol(atom).c_str());
    for (const Bond& bond : molecule.bonds) text += line("%3u%3u%3d  0\n", bond.a + 1, bond.b + 1, bond.order);
    return text + "M  END\n$$$$\n";
}

std::string writeXyz(const Molecule& molecule) {
    std::string text = line("%zu\n", molecule.atoms.size()) + molecule.file.title + "\n";
    for (const Atom& atom : molecule.atoms)
        text +=
            line("%s %.6f %.6f %.6f\n", atomSymbol(atom).c_str(), atom.position.x, atom.position.y, atom.position.z);
    return text;
}

/// In the middle of a cell, for the format that writes coordinates as fractions of one.
std::string writePdbInCell(Molecule molecule) {
    for (Atom& atom : molecule.atoms) atom.position += kMiddleOfCell;
    return "CRYST1  100.000  100.000  100.000  90.00  90.00  90.00 P 1           1\n" + writePdb(molecule);
}

void write(const std::string& path, const std::string& bytes) {
    std::ofstream file(path, std::ios::binary);
    if (!file.write(bytes.data(), static_cast<std::streamsize>(bytes.size())).flush())
        throw std::runtime_error("cannot write " + path);
}

void writeAll(const std::string& folder) {
    for (const std::string name : {"dna", "glucose", "buckyball"}) {
        Molecule molecule = sampleMolecule(name);
        for (const Chain& chain : molecule.chains) molecule.subchains.push_back(chain.name);
        for (Residue& residue : molecule.residues) residue.subchain = residue.chain;
        const std::string path = folder + "/" + name;
        write(path + ".pdb", writePdb(molecule));
        write(path + "_core.pdb", writePdbInCell(molecule));
        write(path + ".sdf", writeSdf(molecule));
        write(path + ".xyz", writeXyz(molecule));
        write(path + ".bcif", writeBcif(molecule));
        write(path + ".mmtf", writeMmtf(molecule));
    }
}

}  // namespace
}  // namespace nacre::test

int main(int argc, char** argv) {
    try {
        if (argc != 2) throw std::runtime_error("usage: write_samples FOLDER");
        nacre::test::writeAll(argv[1]);
        return 0;
    } catch (const std::exception& error) {
        std::cerr << error.what() << "\n";
        return 1;
    }
}
