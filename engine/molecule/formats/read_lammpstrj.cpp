// LAMMPS dump files: frames of ITEM sections; the line "ITEM: ATOMS" names the columns. Atoms of a frame come in any
// order and are sorted by id.
#include <algorithm>
#include <cmath>

#include "engine/molecule/element.h"
#include "engine/molecule/formats/frames.h"
#include "engine/molecule/formats/lammps_types.h"
#include "engine/molecule/text.h"

namespace nacre {

namespace {

class DumpReader : public FrameReader {
public:
    using FrameReader::FrameReader;

private:
    static constexpr std::size_t kNone = ~std::size_t{0};

    std::optional<std::int64_t> begin(std::int64_t frame) override {
        std::optional<std::int64_t> count;
        low_ = glm::dvec3(0);
        edges_ = {};
        while (lines_.next()) {
            const std::string_view line = trim(lines_.line());
            if (startsWith(line, "ITEM: NUMBER OF ATOMS")) {
                lines_.next();
                count = parseInteger(lines_.line());
                if (!count || *count < 1 || *count > static_cast<std::int64_t>(lines_.rest().size()))
                    refuseCount(trim(lines_.line()), lines_.number());
            } else if (startsWith(line, "ITEM: BOX BOUNDS")) {
                readBounds();
            } else if (startsWith(line, "ITEM: ATOMS")) {
                if (!count) cannotRead(name_, "a frame does not state its number of atoms", lines_.number());
                if (frame == model_) nameColumns(splitAllWords(line));
                return count;
            }
        }
        return std::nullopt;
    }

    /// "ITEM: BOX BOUNDS xy xz yz pp pp ff": p is periodic. Old files do not state it. "abc origin" has edges and
    /// corner instead.
    void readBounds() {
        std::size_t flags = 0;
        repeats_.fill(true);
        const bool general = lines_.line().find("abc origin") != std::string_view::npos;
        for (const std::string_view word : splitAllWords(lines_.line()))
            if (word.size() == 2 && word.find_first_not_of("pfsm") == std::string_view::npos && flags < 3)
                repeats_[flags++] = word[0] == 'p';
        glm::dvec3 high(0), tilt(0);
        for (int axis = 0; axis < 3; ++axis) {
            lines_.next();
            const Words words = splitWords(lines_.line());
            const auto number = [&](std::size_t i) { return parseNumber(words[i]).value_or(0); };
            low_[axis] = number(general ? 3 : 0);
            high[axis] = number(1);
            tilt[axis] = number(2);
            if (general) edges_[static_cast<std::size_t>(axis)] = {number(0), number(1), number(2)};
        }
        if (general) return;
        // With tilts (xy, xz, yz), the bounds enclose the box's corners.
        const double xy = tilt.x, xz = tilt.y, yz = tilt.z;
        low_.x -= std::min({0.0, xy, xz, xy + xz});
        high.x -= std::max({0.0, xy, xz, xy + xz});
        low_.y -= std::min(0.0, yz);
        high.y -= std::max(0.0, yz);
        high -= low_;
        edges_ = {glm::dvec3(high.x, 0, 0), glm::dvec3(xy, high.y, 0), glm::dvec3(xz, yz, high.z)};
    }

    void nameColumns(const std::vector<std::string_view>& words) {
        const auto find = [&](std::initializer_list<std::string_view> names) {
            for (const std::string_view name : names)
                for (std::size_t i = 2; i < words.size(); ++i)
                    if (words[i] == name) return i - 2;
            return kNone;
        };
        columns_ = words.size() - 2;
        names_.assign(words.begin() + 2, words.end());
        id_ = find({"id"});
        type_ = find({"type"});
        element_ = find({"element"});
        molecule_ = find({"mol"});
        mass_ = find({"mass"});
        charge_ = find({"q"});
        radius_ = find({"radius"});
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::string letter(1, "xyz"[axis]);
            at_[axis] = find({letter, letter + "s", letter + "u", letter + "su"});
            if (at_[axis] == kNone) cannotRead(name_, "its atoms have no positions", lines_.number());
            scaled_ = words[at_[axis] + 2].find('s') != std::string_view::npos;
        }
    }

    void readAtom(std::string_view line) override {
        std::vector<std::string_view> words = splitAllWords(line);
        std::string apart;
        if (words.size() < columns_) words = splitAllWords(apart = numbersApart(line));
        const auto word = [&](std::size_t i) { return i < words.size() ? words[i] : std::string_view(); };
        DumpAtom row;
        row.id = parseInteger(word(id_)).value_or(static_cast<std::int64_t>(rows_.size()));
        const auto position = builder_.position({word(at_[0]), word(at_[1]), word(at_[2])}, lines_.number());
        if (!position) return;
        row.atom.position = *position;
        if (rows_.size() >= builder_.maxAtoms()) throw tooManyAtoms(name_, builder_.maxAtoms());
        row.type = Name(word(type_ == kNone ? element_ : type_));
        if (element_ != kNone) row.atom.element = builder_.element(word(element_), lines_.number());
        row.molecule = static_cast<std::int32_t>(parseInteger(word(molecule_)).value_or(1));
        const auto number = [&](std::size_t column, const char* what) {
            if (column == kNone) return 0.0f;
            const auto value = parseNumber(word(column));
            if (value && std::abs(*value) <= 1e6) return static_cast<float>(*value);
            builder_.leaveOut(what, "not usable, read as 0", lines_.number());
            return 0.0f;
        };
        row.charge = number(charge_, "partial charges");
        row.mass = number(mass_, "masses");
        if (element_ == kNone) row.atom.radius = std::max(number(radius_, "radii"), 0.0f);
        if (row.atom.radius > 0) builder_.state("radii");
        rows_.push_back(row);
    }

    void end(bool wanted) override {
        if (!wanted) return;
        std::stable_sort(rows_.begin(), rows_.end(), [](const DumpAtom& a, const DumpAtom& b) { return a.id < b.id; });
        const std::array<glm::vec3, 3> box{glm::vec3(edges_[0]), glm::vec3(edges_[1]), glm::vec3(edges_[2])};
        LammpsTypes types;
        Molecule& molecule = builder_.molecule();
        for (DumpAtom& row : rows_) {
            if (scaled_) {
                const glm::dvec3 share(row.atom.position);
                const auto position = builder_.computedPosition(
                    low_ + edges_[0] * share.x + edges_[1] * share.y + edges_[2] * share.z, 0);
                if (!position) continue;
                row.atom.position = *position;
            }
            row.atom.name = row.atom.element ? Name(elementSymbol(row.atom.element)) : row.type;
            builder_.addAtom(row.atom, "", row.molecule, '\0', "");
            molecule.types.push_back(row.type);
            if (charge_ != kNone) molecule.partialCharges.push_back(row.charge);
            if (mass_ != kNone) types.add(row.type.view(), static_cast<double>(row.mass), "");
        }
        rows_.clear();
        if (element_ == kNone && !molecule.atoms.empty()) types.apply(builder_);
        builder_.takeBox(box, glm::vec3(low_));
        molecule.file.boxRepeats = repeats_;
        noteUnused(static_cast<std::int64_t>(molecule.atoms.size()));
    }

    void noteUnused(std::int64_t atoms) {
        for (const std::string& name : names_) {
            if (name == "vx" || name == "fx") builder_.pass(name == "vx" ? "velocities" : "forces", atoms);
            static constexpr std::string_view kUsed[] = {"id", "type", "element", "mol", "mass", "q",  "radius", "vx",
                                                         "vy", "vz",   "fx",      "fy",  "fz",   "ix", "iy",     "iz"};
            const bool place = name.find_first_not_of("xyzsu") == std::string::npos;
            if (!place && std::ranges::find(kUsed, name) == std::end(kUsed)) builder_.pass("further columns");
        }
    }

    struct DumpAtom {
        std::int64_t id;
        Atom atom;
        Name type;
        std::int32_t molecule;
        float charge, mass;
    };
    std::size_t id_ = kNone, type_ = kNone, element_ = kNone, molecule_ = kNone, mass_ = kNone, charge_ = kNone,
                radius_ = kNone;
    std::size_t columns_ = 0;
    std::vector<std::string> names_;  ///< of the columns
    std::array<bool, 3> repeats_{true, true, true};
    std::array<std::size_t, 3> at_{};
    bool scaled_ = false;
    glm::dvec3 low_{};
    std::array<glm::dvec3, 3> edges_{};
    std::vector<DumpAtom> rows_;
};

}  // namespace

Molecule readLammpstrj(const std::string& name, std::string_view text, const ReadOptions& options) {
    return DumpReader(name, text, options).run("lammpstrj");
}

}  // namespace nacre
