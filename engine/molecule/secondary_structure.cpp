#include "engine/molecule/secondary_structure.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "engine/molecule/formats/pdb_fields.h"
#include "engine/molecule/text.h"

namespace nacre {
namespace {

using Place = std::tuple<std::uint32_t, std::int32_t, char>;  // chain, number, insertion code

constexpr std::int64_t kNowhere = -1;

/// Index of the first residue at a position at or after `from`.
std::int64_t firstAt(const std::map<Place, std::vector<std::int64_t>>& places, const Place& place, std::int64_t from) {
    const auto found = places.find(place);
    if (found == places.end()) return kNowhere;
    const auto position = std::lower_bound(found->second.begin(), found->second.end(), from);
    return position == found->second.end() ? kNowhere : *position;
}

/// Numbers of ranges of one kind that begin (+) or have ended (-) at each residue, in the order of `order`.
using Steps = std::vector<std::int32_t>;

}  // namespace

std::optional<SecondaryRange> secondaryOfPdbLine(std::string_view line) {
    const bool helix = startsWith(line, "HELIX "), strand = startsWith(line, "SHEET ");
    if (!helix && !strand) return std::nullopt;
    const auto code = [&](std::size_t at) { return pdb::column(line, at) == ' ' ? '\0' : pdb::column(line, at); };
    const std::size_t begin = helix ? 22 : 23;
    const auto first = pdb::integer(pdb::columns(line, begin, begin + 3), 4);
    const auto last = pdb::integer(pdb::columns(line, 34, 37), 4);
    if (!first || !last) return std::nullopt;
    SecondaryRange range;
    range.kind = helix ? SecondaryStructure::helix : SecondaryStructure::strand;
    const char chain = pdb::column(line, helix ? 20 : 22);
    if (chain != ' ') range.chain = chain;
    range.first = static_cast<std::int32_t>(*first);
    range.last = static_cast<std::int32_t>(*last);
    range.firstCode = code(begin + 4);
    range.lastCode = code(38);
    return range;
}

void applySecondaryStructure(Molecule& molecule, const std::vector<SecondaryRange>& ranges) {
    if (ranges.empty()) return;
    // A chain's residues in a row, including waters and ligands at the end of the file.
    std::vector<std::uint32_t> order(molecule.residues.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return molecule.residues[a].chain < molecule.residues[b].chain;
    });
    std::map<Place, std::vector<std::int64_t>> places;
    for (std::size_t i = 0; i < order.size(); ++i) {
        const Residue& residue = molecule.residues[order[i]];
        places[{residue.chain, residue.number, residue.insertionCode}].push_back(static_cast<std::int64_t>(i));
    }
    std::map<std::string_view, std::uint32_t> chains;
    for (std::uint32_t i = 0; i < molecule.chains.size(); ++i) chains.emplace(molecule.chains[i].name, i);

    Steps helices(order.size() + 1), strands(order.size() + 1);
    for (const SecondaryRange& range : ranges) {
        const auto chain = chains.find(range.chain);
        std::int64_t first = kNowhere, last = kNowhere;
        if (chain != chains.end()) first = firstAt(places, {chain->second, range.first, range.firstCode}, 0);
        if (first != kNowhere) last = firstAt(places, {chain->second, range.last, range.lastCode}, first);
        if (last == kNowhere) {
            addNote(molecule.notes, ReadAction::leftOut, "helix or strand records", "of residues that are not there", 1,
                    range.line);
            continue;
        }
        Steps& steps = range.kind == SecondaryStructure::helix ? helices : strands;
        ++steps[static_cast<std::size_t>(first)];
        --steps[static_cast<std::size_t>(last) + 1];
        molecule.statesSecondaryStructure = true;
    }
    std::int32_t inHelix = 0, inStrand = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
        inHelix += helices[i];
        inStrand += strands[i];
        if (inHelix > 0)
            molecule.residues[order[i]].secondary = SecondaryStructure::helix;
        else if (inStrand > 0)
            molecule.residues[order[i]].secondary = SecondaryStructure::strand;
    }
}

}  // namespace nacre
