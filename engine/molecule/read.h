#pragma once
// Reads molecules from files. One reader per format; callers need this header only. Must also compile as C++17.

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/molecule/molecule.h"

namespace nacre {

enum class Format {
    pdb,
    mmcif,
    mmjson,
    bcif,
    mmtf,
    sdf,
    xyz,
    mol2,
    pqr,
    gro,
    pdbqt,
    cml,
    psf,
    prmtop,
    top,
    inpcrd,
    lammps,
    lammpstrj,
    gsd,
    poscar,
    xsf,
    tinker,
    mae,
    h5md
};

/// Larger molecules are always refused: an atom may take as little as six bytes of text.
constexpr std::size_t kMaxAtoms = 50'000'000;

/// For ReadOptions: all models, superimposed.
constexpr int kAllModels = 0;

struct ReadOptions {
    std::optional<Format> format = {};            ///< empty: detected, from the content first, the name second
    int model = 1;                                ///< 1-based model, frame or record, or kAllModels
    std::size_t maxBytes = std::size_t{1} << 31;  ///< largest text accepted, after inflation
    std::size_t maxAtoms = kMaxAtoms;             ///< of the model that is read; reading stops at one more
    std::size_t heldText = std::size_t{32}
                           << 20;              ///< largest file held whole; models of larger files are read one by one
    bool uploaded = false;                     ///< HDF5 is refused: damaged files can crash its library
    bool others = false;                       ///< also read the positions of the file's other models: Molecule::others
    std::function<void(double)> onModel = {};  ///< for kAllModels: called after each model with the share read, 0..1
};

/// Format of a name for `--format`, one of formatNames(); empty if unknown.
std::optional<Format> formatFromName(std::string_view name);

std::string_view formatName(Format format);
/// The format of a file name's extension, compressed or not.
std::optional<Format> formatOfFileName(const std::string& name);

/// The names of all formats: "pdb", "mmcif", ...
std::vector<std::string> allFormatNames();
/// As text for messages: "pdb, mmcif, ...".
std::string formatNames();
/// As text with usual spelling: "PDB, mmCIF, ...".
std::string formatTitles();

/// Reads a molecule and completes its bonds (bonds.h). gzip, xz, bzip2 and zstd are recognised by
/// content and inflated under maxBytes.
/// @param name  file name for messages and as a hint to the format
/// @throws Error what, where (line), why
Molecule readMolecule(const std::string& name, std::string bytes, const ReadOptions& options = {});

/// As above from a file, or from standard input if the path is "-".
Molecule readMoleculeFile(const std::string& path, const ReadOptions& options = {});

/// Built-in molecules: "dna", "glucose", "buckyball", with bonds. @throws Error for any other name
Molecule sampleMolecule(std::string_view name);
std::vector<std::string> sampleNames();

}  // namespace nacre
