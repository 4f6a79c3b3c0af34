// Tinker XYZ and ARC: frames of a count and a title, possibly a line with the periodic box, then lines of number, name,
// position, type and bonded atoms.
#include <algorithm>

#include "engine/molecule/formats/frames.h"
#include "engine/molecule/formats/pdb_fields.h"
#include "engine/molecule/text.h"
#include "engine/molecule/trajectory/trajectory.h"

namespace nacre {

namespace {

class TinkerReader : public FrameReader {
public:
    using FrameReader::FrameReader;

private:
    std::optional<std::int64_t> begin(std::int64_t frame) override {
        if (trim(lines_.rest()).empty()) return std::nullopt;
        while (lines_.next() && trim(lines_.line()).empty()) {
        }
        const std::string_view line = trim(lines_.line());
        const std::string_view announced = splitWords(line)[0];
        const auto count = isCount(announced) ? parseInteger(announced) : std::nullopt;
        constexpr std::size_t kShortestAtomLine = 11;  // "1 C 0 0 0 1"
        if (!count || *count > static_cast<std::int64_t>(lines_.rest().size() / kShortestAtomLine + 1)) {
            if (frame > model_) return passOver(frame);
            refuseCount(announced, lines_.number());
        }
        if (frame == model_) builder_.molecule().file.title = printable(trim(line.substr(announced.size())), 200);
        takeBox(frame == model_);
        return count;
    }

    /// Three lengths and three angles, on a line of their own.
    void takeBox(bool wanted) {
        LineReader ahead = lines_;
        if (!ahead.next()) return;
        const Words words = splitWords(ahead.line());
        std::array<double, 6> numbers{};
        for (std::size_t i = 0; i < 6; ++i) {
            const auto value = parseNumber(words[i]);
            if (words.count != 6 || !value) return;
            numbers[i] = *value;
        }
        lines_ = ahead;
        const auto box = makeBox({numbers[0], numbers[1], numbers[2]}, {numbers[3], numbers[4], numbers[5]});
        if (wanted && box) builder_.takeBox(*box);
    }

    void readAtom(std::string_view line) override {
        std::vector<std::string_view> words = splitAllWords(line);
        std::string apart;
        if (std::any_of(words.begin(), words.end(), mayTouch)) words = splitAllWords(apart = numbersApart(line));
        readBonds(words);
        if (words.size() < 5)
            return builder_.leaveOutAtom(
                "an atom line needs a number, a name and three coordinates: '" + printable(line) + "'",
                lines_.number());
        const auto position = builder_.position({words[2], words[3], words[4]}, lines_.number());
        if (!position) return;
        Atom atom{.position = *position, .name = Name(words[1])};
        // Names are those of a force field: "CT", "HN", "OW"; "Na+" and "Cl-" are ions.
        atom.element = pdb::elementByLooseName(words[1], Name());
        builder_.guess("elements", "from atom names");
        builder_.addAtom(atom);
        builder_.molecule().types.emplace_back(words.size() > 5 ? words[5] : std::string_view());
    }

    void readBonds(const std::vector<std::string_view>& words) {
        const std::int64_t own = records_++;
        for (std::size_t i = 6; i < words.size(); ++i) {
            const auto other = parseInteger(words[i]);
            if (!other || *other - 1 < own) continue;  // each bond is listed with both of its atoms
            if (bonds_.size() < builder_.mostBonds()) bonds_.push_back({own, *other - 1, lines_.number()});
        }
    }

    void end(bool wanted) override {
        if (!wanted) return;
        for (const TinkerBond& bond : bonds_)
            builder_.addBond(builder_.atomOfRecord(bond.a), builder_.atomOfRecord(bond.b), 1, bond.line);
    }

    /// Bonds by record numbers.
    struct TinkerBond {
        std::int64_t a, b;
        std::uint64_t line;
    };
    std::int64_t records_ = 0;
    std::vector<TinkerBond> bonds_;
};

}  // namespace

Molecule readTinker(const std::string& name, std::string_view text, const ReadOptions& options) {
    return TinkerReader(name, text, options).run("tinker");
}

}  // namespace nacre
