#pragma once
// A file of several models that is kept at hand: each is read as it is needed.

#include <memory>
#include <string>

#include "engine/molecule/molecule.h"
#include "engine/molecule/read.h"

namespace nacre {

/// Text (PDB, mmCIF, PDBQT, PQR, SDF, MOL2, XYZ, GRO) is scanned once for where its models are, and of each its own
/// part is read: from the file, from a temporary one if that is compressed, or from memory while it is short. Models of
/// BinaryCIF, mmJSON and MMTF stand in common tables: the packed file is held, and as many models as ModelReader reads
/// in one pass. Of what cannot be told apart all are held, if it is short.
class ModelFile {
public:
    /// @param options  `model` and `others` do not matter @throws Error
    ModelFile(const std::string& path, const ReadOptions& options);
    /// @param bytes  as they are in a file
    ModelFile(const std::string& name, std::string bytes, const ReadOptions& options);
    ~ModelFile();
    ModelFile(const ModelFile&) = delete;
    ModelFile& operator=(const ModelFile&) = delete;

    int count() const;  ///< models, frames or records
    /// The first model, with the places of the others.
    const Molecule& first() const;
    /// With all its bonds, as readMolecule() has it, less the others' places. @param model  from 1 @throws Error
    Molecule read(int model);

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace nacre
