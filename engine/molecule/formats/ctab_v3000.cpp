#include <vector>

#include "engine/molecule/formats/ctab.h"
#include "engine/molecule/formats/id_index.h"

namespace nacre {

namespace {

constexpr std::string_view kLinePrefix = "M  V30 ";

class TableV3000 {
public:
    TableV3000(MoleculeBuilder& builder, LineReader& lines) : builder_(builder), lines_(lines) {}

    CtabCounts run() {
        std::optional<CtabCounts> announced;
        CtabCounts read;
        bool ended = false;
        while (!ended && next()) {
            const Words words = splitWords(line_);
            if (words[0] == "COUNTS" && !announced) {
                const auto atoms = parseInteger(words[1]), bonds = parseInteger(words[2]);
                if (!atoms || !bonds || *atoms < 0 || *bonds < 0) fail("bad counts: '" + printable(line_) + "'");
                announced = CtabCounts{*atoms, *bonds};
            } else if (words[0] == "BEGIN" && words[1] == "ATOM") {
                read.atoms += block("ATOM", [this] { readAtom(); });
                if (IdIndex(ids_).repeats()) fail("an atom number occurs twice");
            } else if (words[0] == "BEGIN" && words[1] == "BOND") {
                const IdIndex index(ids_);
                read.bonds += block("BOND", [&] { readBond(index); });
            }
            // Data after the first table (R groups, templates) is not part of the molecule.
            ended = words[0] == "END" && words[1] == "CTAB";
        }
        if (!ended) fail("the record ends before END CTAB");
        if (announced && (announced->atoms != read.atoms || announced->bonds != read.bonds))
            builder_.warn("the counts line states " + std::to_string(announced->atoms) + " atoms and " +
                          std::to_string(announced->bonds) + " bonds, but there are " + std::to_string(read.atoms) +
                          " and " + std::to_string(read.bonds));
        return read;
    }

private:
    [[noreturn]] void fail(const std::string& why) const { cannotRead(builder_.name(), why, lines_.number()); }

    /// Steps to the next V30 line, joined with its continuations; false at the end of the table.
    bool next() {
        line_.clear();
        while (lines_.next()) {
            std::string_view text = lines_.line();
            if (startsWith(text, "M  END")) return false;
            if (!startsWith(text, kLinePrefix))
                fail("expected a line that begins with 'M  V30 ': '" + printable(text) + "'");
            text.remove_prefix(kLinePrefix.size());
            while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
            const bool continues = !text.empty() && text.back() == '-';
            if (continues) text.remove_suffix(1);
            line_ += text;
            if (!continues) return true;
        }
        return false;
    }

    template <typename ReadLine>
    std::int64_t block(std::string_view kind, ReadLine readLine) {
        std::int64_t count = 0;
        while (next()) {
            if (startsWith(line_, "END ")) return count;
            readLine();
            ++count;
        }
        fail("the record ends inside its " + std::string(kind) + " block");
    }

    /// index type x y z aamap [KEY=VALUE ...]; the type may be a list in brackets, with blanks.
    void readAtom() {
        std::string_view text = line_;
        std::string_view type;
        const std::size_t open = text.find('['), close = text.find(']');
        const bool list = open != std::string_view::npos && close != std::string_view::npos && open < close;
        Words words = splitWords(list ? text.substr(close + 1) : text);
        const auto index = parseInteger(splitWords(text)[0]);
        type = list ? std::string_view("*") : words[1];
        const std::size_t x = list ? 0 : 2;
        if (!index || *index < 0) fail("expected an atom, not '" + printable(line_) + "'");
        ids_.push_back(*index);
        const auto position = builder_.position({words[x], words[x + 1], words[x + 2]}, lines_.number());
        if (!position) return;
        std::int64_t charge = 0;
        for (std::size_t i = x + 3; i < words.count; ++i)
            if (startsWith(words[i], "CHG=")) charge = parseInteger(words[i].substr(4)).value_or(0);
        addCtabAtom(builder_, type, *position, charge, lines_.number());
    }

    /// index type atom1 atom2 [KEY=VALUE ...]
    void readBond(const IdIndex& index) {
        const Words words = splitWords(line_);
        const auto type = parseInteger(words[1]), a = parseInteger(words[2]), b = parseInteger(words[3]);
        if (!type || !a || !b) fail("expected a bond, not '" + printable(line_) + "'");
        const auto findAtom = [&](std::int64_t id) {
            std::uint32_t record = 0;
            return index.find(id, record) == IdIndex::Found::one ? builder_.atomOfRecord(record) : -1;
        };
        if (const int order = bondOrderOfCtab(*type))
            builder_.addBond(findAtom(*a), findAtom(*b), order, lines_.number());
    }

    MoleculeBuilder& builder_;
    LineReader& lines_;
    std::string line_;
    std::vector<std::int64_t> ids_;  ///< the file's number of each atom record
};

}  // namespace

CtabCounts readCtabV3000(MoleculeBuilder& builder, LineReader& lines) { return TableV3000(builder, lines).run(); }

}  // namespace nacre
