#pragma once
// Reads the header of a PDB file: CRYST1, COMPND, SOURCE, EXPDTA, HETNAM and HETSYN (wwPDB
// format 3.3).

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "engine/molecule/molecule.h"

namespace nacre::pdb {

class Header {
public:
    /// @param number  of the line
    void add(std::string_view line, std::uint64_t number);
    /// Names of chains and components, organism and method; the title, if there is none, from free text in COMPND
    /// (files from before 1996).
    void resolve(Molecule& molecule) const;

private:
    static constexpr std::size_t kMostText = 1 << 20;  ///< bytes of each
    void takeCrystal(std::string_view line, std::uint64_t number);

    std::optional<std::array<double, 6>> cell_;
    std::uint64_t unusableCell_ = 0;  ///< its line; 0: none
    std::string spaceGroup_;
    std::string entry_, compound_, source_, method_;
    std::map<std::string, std::string> names_, synonyms_;  ///< by the component's name
};

}  // namespace nacre::pdb
