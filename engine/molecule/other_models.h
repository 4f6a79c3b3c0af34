#pragma once
// The other models of a molecule's file, as far as a camera that all of them share wants them. Must also compile as
// C++17.

#include <cstddef>
#include <glm/vec3.hpp>
#include <memory>
#include <vector>

namespace nacre {

struct Molecule;

/// Another model of a molecule's file. place() makes a molecule of it.
struct OtherModel {
    std::vector<glm::vec3> positions;       ///< of the molecule's own atoms, Å, if it has the same; else none
    std::shared_ptr<const Molecule> whole;  ///< if it has other atoms
};

/// Other models, in the file's order. Positions beyond kMostHeld bytes stand in a temporary file and are read as they
/// are needed. Copies share them.
class OtherModels {
public:
    static constexpr std::size_t kMostHeld = std::size_t{16} << 20;

    std::size_t size() const;
    bool empty() const { return size() == 0; }
    /// @throws Error if the temporary file cannot be read
    OtherModel operator[](std::size_t i) const;
    /// Whether all are positions of so many atoms.
    bool allMove(std::size_t atoms) const;

    /// @param mostHeld  bytes of positions that are held @returns the bytes that it takes in memory
    std::size_t add(OtherModel other, std::size_t mostHeld = kMostHeld);
    void clear() { store_.reset(); }

private:
    struct Store;
    std::shared_ptr<Store> store_;
};

/// Gathers them. Of models that have the molecule's own atoms the positions alone are kept, of others all but their
/// bonds.
class OtherModelCollector {
public:
    /// @param own       gets them
    /// @param maxAtoms  of the molecule; the others together take no more than a part of what that many take
    OtherModelCollector(Molecule& own, std::size_t maxAtoms);
    /// Whether any more are wanted.
    bool wanted() const { return wanted_; }
    void add(Molecule model);

private:
    Molecule& own_;
    std::size_t mostBytes_, bytes_ = 0;
    bool wanted_ = true;
};

/// Makes `placed` what another model of a molecule's file is; without bonds.
void place(const Molecule& molecule, const OtherModel& other, Molecule& placed);

}  // namespace nacre
