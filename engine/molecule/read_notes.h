#pragma once
// How a reader treated the items of a file: how many it read, guessed or omitted, and why. Must also compile as C++17.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace nacre {

/// `unused` items (velocities) are omitted without a warning, since they are never shown.
enum class ReadAction : std::uint8_t { read, guessed, leftOut, unused };

/// Items of one kind with the same treatment.
struct ReadNote {
    ReadAction action = ReadAction::read;
    std::string what;  ///< plural: "atoms"
    std::string why;   ///< "no coordinates", "from atom names"; empty: the file states them
    std::int64_t count = 0;
    std::uint64_t line = 0;  ///< of the first; 0: not known
};
using ReadNotes = std::vector<ReadNote>;

/// Counts items, together with earlier ones of the same action, kind and reason.
void addNote(ReadNotes& notes, ReadAction action, std::string_view what, std::string_view why, std::int64_t count = 1,
             std::uint64_t line = 0);

/// "left out 2 atoms, the first on line 17: no coordinates"
std::string describeNote(const ReadNote& note);

/// "read", "guessed" or "left out"; `unused` is also "left out"
std::string_view readActionName(ReadAction action);

struct Molecule;
/// The whole list in the order read, guessed, left out: the reader's notes and counts of the molecule.
/// @param drawnOrders  of its bonds (drawn_orders.h): differing orders are guesses
ReadNotes listReadNotes(const Molecule& molecule, const std::vector<std::uint8_t>& drawnOrders);

}  // namespace nacre
