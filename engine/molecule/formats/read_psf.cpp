// PSF topologies (CHARMM, NAMD, X-PLOR): atoms with segments, types, charges and masses, and bonds. Fields have fixed
// columns, wider ones with EXT, or are separated by blanks; a blank segment requires columns.
#include <cmath>

#include "engine/molecule/formats/topology.h"
#include "engine/molecule/text.h"

namespace nacre {

namespace {

struct PsfFields {
    std::string_view segment, number, residue, name, type, charge, mass;
};

PsfFields fieldsByColumns(std::string_view line, bool extended) {
    const std::size_t id = extended ? 10 : 8, wide = extended ? 8 : 4;
    std::size_t at = id + 1;
    const auto field = [&](std::size_t width) {
        const std::string_view text = trim(columns(line, at, width));
        at += width + 1;
        return text;
    };
    PsfFields fields;
    fields.segment = field(wide);
    fields.number = field(wide);
    fields.residue = field(wide);
    fields.name = field(wide);
    const Words rest = splitWords(columns(line, at, line.size()));
    fields.type = rest[0];
    fields.charge = rest[1];
    fields.mass = rest[2];
    return fields;
}

class PsfReader {
public:
    PsfReader(const std::string& name, std::string_view text, const ReadOptions& options)
        : name_(name), lines_(text), builder_(name, options.maxAtoms) {}

    Molecule run() {
        if (!lines_.next() || !startsWith(trim(lines_.line()), "PSF")) cannotRead(name_, "it is not a PSF file");
        for (const std::string_view word : splitAllWords(lines_.line())) extended_ = extended_ || word == "EXT";
        while (lines_.next()) {
            const std::string_view line = lines_.line();
            const std::size_t mark = line.find('!');
            if (mark == std::string_view::npos) continue;
            const auto count = parseInteger(line.substr(0, mark));
            if (!count || *count < 0) continue;
            const std::string_view section = line.substr(mark);
            if (startsWith(section, "!NTITLE")) readTitle(*count);
            if (startsWith(section, "!NATOM")) readAtoms(*count);
            if (startsWith(section, "!NBOND")) readBonds(*count);
            if (startsWith(section, "!NTHETA")) builder_.pass("angles", *count);
            if (startsWith(section, "!NPHI")) builder_.pass("dihedrals", *count);
            if (startsWith(section, "!NIMPHI")) builder_.pass("impropers", *count);
        }
        return withoutPositions(builder_, "psf");
    }

private:
    void readTitle(std::int64_t count) {
        for (; count > 0 && lines_.next(); --count) {
            std::string_view text = trim(lines_.line());
            if (startsWith(text, "REMARKS")) text = trim(text.substr(7));
            std::string& title = builder_.molecule().file.title;
            if (title.empty()) title = printable(text, 200);
        }
    }

    void readAtoms(std::int64_t count) {
        for (std::int64_t i = 0; i < count; ++i) {
            if (!lines_.next() || trim(lines_.line()).empty())
                cannotRead(name_, "it ends after " + std::to_string(i) + " of " + std::to_string(count) + " atoms",
                           lines_.number());
            readAtom(lines_.line());
        }
    }

    void readAtom(std::string_view line) {
        const Words words = splitWords(line);
        const auto isNumber = [&](std::size_t i) { return parseNumber(words[i]).has_value(); };
        PsfFields fields{words[1], words[2], words[3], words[4], words[5], words[6], words[7]};
        const bool numbered = !fields.number.empty() && (isDigit(fields.number[0]) || fields.number[0] == '-');
        if (words.count < 8 || !numbered || !isNumber(6) || !isNumber(7)) fields = fieldsByColumns(line, extended_);
        const auto charge = parseNumber(fields.charge), mass = parseNumber(fields.mass);
        if (!charge || !mass || !std::isfinite(*charge) || !std::isfinite(*mass))
            cannotRead(name_, "expected an atom with charge and mass, not '" + printable(line) + "'", lines_.number());
        const TopologyAtom stated{fields.type, *charge, *mass};
        Atom atom;
        atom.name = Name(fields.name);
        atom.element = elementOfTopology(builder_, stated, fields.name, fields.residue);
        const auto [number, insertion] = residueNumber(fields.number);
        builder_.addAtom(atom, fields.segment, number, insertion, fields.residue);
        builder_.molecule().residues.back().segment = Name(fields.segment);
        keepTopology(builder_, stated);
    }

    /// Four pairs per line.
    void readBonds(std::int64_t count) {
        builder_.molecule().file.bonds = count;
        std::int64_t first = -1;
        bool isSecond = false;
        const std::size_t width = extended_ ? 10 : 8;
        while (count > 0 && lines_.next()) {
            std::string_view line = lines_.line();
            std::vector<std::string_view> words = splitAllWords(line);
            // Numbers that fill their columns touch.
            if (words.size() % 2 != 0 || (!words.empty() && words[0].size() > width))
                for (words.clear(); !trim(line).empty(); line.remove_prefix(std::min(width, line.size())))
                    words.push_back(trim(line.substr(0, width)));
            if (words.empty()) break;
            for (const std::string_view word : words) {
                const std::int64_t atom = parseInteger(word).value_or(0) - 1;
                if (isSecond) {
                    builder_.addBond(first, atom, 1, lines_.number());
                    --count;
                }
                first = atom;
                isSecond = !isSecond;
            }
        }
        if (count > 0)
            builder_.warn("it states " + std::to_string(builder_.molecule().file.bonds.value_or(0)) +
                          " bonds, of which " + std::to_string(count) + " are missing");
    }

    const std::string& name_;
    LineReader lines_;
    MoleculeBuilder builder_;
    bool extended_ = false;
};

}  // namespace

Molecule readPsf(const std::string& name, std::string_view text, const ReadOptions& options) {
    requireModel(name, options.model, 1);
    return PsfReader(name, text, options).run();
}

}  // namespace nacre
