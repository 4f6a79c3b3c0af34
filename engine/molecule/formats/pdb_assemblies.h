#pragma once
// REMARK 350 of PDB files: the transforms that build biological assemblies.

#include <string>
#include <string_view>
#include <vector>

#include "engine/molecule/assemblies.h"
#include "engine/molecule/molecule.h"

namespace nacre::pdb {

class Remark350 {
public:
    /// @param maxAtoms  number of atoms that fit into memory
    explicit Remark350(std::size_t maxAtoms) : limits_(maxAtoms) {}

    /// @param line one that begins with "REMARK 350"
    void add(std::string_view line);
    /// Number of BIOMT1 lines, for FileSummary; 0: none.
    std::int64_t operators() const { return operators_; }
    /// Adds the assemblies to a molecule whose subchains are its chains. Unreadable ones are skipped with a warning.
    void resolve(Molecule& molecule);

private:
    struct Part {
        bool named = false;       ///< false: all chains, as "NULL" means in old files
        std::uint32_t first = 0;  ///< operator among those of the file; the others follow
        std::string chains;       ///< one character each
        std::vector<glm::mat4x3> transforms;
    };
    struct Biomolecule {
        std::string id, details, fault;
        std::vector<Part> parts;
    };
    void begin(std::string_view id);
    void addChains(std::string_view list);
    void addRow(std::string_view line);
    Part& part();

    AssemblyLimits limits_;
    std::vector<Biomolecule> biomolecules_;
    TransformRows rows_{};
    int row_ = 0;  ///< rows read of the current transform
    std::int64_t operators_ = 0;
    std::size_t leftOut_ = 0;
};

}  // namespace nacre::pdb
