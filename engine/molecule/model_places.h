#pragma once
// Where the atoms of other models of a file are. Must also compile as C++17.

#include <cstddef>
#include <glm/vec3.hpp>
#include <memory>
#include <vector>

namespace nacre {

struct Molecule;

/// Another model of a molecule's file. other_models.h makes a molecule of it.
struct OtherModel {
    std::vector<glm::vec3> positions;       ///< of the molecule's own atoms, Å, if it has the same; else none
    std::shared_ptr<const Molecule> whole;  ///< if it has other atoms
};

/// Other models, in the file's order. Positions beyond kMostHeld bytes stand in a temporary file and are read as they
/// are needed. Copies share them.
class ModelPlaces {
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

}  // namespace nacre
