// VASP's POSCAR, CONTCAR and XDATCAR: a title, a scale, three cell vectors, symbols and counts of the species, then
// positions; an XDATCAR has further configurations.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "engine/molecule/element.h"
#include "engine/molecule/formats/molecule_builder.h"
#include "engine/molecule/text.h"

namespace nacre {

namespace {

class PoscarReader {
public:
    PoscarReader(const std::string& name, std::string_view text, const ReadOptions& options)
        : name_(name), lines_(text), model_(options.model), builder_(name, options.maxAtoms) {}

    Molecule run() {
        FileSummary& file = builder_.molecule().file;
        const std::string_view title = next();
        file.title = printable(trim(title), 200);
        readHeader(title);
        std::int64_t frames = 0, atoms = 0;
        do {
            ++frames;
            atoms += atoms_;
            readFrame(frames == model_);
            if (frames == model_) noteVelocities();
        } while (skipToConfiguration());
        requireModel(name_, model_, frames);
        file.format = "poscar";
        file.models = frames;
        file.totalAtomsAllModels = atoms;
        return builder_.finish();
    }

private:
    std::string_view next() {
        if (!lines_.next()) cannotRead(name_, "it ends before its atoms", lines_.number());
        return lines_.line();
    }

    glm::dvec3 three(std::string_view line) const {
        std::string apart;
        const Words words = splitWordsApart(line, 0, apart);
        glm::dvec3 values;
        for (std::size_t i = 0; i < 3; ++i) {
            const auto value = parseNumber(words[i]);
            if (!value || !(std::abs(*value) <= kFarthestCoordinate))
                cannotRead(name_, "expected three numbers, not '" + printable(line) + "'", lines_.number());
            values[static_cast<int>(i)] = *value;
        }
        return values;
    }

    void readHeader(std::string_view title) {
        readCell();
        readSpecies(title);
    }

    /// A negative scale is the cell's volume; there may be one scale per axis.
    void readCell() {
        const std::string_view scales = next();
        const auto scale = parseNumber(splitWords(scales)[0]);
        if (!scale) cannotRead(name_, "expected a scale, not '" + printable(scales) + "'", lines_.number());
        scale_ = splitWords(scales).count == 3 ? three(scales) : glm::dvec3(*scale);
        for (glm::dvec3& vector : cell_) vector = three(next());
        lineOfCell_ = lines_.number() - 2;
        const double volume = std::abs(glm::dot(cell_[0], glm::cross(cell_[1], cell_[2])));
        if (*scale < 0 && volume > 0) scale_ = glm::dvec3(std::cbrt(-*scale / volume));
        for (glm::dvec3& vector : cell_) vector *= scale_;
    }

    /// Symbols precede the counts; in old files they are at best in the title. "Fe_pv" and "Fe/1a2b" name a potential.
    void readSpecies(std::string_view title) {
        std::vector<std::string_view> symbols = splitAllWords(next()), counts = symbols;
        if (!symbols.empty() && parseInteger(symbols[0]))
            symbols = splitAllWords(title);
        else
            counts = splitAllWords(next());
        species_.clear();
        atoms_ = 0;
        for (std::size_t i = 0; i < counts.size(); ++i) {
            const auto count = parseInteger(counts[i]);
            if (!count || *count < 0 || *count > static_cast<std::int64_t>(lines_.rest().size()))
                cannotRead(name_, "expected numbers of atoms, not '" + printable(lines_.line()) + "'", lines_.number());
            const std::string_view symbol = i < symbols.size() ? symbols[i] : std::string_view();
            species_.push_back(
                {builder_.element(symbol.substr(0, symbol.find_first_of("_/")), lines_.number()), *count});
            atoms_ += *count;
        }
    }

    void readFrame(bool wanted) {
        if (wanted) builder_.takeCell({glm::vec3(cell_[0]), glm::vec3(cell_[1]), glm::vec3(cell_[2])}, lineOfCell_);
        std::string_view mode = trim(next());
        const bool selective = !mode.empty() && upperCase(mode[0]) == 'S';
        if (selective) mode = trim(next());
        if (selective && wanted) builder_.pass("flags of selective dynamics", atoms_);
        const bool cartesian = !mode.empty() && (upperCase(mode[0]) == 'C' || upperCase(mode[0]) == 'K');
        for (const Species& species : species_)
            for (std::int64_t i = 0; i < species.count; ++i) {
                const std::string_view line = next();
                if (!wanted) continue;
                std::string apart;
                const Words words = splitWordsApart(line, 0, apart);
                const auto given = builder_.position({words[0], words[1], words[2]}, lines_.number());
                if (!given) continue;
                const glm::dvec3 p(*given);
                const auto position = builder_.computedPosition(
                    cartesian ? p * scale_ : cell_[0] * p.x + cell_[1] * p.y + cell_[2] * p.z, lines_.number());
                if (!position) continue;
                Atom atom;
                atom.position = *position;
                atom.element = species.element;
                atom.name = Name(elementSymbol(species.element));
                builder_.addAtom(atom);
            }
    }

    /// Velocities follow a blank line, or one that names their kind.
    void noteVelocities() {
        LineReader ahead = lines_;
        if (!ahead.next() || lowerCase(ahead.line()).find("configuration") != std::string::npos) return;
        std::int64_t rows = 0;
        for (const auto isNumber = [](std::string_view word) { return parseNumber(word).has_value(); };
             rows < atoms_ && ahead.next(); ++rows) {
            const std::vector<std::string_view> words = splitAllWords(ahead.line());
            if (words.size() != 3 || !std::all_of(words.begin(), words.end(), isNumber)) return;
        }
        if (rows == atoms_) builder_.pass("velocities", rows);
    }

    /// Skips velocities and other data. If the cell varies, each configuration has its own header.
    bool skipToConfiguration() {
        for (LineReader ahead = lines_; ahead.next(); lines_ = ahead) {
            if (lowerCase(ahead.line()).find("configuration") != std::string::npos) return true;
            if (!beginsHeader(ahead)) continue;
            lines_ = ahead;
            readHeader(ahead.line());
            return true;
        }
        return false;
    }

    /// Whether a scale and three vectors follow a title. @param ahead  on the title
    static bool beginsHeader(LineReader ahead) {
        for (std::size_t line = 0; line < 4; ++line) {
            if (!ahead.next()) return false;
            const Words words = splitWords(ahead.line());
            if (words.count != (line == 0 ? 1 : 3)) return false;
            for (std::size_t i = 0; i < words.count; ++i)
                if (!parseNumber(words[i])) return false;
        }
        return true;
    }

    struct Species {
        Element element;
        std::int64_t count;
    };
    const std::string& name_;
    LineReader lines_;
    int model_;
    MoleculeBuilder builder_;
    glm::dvec3 scale_{1};
    std::array<glm::dvec3, 3> cell_{};
    std::vector<Species> species_;
    std::int64_t atoms_ = 0;
    std::uint64_t lineOfCell_ = 0;
};

}  // namespace

Molecule readPoscar(const std::string& name, std::string_view text, const ReadOptions& options) {
    return PoscarReader(name, text, options).run();
}

}  // namespace nacre
