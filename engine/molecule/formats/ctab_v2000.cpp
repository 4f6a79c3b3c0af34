#include <algorithm>

#include "engine/molecule/formats/ctab.h"

namespace nacre {

namespace {

class TableV2000 {
public:
    TableV2000(MoleculeBuilder& builder, LineReader& lines) : builder_(builder), lines_(lines) {}

    CtabCounts run(std::string_view countsLine) {
        const auto counts = parseCountsV2000(countsLine);
        if (!counts) fail("no counts of atoms and bonds: '" + printable(countsLine) + "'");
        if (counts->atoms < 0 || counts->bonds < 0) fail("negative counts of atoms or bonds");
        if (counts->atoms == 0) fail("the record has no atoms");
        for (std::int64_t i = 0; i < counts->atoms; ++i) {
            step("atom", i, counts->atoms);
            readAtom(i, counts->atoms);
        }
        for (std::int64_t i = 0; i < counts->bonds; ++i) {
            step("bond", i, counts->bonds);
            readBond(i, counts->bonds);
        }
        readProperties();
        return *counts;
    }

private:
    [[noreturn]] void fail(const std::string& why) const { cannotRead(builder_.name(), why, lines_.number()); }
    static std::string ordinal(const char* what, std::int64_t i, std::int64_t count) {
        return std::string(what) + " " + std::to_string(i + 1) + " of " + std::to_string(count);
    }
    void step(const char* what, std::int64_t i, std::int64_t count) {
        if (!lines_.next()) fail("the record ends before " + ordinal(what, i, count));
    }

    /// By columns first, then by words, for writers that ignore columns.
    void readAtom(std::int64_t i, std::int64_t count) {
        const std::string_view line = lines_.line();
        std::array axes{columns(line, 0, 10), columns(line, 10, 10), columns(line, 20, 10)};
        std::string_view symbol = trim(columns(line, 30, 4));
        std::string_view charge = columns(line, 36, 3);
        const auto isSymbol = [](std::string_view text) {
            return !text.empty() && text.find_first_of("0123456789.+-") != 0 && text.find(' ') == text.npos;
        };
        const bool numeric = parseNumber(axes[0]) && parseNumber(axes[1]) && parseNumber(axes[2]);
        const Words words = splitWords(line);
        if ((!numeric || !isSymbol(symbol)) && isSymbol(words[3])) {
            axes = {words[0], words[1], words[2]};
            symbol = words[3];
            charge = words[5];
        }
        if (!isSymbol(symbol))
            fail("expected " + ordinal("atom", i, count) + ", but the line is not one: '" + printable(line) + "'");
        const auto position = builder_.position(axes, lines_.number());
        if (!position) return;
        // Codes 1 to 3 and 5 to 7 mean +3 to +1 and -1 to -3; 4 is a radical.
        const std::int64_t code = parseInteger(charge).value_or(0);
        addCtabAtom(builder_, symbol, *position, code >= 1 && code <= 7 ? 4 - code : 0, lines_.number());
    }

    void readBond(std::int64_t i, std::int64_t count) {
        const std::string_view line = lines_.line();
        auto a = parseInteger(columns(line, 0, 3)), b = parseInteger(columns(line, 3, 3));
        auto type = parseInteger(columns(line, 6, 3));
        if (!a || !b || !type) {
            const Words words = splitWords(line);
            a = parseInteger(words[0]);
            b = parseInteger(words[1]);
            type = parseInteger(words[2]);
        }
        if (!a || !b || !type)
            fail("expected " + ordinal("bond", i, count) + ", but the line is not one: '" + printable(line) + "'");
        if (const int order = bondOrderOfCtab(*type))
            builder_.addBond(builder_.atomOfRecord(*a - 1), builder_.atomOfRecord(*b - 1), order, lines_.number());
    }

    void readProperties() {
        bool first = true;
        while (lines_.next()) {
            const std::string_view line = lines_.line();
            if (startsWith(line, "M  END")) return;
            const bool charges = startsWith(line, "M  CHG");
            // Either of these lines replaces the charges of the atom lines.
            if ((charges || startsWith(line, "M  RAD")) && first) {
                first = false;
                for (Atom& atom : builder_.molecule().atoms) atom.charge = 0;
            }
            if (charges) readCharges(line);
            if (startsWith(line, "M  RAD")) builder_.pass("radicals", announcedBy(line));
            if (startsWith(line, "M  ISO")) builder_.pass("isotopes", announcedBy(line));
            if (startsWith(line, "M  STY")) builder_.pass("groups of atoms", announcedBy(line));
        }
        builder_.warn("the record has no M  END line");
    }

    /// Number of items of a line of properties.
    static std::int64_t announcedBy(std::string_view line) {
        return std::clamp<std::int64_t>(parseInteger(columns(line, 6, 3)).value_or(0), 0, 8);
    }

    void readCharges(std::string_view line) {
        const Words words = splitWords(line.substr(6));
        const std::int64_t count = parseInteger(words[0]).value_or(0);
        auto& atoms = builder_.molecule().atoms;
        for (std::size_t i = 1; i + 1 < words.count && static_cast<std::int64_t>(i) <= 2 * count; i += 2) {
            const auto atom = builder_.atomOfRecord(parseInteger(words[i]).value_or(0) - 1);
            const auto charge = parseInteger(words[i + 1]);
            if (atom < 0)
                builder_.leaveOut("charges", "of atoms that are not there", lines_.number());
            else if (charge && *charge >= -20 && *charge <= 20)
                atoms[static_cast<std::size_t>(atom)].charge = static_cast<std::int8_t>(*charge);
            else
                builder_.leaveOut("charges", "not usable", lines_.number());
        }
    }

    MoleculeBuilder& builder_;
    LineReader& lines_;
};

}  // namespace

std::optional<CtabCounts> parseCountsV2000(std::string_view line) {
    auto atoms = parseInteger(columns(line, 0, 3)), bonds = parseInteger(columns(line, 3, 3));
    if (!atoms || !bonds) {
        const Words words = splitWords(line);
        atoms = parseInteger(words[0]);
        bonds = parseInteger(words[1]);
    }
    if (!atoms || !bonds) return std::nullopt;
    return CtabCounts{*atoms, *bonds};
}

int bondOrderOfCtab(std::int64_t type) {
    if (type == 10) return 0;
    return type >= 1 && type <= 4 ? static_cast<int>(type) : 1;
}

void addCtabAtom(MoleculeBuilder& builder, std::string_view symbol, glm::vec3 position, std::int64_t charge,
                 std::uint64_t line) {
    Atom atom;
    atom.position = position;
    atom.element = builder.element(symbol, line);
    atom.name = Name(symbol);
    if (charge >= -20 && charge <= 20) atom.charge = static_cast<std::int8_t>(charge);
    builder.addAtom(atom, "", 1, '\0', "");
}

CtabCounts readCtabV2000(MoleculeBuilder& builder, LineReader& lines, std::string_view counts) {
    return TableV2000(builder, lines).run(counts);
}

}  // namespace nacre
