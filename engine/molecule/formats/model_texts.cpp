#include "engine/molecule/formats/model_texts.h"

#include <algorithm>
#include <cstddef>
#include <optional>

#include "engine/molecule/text.h"

namespace nacre {
namespace {

/// Walks through a text by its lines, and cuts it between them.
class Cutter {
public:
    explicit Cutter(std::string_view text) : text_(text), rest_(text) {}

    bool atEnd() const { return rest_.empty(); }
    std::string_view line() const { return rest_.substr(0, rest_.find('\n')); }
    void pass() { rest_.remove_prefix(std::min(line().size() + 1, rest_.size())); }
    /// Steps over lines; false if there are fewer.
    bool pass(std::int64_t lines) {
        for (; lines > 0 && !atEnd(); --lines) pass();
        return lines == 0;
    }
    std::size_t place() const { return text_.size() - rest_.size(); }
    std::string_view since(std::size_t begin) const { return text_.substr(begin, place() - begin); }
    std::string_view rest() const { return rest_; }

private:
    std::string_view text_, rest_;
};

bool isAtom(std::string_view line) { return startsWith(line, "ATOM") || startsWith(line, "HETATM"); }
bool isModel(std::string_view line) { return line == "MODEL" || startsWith(line, "MODEL "); }
bool isEnd(std::string_view line) { return startsWith(line, "END") && trim(line) == "END"; }

/// Frames that END divides. What stands before the first atom is every frame's.
ModelTexts framesOfPdb(std::string_view text) {
    // Which structure these speak of is for the reader of the whole to say.
    for (const char* record : {"\nHELIX ", "\nSHEET ", "\nCONECT"})
        if (text.find(record) != std::string_view::npos) return {};
    ModelTexts texts;
    Cutter cut(text);
    while (!cut.atEnd() && !isAtom(cut.line())) cut.pass();
    texts.before = cut.since(0);
    while (!cut.atEnd()) {
        const std::size_t begin = cut.place();
        bool atoms = false;
        for (bool end = false; !cut.atEnd() && !end; cut.pass()) {
            atoms = atoms || isAtom(cut.line());
            end = isEnd(cut.line());
        }
        if (atoms) texts.models.push_back(cut.since(begin));
    }
    return texts;
}

/// Models between MODEL and ENDMDL, one after the other. What stands around them is every model's.
ModelTexts modelsOfPdb(std::string_view text) {
    ModelTexts texts;
    Cutter cut(text);
    for (; !cut.atEnd() && !isModel(cut.line()); cut.pass())
        if (isAtom(cut.line())) return {};
    texts.before = cut.since(0);
    std::size_t end = cut.place();
    while (!cut.atEnd() && isModel(cut.line())) {
        const std::size_t begin = cut.place();
        bool atoms = false;
        for (cut.pass(); !cut.atEnd() && !startsWith(cut.line(), "ENDMDL"); cut.pass()) {
            if (isModel(cut.line())) return {};
            atoms = atoms || isAtom(cut.line());
        }
        cut.pass();
        if (atoms) texts.models.push_back(cut.since(begin));
        end = cut.place();
        while (!cut.atEnd() && trim(cut.line()).empty()) cut.pass();
    }
    texts.after = text.substr(end);
    for (; !cut.atEnd(); cut.pass())
        if (isAtom(cut.line()) || isModel(cut.line())) return {};
    return texts;
}

bool isCount(std::string_view line) {
    const std::string_view text = trim(line);
    return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

ModelTexts framesOfXyz(std::string_view text) {
    ModelTexts texts;
    for (Cutter cut(text); !cut.atEnd();) {
        const std::size_t begin = cut.place();
        while (!cut.atEnd() && trim(cut.line()).empty()) cut.pass();
        if (!isCount(cut.line())) break;
        const auto count = parseInteger(cut.line());
        if (!count || *count > static_cast<std::int64_t>(text.size())) break;
        if (!cut.pass(2 + *count)) break;
        texts.models.push_back(cut.since(begin));
    }
    return texts;
}

ModelTexts framesOfGro(std::string_view text) {
    ModelTexts texts;
    for (Cutter cut(text); !trim(cut.rest()).empty();) {
        const std::size_t begin = cut.place();
        cut.pass();
        if (!isCount(cut.line())) break;
        const auto count = parseInteger(cut.line());
        if (!count || *count > static_cast<std::int64_t>(text.size())) break;
        if (!cut.pass(1 + *count)) break;
        cut.pass();  // the box, which the last frame may lack
        texts.models.push_back(cut.since(begin));
    }
    return texts;
}

ModelTexts recordsOfSdf(std::string_view text) {
    ModelTexts texts;
    for (Cutter cut(text); !cut.atEnd();) {
        const std::size_t begin = cut.place();
        while (!cut.atEnd() && !startsWith(cut.line(), "$$$$")) cut.pass();
        cut.pass();
        if (!cut.atEnd() || !trim(cut.since(begin)).empty()) texts.models.push_back(cut.since(begin));
    }
    return texts;
}

ModelTexts recordsOfMol2(std::string_view text) {
    const auto begins = [](std::string_view line) {
        constexpr std::string_view kMark = "@<TRIPOS>";
        return startsWith(line, kMark) && trim(line.substr(kMark.size())) == "MOLECULE";
    };
    ModelTexts texts;
    Cutter cut(text);
    while (!cut.atEnd() && !begins(cut.line())) cut.pass();
    while (!cut.atEnd()) {
        const std::size_t begin = cut.place();
        do cut.pass();
        while (!cut.atEnd() && !begins(cut.line()));
        texts.models.push_back(cut.since(begin));
    }
    return texts;
}

}  // namespace

ModelTexts modelTexts(Format format, std::string_view text) {
    switch (format) {
        case Format::pdb:
        case Format::pdbqt:
        case Format::pqr: {
            const bool models = startsWith(text, "MODEL") || text.find("\nMODEL") != std::string_view::npos;
            return models ? modelsOfPdb(text) : framesOfPdb(text);
        }
        case Format::xyz:
            return framesOfXyz(text);
        case Format::gro:
            return framesOfGro(text);
        case Format::sdf:
            return recordsOfSdf(text);
        case Format::mol2:
            return recordsOfMol2(text);
        default:
            return {};
    }
}

}  // namespace nacre
