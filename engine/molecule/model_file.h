#pragma once
// A file of several models, each read on demand.

#include <memory>
#include <string>

#include "engine/molecule/molecule.h"
#include "engine/molecule/read.h"

namespace nacre {

/// Text formats (PDB, mmCIF, PDBQT, PQR, SDF, MOL2, XYZ, GRO) are scanned once for the positions of models. Each model
/// is then read from its own part of the file, of a temporary file if the input is compressed, or of memory if the text
/// is short. Models of BinaryCIF, mmJSON and MMTF share tables: the packed file is held in memory, with as many models
/// as ModelReader reads in one pass. If models cannot be separated, all are held if the file is short.
class ModelFile {
public:
    /// @param options  `model` and `others` are ignored @throws Error
    ModelFile(const std::string& path, const ReadOptions& options);
    /// @param bytes  contents of the file
    ModelFile(const std::string& name, std::string bytes, const ReadOptions& options);
    ~ModelFile();
    ModelFile(const ModelFile&) = delete;
    ModelFile& operator=(const ModelFile&) = delete;

    int count() const;  ///< models, frames or records
    /// The first model, with the positions of the others.
    const Molecule& first() const;
    /// Has all bonds, as from readMolecule(), but not the others' positions. @param model  from 1 @throws Error
    Molecule read(int model);

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace nacre
