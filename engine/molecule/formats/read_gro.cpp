// GRO (GROMACS): frames of a title, a count, one line of fixed columns per atom and the box; lengths in nm.
#include "engine/molecule/formats/frames.h"
#include "engine/molecule/formats/pdb_fields.h"
#include "engine/molecule/text.h"

namespace nacre {

namespace {

constexpr std::size_t kFirstPosition = 20;    // after residue number, residue name, atom name and atom number
constexpr std::size_t kShortestGroLine = 26;  // coordinates of two characters, without trailing blanks
constexpr std::size_t kMostShift = 4;
constexpr double kAngstrom = 10;  // per nm
constexpr std::int32_t kNumbersWrapAt = 100000;

class GroReader : public FrameReader {
public:
    using FrameReader::FrameReader;

private:
    std::optional<std::int64_t> begin(std::int64_t frame) override {
        if (trim(lines_.rest()).empty()) return std::nullopt;
        lines_.next();
        const std::string_view title = trim(lines_.line());
        const std::string_view announced = lines_.next() ? trim(lines_.line()) : std::string_view();
        const auto count = isCount(announced) ? parseInteger(announced) : std::nullopt;
        if (count && *count <= static_cast<std::int64_t>(lines_.rest().size() / kShortestGroLine + 1)) {
            if (frame == model_) builder_.molecule().file.title = printable(title, 200);
            return count;
        }
        if (frame > model_) return passOver(frame);
        refuseCount(announced, lines_.number());
    }

    /// The distance between decimal points: files may have more digits than the usual three.
    static std::size_t widthOfCoordinates(std::string_view line) {
        constexpr std::size_t kUsual = 8, kWidest = 32;
        const std::size_t first = line.find('.', kFirstPosition);
        if (first == std::string_view::npos) return kUsual;
        const std::size_t second = line.find('.', first + 1);
        return second == std::string_view::npos || second - first > kWidest ? kUsual : second - first;
    }

    static std::size_t firstPoint(std::string_view line) { return line.find('.', kFirstPosition - kMostShift); }

    /// Restores a few blanks lost at the start of a line.
    std::string_view unshifted(std::string_view line) {
        const std::size_t point = firstPoint(line);
        if (point >= point_ || point_ - point > kMostShift) return line;
        shifted_ = std::string(point_ - point, ' ') + std::string(line);
        return shifted_;
    }

    void readAtom(std::string_view line) override {
        if (builder_.molecule().atoms.empty()) width_ = widthOfCoordinates(line), point_ = firstPoint(line);
        line = unshifted(line);
        Atom atom;
        for (int axis = 0; axis < 3; ++axis) {
            const auto value =
                builder_.coordinate(columns(line, kFirstPosition + static_cast<std::size_t>(axis) * width_, width_),
                                    "xyz"[axis], lines_.number(), kAngstrom);
            if (!value) return;
            atom.position[axis] = *value;
        }
        velocities_ += !trim(columns(line, kFirstPosition + 3 * width_, line.size())).empty();
        const std::string_view residue = trim(columns(line, 5, 5));
        const std::string_view name = trim(columns(line, 10, 5));
        atom.name = Name(name);
        atom.element = pdb::elementByLooseName(name, Name(residue));
        builder_.addAtom(atom, "", unwrapped(parseInteger(columns(line, 0, 5)).value_or(0)), '\0', residue);
    }

    /// Residue numbers have five digits: 99999 is followed by 0.
    std::int32_t unwrapped(std::int64_t written) {
        const auto number = static_cast<std::int32_t>(written);
        if (lastNumber_ == kNumbersWrapAt - 1 && number == 0 && wraps_ < 10000) ++wraps_;
        lastNumber_ = number;
        return number + wraps_ * kNumbersWrapAt;
    }

    /// Three lengths, or the nine components in the order xx yy zz xy xz yx yz zx zy.
    void end(bool wanted) override {
        const bool there = lines_.next();
        if (!wanted) return;
        const Words words = there ? splitWords(lines_.line()) : Words();
        builder_.pass("velocities", velocities_);
        builder_.guess("elements", "from atom names", static_cast<std::int64_t>(builder_.molecule().atoms.size()));
        constexpr std::size_t kPlace[9][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 0}, {1, 2}, {2, 0}, {2, 1}};
        std::array<glm::vec3, 3> box{};
        const std::size_t count = words.count >= 9 ? 9 : 3;
        for (std::size_t i = 0; i < count; ++i) {
            const auto value = parseNumber(words[i]);
            if (!value || !(std::abs(*value) <= 1e9)) {
                builder_.warn("frame " + std::to_string(model_) + " has no readable box");
                return;
            }
            box[kPlace[i][0]][static_cast<int>(kPlace[i][1])] = static_cast<float>(*value * kAngstrom);
        }
        builder_.takeBox(box);  // a missing box is written as zeros
    }

    std::size_t width_ = 8, point_ = 0;
    std::string shifted_;
    std::int64_t velocities_ = 0;
    std::int32_t lastNumber_ = 0, wraps_ = 0;
};

}  // namespace

Molecule readGro(const std::string& name, std::string_view text, const ReadOptions& options) {
    return GroReader(name, text, options).run("gro");
}

}  // namespace nacre
