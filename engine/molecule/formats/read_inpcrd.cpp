// AMBER's coordinates (INPCRD, RST7): a title, a count, numbers of twelve columns; possibly velocities and a box.
// Requires a topology, which names the atoms.
#include <cmath>

#include "engine/molecule/formats/molecule_builder.h"
#include "engine/molecule/text.h"
#include "engine/molecule/trajectory/trajectory.h"

namespace nacre {

namespace {

constexpr std::size_t kInpcrdColumns = 12, kPerLine = 6;
constexpr float kUnnamedRadius = 1.0f;  // Å, of atoms without element and bonds

/// Six numbers per line; a line may be shorter.
class InpcrdNumbers {
public:
    InpcrdNumbers(const std::string& name, LineReader& lines) : name_(name), lines_(lines) {}

    /// The next number; empty at the end.
    std::optional<double> next() {
        if (at_ >= lines_.line().size() || at_ >= kInpcrdColumns * kPerLine) {
            if (!lines_.next()) return std::nullopt;
            at_ = 0;
        }
        const std::string_view field = trim(columns(lines_.line(), at_, kInpcrdColumns));
        at_ += kInpcrdColumns;
        const auto value = parseNumber(field);
        if (field.find('*') != std::string_view::npos)
            cannotRead(
                name_,
                "a coordinate is too wide for its columns, and lost: write NetCDF instead (ntxo=2, ioutfm=1), or "
                "keep the molecules in the box (iwrap=1)",
                lines_.number());
        if (!value || !(std::abs(*value) <= kFarthestCoordinate))
            cannotRead(name_, "expected a number, not '" + printable(field) + "'", lines_.number());
        return value;
    }
    void endLine() { at_ = kInpcrdColumns * kPerLine; }

private:
    const std::string& name_;
    LineReader& lines_;
    std::size_t at_ = kInpcrdColumns * kPerLine;
};

}  // namespace

Molecule readInpcrd(const std::string& name, std::string_view text, const ReadOptions& options) {
    requireModel(name, options.model, 1);
    MoleculeBuilder builder(name, options.maxAtoms);
    LineReader lines(text);
    lines.next();
    FileSummary& file = builder.molecule().file;
    file.title = printable(trim(lines.line()), 200);
    lines.next();
    const std::string_view announced = splitWords(lines.line())[0];
    const auto count = parseInteger(announced);
    if (!count || *count < 1 || *count > static_cast<std::int64_t>(text.size()))
        cannotRead(name, "expected a number of atoms, not '" + printable(announced) + "'", lines.number());
    InpcrdNumbers numbers(name, lines);
    for (std::int64_t i = 0; i < *count; ++i) {
        Atom atom;
        for (int axis = 0; axis < 3; ++axis) {
            const auto value = numbers.next();
            if (!value) cannotRead(name, "it ends after " + std::to_string(i) + " atoms", lines.number());
            atom.position[axis] = static_cast<float>(*value);
        }
        atom.radius = kUnnamedRadius;
        builder.addAtom(atom);
    }
    builder.guess("radii", "the same for all atoms", *count);
    // The box is the last line, after velocities if there are any.
    std::string_view last;
    std::size_t left = 0;
    for (; lines.next(); ++left)
        if (!trim(lines.line()).empty()) last = lines.line();
    std::array<double, 6> box{0, 0, 0, 90, 90, 90};
    const std::size_t given = (trim(last).empty() ? 0 : last.size() + kInpcrdColumns - 1) / kInpcrdColumns;
    const std::size_t linesOfAtoms = (static_cast<std::size_t>(*count) + 1) / 2;
    if (left >= linesOfAtoms && left > 1) builder.pass("velocities", *count);
    if ((given == 6 || given == 3) && (left == 1 || left == linesOfAtoms + 1)) {
        for (std::size_t i = 0; i < given; ++i)
            box[i] = parseNumber(columns(last, i * kInpcrdColumns, kInpcrdColumns)).value_or(0);
        if (const auto vectors = makeBox({box[0], box[1], box[2]}, {box[3], box[4], box[5]})) builder.takeBox(*vectors);
    }
    builder.warn("it has only coordinates: open its topology, and pass this file with --trajectory");
    file.format = "inpcrd";
    file.models = 1;
    file.totalAtomsAllModels = *count;
    return builder.finish();
}

}  // namespace nacre
