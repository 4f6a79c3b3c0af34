#pragma once
// Fields of a PDB line (wwPDB format 3.3, and common deviations).

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "engine/molecule/molecule.h"

namespace nacre::pdb {

/// Columns in the format's counting, 1-based and inclusive, as far as the line goes.
inline std::string_view columns(std::string_view line, std::size_t first, std::size_t last) {
    if (line.size() < first) return {};
    return line.substr(first - 1, last - first + 1);
}

inline char column(std::string_view line, std::size_t number) {
    return line.size() >= number && line[number - 1] != '\0' ? line[number - 1] : ' ';
}

/// Without blanks and NUL at both ends.
std::string_view trim(std::string_view field);

/// A finite decimal number that fills the field except for blanks.
std::optional<double> number(std::string_view field);

/// The coordinates of an atom line, and the number of columns by which they shift all that follows to the right.
struct Coordinates {
    std::array<std::string_view, 3> fields;
    std::size_t shift = 0;
    bool pointed = true;  ///< decimal points determine their places; otherwise the usual columns do
    bool usual = false;   ///< in columns 31 to 54, with three decimals
};

/// By columns 31 to 54, or by decimal points if numbers are wider than their columns, or outside them.
Coordinates coordinates(std::string_view line);

/// An integer, or a hybrid-36 number of exactly `width` characters (R. W. Grosse-Kunstleve: digits first, then A000..
/// in base 36, then a000..). Empty for anything else.
std::optional<std::int64_t> integer(std::string_view field, std::size_t width);

/// Serial number of an atom line, also with six or more digits that extend into the next columns.
std::optional<std::int64_t> serial(std::string_view line);

/// Number of columns by which a long serial number shifts name and residue to the right. @param shift  of the
/// coordinates
std::size_t pushOfSerial(std::string_view line, std::size_t shift);

/// Whether the residue's number is misplaced relative to such coordinates.
bool isOutOfColumns(std::string_view line, const Coordinates& where);
/// The line with its fields moved into their columns, by words; empty if these are not those of an atom.
std::optional<std::string> inColumns(std::string_view line, const Coordinates& where);

/// Element from columns 77-78; 0 if they state none.
Element statedElement(std::string_view line);

/// Element by the four columns of an atom's name (13-16) alone: symbol right-justified in the first two, or marked by a
/// small letter in any columns ("Cl1").
Element elementByName(std::string_view field, const Name& residueName);

/// Element from a name without columns (GRO, PQR), so that "CA" is carbon unless its residue is calcium.
Element elementByLooseName(std::string_view name, const Name& residueName);

/// Element of the only atom of a residue, if names identify an ion, including CHARMM's, AMBER's and GROMACS's names
/// ("SOD", "Na+", "CD2"); else 0.
/// @param stated  the line's own element, which may be only the first letter of the ion's name
Element elementOfIon(const Name& name, const Name& residueName, Element stated);

/// Element of an AutoDock 4 atom type ("A", "HD", "OA", "Cl"), or 0. "NA" accepts a hydrogen bond; sodium is "Na".
Element elementByAutoDockType(std::string_view type);
/// Whether it is the type of a pseudo-atom that only closes a broken ring (Meeko's G0 to G3).
bool isAutoDockGlue(std::string_view type);

/// Segment in columns 73-76; empty in old files, which number their lines there.
std::string_view segment(std::string_view line);

/// Formal charge in columns 79-80 ("2+", "1-", "+2"); 0 if there is none.
std::int8_t charge(std::string_view line);

}  // namespace nacre::pdb
