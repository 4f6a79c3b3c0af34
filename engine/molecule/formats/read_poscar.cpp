// VASP's POSCAR, CONTCAR and XDATCAR: a title, a scale, three cell vectors, symbols and counts of the species, then
// positions; an XDATCAR goes on with further configurations.
#include <cmath>
#include <glm/geometric.hpp>

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
        readCell();
        readSpecies(title);
        std::int64_t frames = 0;
        do {
            ++frames;
            readFrame(frames == model_);
        } while (skipToConfiguration());
        requireModel(name_, model_, frames);
        file.format = "poscar";
        file.models = frames;
        file.totalAtomsAllModels = frames * atoms_;
        return builder_.finish();
    }

private:
    std::string_view next() {
        if (!lines_.next()) cannotRead(name_, "it ends before its atoms", lines_.number());
        return lines_.line();
    }

    glm::dvec3 three(std::string_view line) const {
        const Words words = splitWords(line);
        glm::dvec3 values;
        for (std::size_t i = 0; i < 3; ++i) {
            const auto value = parseNumber(words[i]);
            if (!value || !(std::abs(*value) <= kFarthestCoordinate))
                cannotRead(name_, "expected three numbers, not '" + printable(line) + "'", lines_.number());
            values[static_cast<int>(i)] = *value;
        }
        return values;
    }

    /// A negative scale is the cell's volume; there may be one scale per axis.
    void readCell() {
        const std::string_view scales = next();
        const auto scale = parseNumber(splitWords(scales)[0]);
        if (!scale) cannotRead(name_, "expected a scale, not '" + printable(scales) + "'", lines_.number());
        scale_ = splitWords(scales).count == 3 ? three(scales) : glm::dvec3(*scale);
        for (glm::dvec3& vector : cell_) vector = three(next());
        const double volume = std::abs(glm::dot(cell_[0], glm::cross(cell_[1], cell_[2])));
        if (*scale < 0 && volume > 0) scale_ = glm::dvec3(std::cbrt(-*scale / volume));
        for (glm::dvec3& vector : cell_) vector *= scale_;
        builder_.takeCell({glm::vec3(cell_[0]), glm::vec3(cell_[1]), glm::vec3(cell_[2])});
    }

    /// Symbols stand before the counts; old files have them in the title at best. "Fe_pv" and "Fe/1a2b" name a
    /// potential.
    void readSpecies(std::string_view title) {
        std::vector<std::string_view> symbols = wordsOf(next()), counts = symbols;
        if (!symbols.empty() && parseInteger(symbols[0]))
            symbols = wordsOf(title);
        else
            counts = wordsOf(next());
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
        std::string_view mode = trim(next());
        if (!mode.empty() && upperCase(mode[0]) == 'S') mode = trim(next());  // selective dynamics
        const bool cartesian = !mode.empty() && (upperCase(mode[0]) == 'C' || upperCase(mode[0]) == 'K');
        for (const Species& species : species_)
            for (std::int64_t i = 0; i < species.count; ++i) {
                const std::string_view line = next();
                if (!wanted) continue;
                const glm::dvec3 p = three(line);
                Atom atom;
                atom.position = glm::vec3(cartesian ? p * scale_ : cell_[0] * p.x + cell_[1] * p.y + cell_[2] * p.z);
                atom.element = species.element;
                atom.name = Name(elementSymbol(species.element));
                builder_.addAtom(atom);
            }
    }

    /// Velocities and the like are skipped.
    bool skipToConfiguration() {
        for (LineReader ahead = lines_; ahead.next(); lines_ = ahead)
            if (lowerCase(ahead.line()).find("configuration") != std::string::npos) return true;
        return false;
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
};

}  // namespace

Molecule readPoscar(const std::string& name, std::string_view text, const ReadOptions& options) {
    return PoscarReader(name, text, options).run();
}

}  // namespace nacre
