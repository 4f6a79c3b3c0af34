#pragma once
// Builds a Molecule while a reader parses its file. Must also compile as C++17.

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/molecule/molecule.h"
#include "engine/molecule/read.h"

namespace nacre {

class MoleculeBuilder {
public:
    /// @param name file name for messages
    MoleculeBuilder(std::string name, std::size_t maxAtoms) : name_(std::move(name)), maxAtoms_(maxAtoms) {}

    /// Adds an atom to the previous atom's residue, or begins a new residue if any of these differ.
    /// @param subchain null: the chain
    /// @throws Error if there are more than maxAtoms, or the chain's name is too long
    void addAtom(Atom atom, std::string_view chain, std::int32_t number, char insertionCode, std::string_view residue,
                 std::string_view subchain = {});

    /// Index of a subchain by name, if it has atoms.
    std::optional<std::uint32_t> subchain(std::string_view name) const;

    /// Adds a bond from the file; ignores repeated pairs, and leaves out those with missing atoms.
    /// @throws Error, with the line, if there are more bonds than maxAtoms could form
    /// @param a, b 0-based
    /// @param line  0: none
    void addBond(std::int64_t a, std::int64_t b, int order, std::uint64_t line);

    /// Element of a symbol in a file: "C", "fe", "T", "Fe3+", "C12", "26". Unknown symbols are counted for a warning.
    /// @param line 0: none
    Element element(std::string_view symbol, std::uint64_t line);

    /// Adds an atom of a format without residues.
    void addAtom(const Atom& atom) { addAtom(atom, "", 1, '\0', ""); }

    void warn(const std::string& sentence);

    /// Counts items that are never shown ("velocities"), or stated items that the molecule does not store.
    void pass(std::string_view what, std::int64_t count = 1) {
        addNote(molecule_.notes, ReadAction::unused, what, "not used", count);
    }
    void state(std::string_view what, std::int64_t count = 1) {
        addNote(molecule_.notes, ReadAction::read, what, "", count);
    }
    /// Warns if a header announces another number of items than the file has. @param what  plural @param line  of the
    /// header
    void compareCount(const char* what, std::int64_t announced, std::int64_t found, std::uint64_t line);
    /// Counts items that are left out, or guessed. @param what  plural @param why  without text from the file
    void leaveOut(std::string_view what, std::string_view why, std::uint64_t line = 0) {
        addNote(molecule_.notes, ReadAction::leftOut, what, why, 1, line);
    }
    void guess(std::string_view what, std::string_view how, std::int64_t count = 1) {
        addNote(molecule_.notes, ReadAction::guessed, what, how, count);
    }
    /// A coordinate in Å; empty if it is unusable: then leave the atom out.
    /// @param axis  'x', 'y' or 'z', for the message @param line  0: none @param scale  Å per unit of the file
    std::optional<float> coordinate(std::string_view text, char axis, std::uint64_t line, double scale = 1);
    /// All three coordinates, or a position computed from such numbers.
    std::optional<glm::vec3> position(const std::array<std::string_view, 3>& axes, std::uint64_t line,
                                      double scale = 1);
    std::optional<glm::vec3> computedPosition(const glm::dvec3& position, std::uint64_t line);
    /// Vectors of a periodic box; left out if they have no volume. @param origin  its corner, Å @param line  0: none
    void takeBox(const std::array<glm::vec3, 3>& box, const glm::vec3& origin = {}, std::uint64_t line = 0);
    /// As above for a crystal's cell; the assembly "3x3x3" shows neighbouring cells. @param repeats  along each vector
    void takeCell(const std::array<glm::vec3, 3>& cell, std::uint64_t line = 0,
                  const std::array<bool, 3>& repeats = {true, true, true}) {
        takeBox(cell, {}, line);
        molecule_.file.boxRepeats = repeats;
        repeats_ = repeats[0] || repeats[1] || repeats[2];
    }
    /// Leaves out an atom without usable coordinates. @param why  for the error if most atoms are left out
    void leaveOutAtom(const std::string& why, std::uint64_t line);
    /// Index of the atom of a record, for readers that add or leave out one atom per record; -1 if it was left out, or
    /// does not exist. @param record  from 0
    std::int64_t atomOfRecord(std::int64_t record) const;

    static constexpr std::size_t kMostBondsPerAtom = 8;
    /// Maximum of bonds that a reader may keep until it knows all atoms.
    std::size_t mostBonds() const { return kMostBondsPerAtom * maxAtoms_; }

    std::size_t maxAtoms() const { return maxAtoms_; }
    Molecule& molecule() { return molecule_; }
    const std::string& name() const { return name_; }

    /// The molecule, bonds sorted. @throws Error if it has no atoms
    Molecule finish();

private:
    using Indices = std::map<std::string, std::uint32_t, std::less<>>;  // no hash: a file could choose names that
                                                                        // collide
    std::uint32_t chainIndex(std::string_view chain);
    std::uint32_t subchainIndex(std::string_view subchain);

    std::string name_;
    std::size_t maxAtoms_;
    Molecule molecule_;
    Indices chains_, subchains_;
    std::size_t unknownElements_ = 0, unplaced_ = 0;
    std::string firstUnknown_, firstUnplaced_;
    std::vector<std::uint32_t> leftOutRecords_;  ///< of left-out atoms, ascending
    std::uint64_t lineOfUnplaced_ = 0;
    bool repeats_ = false;
    std::size_t warningsLeftOut_ = 0;
};

/// @param wanted  number of a model, from 1 @param have  number of models in the file @throws Error if it is smaller
void requireModel(const std::string& name, std::int64_t wanted, std::int64_t have);

}  // namespace nacre
