#pragma once
// The other models of a molecule's file, with the data that a shared camera needs. Must also compile as C++17.

#include <cstddef>
#include <glm/vec3.hpp>
#include <memory>
#include <vector>

namespace nacre {

struct Molecule;

/// Another model of a molecule's file. place() turns it into a molecule.
struct OtherModel {
    std::vector<glm::vec3> positions;  ///< of the molecule's atoms, Å, if this model has the same ones; else empty
    std::shared_ptr<const Molecule> whole;  ///< if it has different atoms
};

/// Other models, in file order. Positions beyond kMostHeld bytes are in a temporary file and read on demand. Copies
/// share them.
class OtherModels {
public:
    static constexpr std::size_t kMostHeld = std::size_t{16} << 20;

    std::size_t size() const;
    bool empty() const { return size() == 0; }
    /// @throws Error if the temporary file cannot be read
    OtherModel operator[](std::size_t i) const;
    /// Whether all are positions of this many atoms.
    bool allMove(std::size_t atoms) const;

    /// @param mostHeld  bytes of positions in memory @returns the model's bytes in memory
    std::size_t add(OtherModel other, std::size_t mostHeld = kMostHeld);
    void clear() { store_.reset(); }

private:
    struct Store;
    std::shared_ptr<Store> store_;
};

/// Collects other models. Keeps only the positions of models with the molecule's own atoms; of others, everything
/// except bonds.
class OtherModelCollector {
public:
    /// @param own       receives the models
    /// @param maxAtoms  of the molecule; the others together take only a fraction of that
    OtherModelCollector(Molecule& own, std::size_t maxAtoms);
    /// Whether it takes further models.
    bool wanted() const { return wanted_; }
    void add(Molecule model);

private:
    Molecule& own_;
    std::size_t mostBytes_, bytes_ = 0;
    bool wanted_ = true;
};

/// Turns `placed` into another model of a molecule's file; without bonds.
void place(const Molecule& molecule, const OtherModel& other, Molecule& placed);

}  // namespace nacre
