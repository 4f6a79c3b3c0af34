#include "engine/molecule/read_notes.h"

#include <algorithm>
#include <array>
#include <set>

#include "engine/molecule/molecule.h"

namespace nacre {

void addNote(ReadNotes& notes, ReadAction action, std::string_view what, std::string_view why, std::int64_t count,
             std::uint64_t line) {
    if (count == 0) return;
    const auto known = std::ranges::find_if(
        notes, [&](const ReadNote& note) { return note.action == action && note.what == what && note.why == why; });
    if (known == notes.end())
        notes.push_back({action, std::string(what), std::string(why), count, line});
    else
        known->count += count;
}

std::string_view readActionName(ReadAction action) {
    return action == ReadAction::read ? "read" : action == ReadAction::guessed ? "guessed" : "left out";
}

namespace {

/// "radii of grains": "radius of grains"; "periodic boxes": "periodic box".
std::string toSingular(std::string_view plural) {
    struct Ending {
        std::string_view plural, singular;
    };
    static constexpr Ending kEndings[] = {{"ies", "y"}, {"ii", "ius"}, {"xes", "x"}, {"sses", "ss"}, {"s", ""}};
    std::size_t head = plural.size();
    for (const std::string_view after : {" of ", " in ", " and "}) head = std::min(head, plural.find(after));
    for (const Ending& ending : kEndings)
        if (plural.substr(0, head).ends_with(ending.plural))
            return std::string(plural.substr(0, head - ending.plural.size())) + std::string(ending.singular) +
                   std::string(plural.substr(head));
    return std::string(plural);
}

}  // namespace

std::string describeNote(const ReadNote& note) {
    std::string text(readActionName(note.action));
    text += " " + std::to_string(note.count) + " " + (note.count == 1 ? toSingular(note.what) : note.what);
    if (note.line > 0) text += (note.count > 1 ? ", the first on line " : ", line ") + std::to_string(note.line);
    return note.why.empty() ? text : text + ": " + note.why;
}

ReadNotes listReadNotes(const Molecule& molecule, const std::vector<std::uint8_t>& drawnOrders) {
    ReadNotes notes;
    const auto read = [&](std::string_view what, std::size_t count) {
        addNote(notes, ReadAction::read, what, "", static_cast<std::int64_t>(count));
    };
    std::array<std::size_t, 3> bonds{};
    std::int64_t orders = 0;
    for (std::size_t i = 0; i < molecule.bonds.size(); ++i) {
        const Bond& bond = molecule.bonds[i];
        ++bonds[static_cast<std::size_t>(bond.source)];
        orders += i < drawnOrders.size() && (drawnOrders[i] != bond.order || bond.source == BondSource::distance);
    }
    std::set<std::string_view> segments;
    std::size_t folded = 0, charged = 0, alternates = 0, unknown = 0;
    std::int64_t known = 0;
    for (const Residue& residue : molecule.residues) {
        folded += residue.secondary != SecondaryStructure::none;
        if (const std::string_view segment = residue.segment.view(); !segment.empty()) segments.insert(segment);
    }
    for (const Atom& atom : molecule.atoms) {
        charged += atom.charge != 0;
        alternates += atom.alternate != '\0';
        unknown += atom.element == 0 && atom.radius == 0;
        known += atom.element != 0;
    }
    read("atoms", molecule.atoms.size());
    read("residues", molecule.residues.size());
    read("chains", molecule.chains.size());
    read("segments", segments.size());
    read("models", static_cast<std::size_t>(molecule.file.models.value_or(0)));
    read("records", static_cast<std::size_t>(molecule.file.records.value_or(0)));
    read("bonds", bonds[0]);
    read("residues in helices and strands", molecule.statesSecondaryStructure ? folded : 0);
    read("atoms in alternate locations", alternates);
    read("formal charges", charged);
    read("partial charges", molecule.partialCharges.size());
    read("radii", molecule.radii.size());
    read("masses", molecule.masses.size());
    read("anisotropic displacements",
         static_cast<std::size_t>(std::count_if(molecule.displacements.begin(), molecule.displacements.end(),
                                                [](const Displacement& u) { return u.stated(); })));
    read("atom types", molecule.types.size());
    read("unit cells", molecule.file.cell ? 1 : 0);
    read("periodic boxes", molecule.file.box ? 1 : 0);
    read("assemblies", molecule.assemblies.size());
    addNote(notes, ReadAction::guessed, "bonds", "from residue templates", static_cast<std::int64_t>(bonds[1]));
    addNote(notes, ReadAction::guessed, "bonds", "from distances", static_cast<std::int64_t>(bonds[2]));
    addNote(notes, ReadAction::guessed, "bond orders", "from geometry and valences", orders);
    for (const ReadNote& note : molecule.notes) {
        // Atoms that turned out to be grains have no element.
        const bool elements = note.action == ReadAction::guessed && note.what == "elements";
        addNote(notes, note.action, note.what, note.why, elements ? std::min(note.count, known) : note.count,
                note.line);
    }
    addNote(notes, ReadAction::leftOut, "elements", "not known", static_cast<std::int64_t>(unknown));
    std::stable_sort(notes.begin(), notes.end(),
                     [](const ReadNote& a, const ReadNote& b) { return a.action < b.action; });
    return notes;
}

}  // namespace nacre
