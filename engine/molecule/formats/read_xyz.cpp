// XYZ: a count, a comment and one line per atom, frame after frame. Extended XYZ names its columns in the comment
// (Properties=species:S:1:pos:R:3:...).
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "engine/molecule/element.h"
#include "engine/molecule/formats/frames.h"
#include "engine/molecule/text.h"

namespace nacre {

namespace {

constexpr std::size_t kShortestAtomLine = 7;  // "C 0 0 0"

struct Layout {
    std::size_t species = 0;            ///< word of the atom line
    std::size_t position = 1;           ///< word of x
    std::vector<std::string> unused{};  ///< names of other columns, such as "velocities"
    bool named = false;                 ///< the comment names the columns
};

/// Name of an extended XYZ property in notes.
std::string_view plainName(std::string_view property) {
    for (const char* name : {"velocities", "momenta", "forces", "charges", "masses", "magmoms"})
        if (startsWith(property, std::string_view(name).substr(0, 4)) || (property == "force" && name[0] == 'f'))
            return name;
    return property.find("charges") != std::string_view::npos ? "charges" : "further columns";
}

class XyzReader : public FrameReader {
public:
    using FrameReader::FrameReader;

private:
    std::optional<std::int64_t> begin(std::int64_t frame) override {
        while (lines_.next()) {
            if (trim(lines_.line()).empty()) continue;
            const std::string_view text = trim(lines_.line());
            if (!isCount(text) && frame > model_) return passOver(frame);
            if (!isCount(text)) refuseCount(text, lines_.number());
            const std::uint64_t line = lines_.number();
            const auto count = parseInteger(text);
            const bool comment = lines_.next();
            if (frame == model_) comment_ = comment ? lines_.line() : std::string_view();
            if (count && *count <= static_cast<std::int64_t>(lines_.rest().size() / kShortestAtomLine + 1))
                return count;
            if (frame <= model_) refuseCount(text, line);
            builder_.warn("frame " + std::to_string(frame) + " is incomplete");
            return std::nullopt;
        }
        return std::nullopt;
    }

    void beginAtoms() override {
        builder_.molecule().file.title = printable(trim(comment_), 200);
        layout_ = parseLayout(comment_);
        takeLattice();
    }

    /// The value of a key in the comment, without quotes; empty if it is missing.
    std::string_view findValue(std::string_view key) const {
        const std::string lower = lowerCase(comment_);
        const std::size_t at = lower.find(std::string(key) + "=");
        if (at == std::string::npos || (at > 0 && !isBlank(lower[at - 1]))) return {};
        const std::string_view value = comment_.substr(at + key.size() + 1);
        constexpr std::string_view kOpen = "\"'{[", kClose = "\"'}]";
        const std::size_t kind = kOpen.find(value.substr(0, 1));
        if (value.empty() || kind == std::string_view::npos) return value.substr(0, value.find_first_of(" \t"));
        std::size_t end = 1;
        for (int depth = 1; end < value.size(); ++end) {
            if (value[end] == kClose[kind]) --depth;
            if (depth == 0) break;
            if (value[end] == kOpen[kind]) ++depth;
        }
        return value.substr(1, end - 1);
    }
    /// Words of "5 0 0 ..." and "[[5, 0, 0], ...]".
    static std::string withoutBrackets(std::string_view list) {
        std::string text(list);
        for (char& c : text)
            if (c == ',' || c == '[' || c == ']') c = ' ';
        return text;
    }

    /// Lattice="ax ay az bx by bz cx cy cz", and pbc="T T F" for the vectors along which it repeats.
    void takeLattice() {
        const std::string_view stated = findValue("lattice");
        const std::string lattice = numbersApart(withoutBrackets(stated));
        const Words numbers = splitWords(lattice);
        if (trim(stated).empty()) return;
        if (numbers.count != 9)
            return builder_.leaveOut("periodic boxes", "the Lattice is not nine numbers", lines_.number());
        std::array<glm::vec3, 3> box{};
        for (std::size_t i = 0; i < 9; ++i) {
            const auto value = parseNumber(numbers[i]);
            if (!value || !(std::abs(*value) <= kFarthestCoordinate))
                return builder_.leaveOut("periodic boxes", "the Lattice is not nine numbers", lines_.number());
            box[i / 3][static_cast<int>(i % 3)] = static_cast<float>(*value);
        }
        std::array<bool, 3> repeats{true, true, true};
        const std::string pbc = withoutBrackets(findValue("pbc"));  // "T T F", "1 1 0", "True, True, False"
        const Words flags = splitWords(pbc);
        for (std::size_t i = 0; i < flags.count && i < 3; ++i)
            repeats[i] = flags[i] != "0" && upperCase(flags[i][0]) != 'F';
        if (flags.count == 1) repeats.fill(repeats[0]);
        builder_.takeCell(box, lines_.number(), repeats);
    }

    void readAtom(std::string_view text) override {
        std::string apart;
        const Words words = splitWordsApart(text, layout_.position, apart);
        const std::uint64_t line = lines_.number();
        const std::size_t least = std::max(layout_.species + 1, layout_.position + 3);
        if (words.count < least)
            return builder_.leaveOutAtom(
                "an atom line needs an element and three coordinates: '" + printable(text) + "'", line);
        Atom atom;
        const std::size_t x = layout_.position;
        const auto position = builder_.position({words[x], words[x + 1], words[x + 2]}, line);
        if (!position) return;
        atom.position = *position;
        const std::string_view species = words[layout_.species];
        atom.element = builder_.element(species, line);
        atom.name = Name(atom.element != 0 ? elementSymbol(atom.element) : species);
        builder_.addAtom(atom, "", 1, '\0', "");
        if (!layout_.named && words.count > least) furthest_ = std::max(furthest_, words.count - least);
    }

    void end(bool wanted) override {
        if (!wanted) return;
        const auto atoms = static_cast<std::int64_t>(builder_.molecule().atoms.size());
        for (const std::string& what : layout_.unused) builder_.pass(what, what == "further columns" ? 1 : atoms);
        builder_.pass("further columns", static_cast<std::int64_t>(furthest_));
    }

    /// Columns from the comment of an extended XYZ file; without a usable list, the usual ones.
    Layout parseLayout(std::string_view comment) {
        const std::string lower = lowerCase(comment);
        std::size_t at = lower.find("properties=");
        if (at == std::string::npos) return {};
        at += std::string_view("properties=").size();
        std::string_view list = std::string_view(lower).substr(at);
        if (!list.empty() && list.front() == '"') list.remove_prefix(1);
        list = list.substr(0, list.find_first_of(" \t\""));
        std::optional<std::size_t> species, position;
        std::vector<std::string> unused;
        std::size_t column = 0;
        while (!list.empty()) {
            const auto field = [&list] {
                const std::size_t colon = list.find(':');
                const std::string_view text = list.substr(0, colon);
                list.remove_prefix(colon == std::string_view::npos ? list.size() : colon + 1);
                return text;
            };
            const std::string_view property = field(), type = field();
            const auto width = parseInteger(field());
            if (type.size() != 1 || !width || *width < 1 || *width > 16) return unusable();
            if (property == "species" || (property == "z" && !species)) species = column;
            if (property == "pos" && *width == 3) position = column;
            if (property != "species" && property != "z" && property != "pos") unused.emplace_back(plainName(property));
            column += static_cast<std::size_t>(*width);
            if (column > 1000) return unusable();
        }
        if (!species || !position || *species >= 16 || *position + 3 > 16) return unusable();
        return {*species, *position, std::move(unused), true};
    }

    Layout unusable() {
        builder_.warn("the Properties of the comment line are not usable; element and coordinates are read as usual");
        return {};
    }

    std::string_view comment_;
    Layout layout_;
    std::size_t furthest_ = 0;  ///< most words after the coordinates of an atom line, if columns are unnamed
};

}  // namespace

Molecule readXyz(const std::string& name, std::string_view text, const ReadOptions& options) {
    return XyzReader(name, text, options).run("xyz");
}

}  // namespace nacre
