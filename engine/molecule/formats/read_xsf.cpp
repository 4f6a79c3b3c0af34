// XSF (XCrySDen): cell vectors and atoms, of a crystal (PRIMVEC, PRIMCOORD) or a molecule (ATOMS); animations number
// these sections. Grids of values are skipped.
#include <cmath>

#include "engine/molecule/element.h"
#include "engine/molecule/formats/molecule_builder.h"
#include "engine/molecule/text.h"

namespace nacre {

namespace {

class XsfReader {
public:
    XsfReader(const std::string& name, std::string_view text, const ReadOptions& options)
        : name_(name), lines_(text), model_(options.model), builder_(name, options.maxAtoms) {}

    Molecule run() {
        std::int64_t all = 0;
        while (next()) {
            const Words words = splitWords(lines_.line());
            const std::string keyword = upperCase(words[0]);
            if (keyword == "SLAB") repeats_ = {true, true, false};
            if (keyword == "POLYMER") repeats_ = {true, false, false};
            if (keyword == "MOLECULE") repeats_ = {false, false, false};
            if (keyword == "PRIMVEC") {
                readVectors();
            } else if (keyword == "PRIMCOORD") {
                const std::string_view counts = next() ? lines_.line() : std::string_view();
                const auto count = parseInteger(splitWords(counts)[0]);
                if (!count || *count < 1) refuse("expected a number of atoms", counts);
                all += readAtoms(*count);
            } else if (keyword == "ATOMS") {
                all += readAtoms(INT64_MAX);
            } else if (keyword.starts_with("BEGIN_BLOCK")) {
                while (next() && !upperCase(trim(lines_.line())).starts_with("END_BLOCK")) {
                }
            }
        }
        if (frames_ > 0) requireModel(name_, model_, frames_);
        FileSummary& file = builder_.molecule().file;
        file.format = "xsf";
        file.models = frames_;
        file.totalAtomsAllModels = all;
        return builder_.finish();
    }

private:
    [[noreturn]] void refuse(const std::string& why, std::string_view line) const {
        cannotRead(name_, why + ", not '" + printable(line) + "'", lines_.number());
    }
    bool next() {
        while (lines_.next())
            if (const std::string_view line = trim(lines_.line()); !line.empty() && line[0] != '#') return true;
        return false;
    }

    void readVectors() {
        std::array<glm::vec3, 3> box{};
        const std::uint64_t line = lines_.number() + 1;
        for (glm::vec3& vector : box) {
            std::string apart;
            const Words words = next() ? splitWordsApart(lines_.line(), 0, apart) : Words();
            for (std::size_t i = 0; i < 3; ++i) {
                const auto value = parseNumber(words[i]);
                if (!value || !(std::abs(*value) <= kFarthestCoordinate)) refuse("expected a cell vector", words[i]);
                vector[static_cast<int>(i)] = static_cast<float>(*value);
            }
        }
        if (frames_ < model_) builder_.takeCell(box, line, repeats_);  // a frame's own cell precedes its atoms
    }

    std::int64_t readAtoms(std::int64_t most) {
        const bool wanted = ++frames_ == model_;
        std::int64_t count = 0;
        for (LineReader ahead = lines_; count < most && ahead.next(); lines_ = ahead) {
            std::string apart;
            const Words words = splitWordsApart(ahead.line(), 1, apart);
            const auto number = [&](std::size_t i) { return parseNumber(words[i]).has_value(); };
            if (words.count < 4 || !(most < INT64_MAX || number(1) || number(2) || number(3))) break;
            ++count;
            if (!wanted) continue;
            const auto position = builder_.position({words[1], words[2], words[3]}, ahead.number());
            if (!position) continue;
            Atom atom;
            atom.position = *position;
            atom.element = builder_.element(words[0], ahead.number());
            atom.name = Name(elementSymbol(atom.element));
            builder_.addAtom(atom);
            if (words.count >= 7) builder_.pass("forces");
        }
        if (most < INT64_MAX && count < most)
            cannotRead(name_, "it states " + std::to_string(most) + " atoms and has " + std::to_string(count),
                       lines_.number());
        return count;
    }

    const std::string& name_;
    LineReader lines_;
    std::int64_t model_, frames_ = 0;
    std::array<bool, 3> repeats_{true, true, true};
    MoleculeBuilder builder_;
};

}  // namespace

Molecule readXsf(const std::string& name, std::string_view text, const ReadOptions& options) {
    return XsfReader(name, text, options).run();
}

}  // namespace nacre
