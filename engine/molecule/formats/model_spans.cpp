#include "engine/molecule/formats/model_spans.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>

#include "engine/molecule/formats/mmcif_model.h"
#include "engine/molecule/formats/text_cutter.h"
#include "engine/molecule/text.h"

namespace nacre {
namespace {

bool isAtom(std::string_view line) { return startsWith(line, "ATOM") || startsWith(line, "HETATM"); }
bool isModel(std::string_view line) { return line == "MODEL" || startsWith(line, "MODEL "); }
bool isEnd(std::string_view line) { return startsWith(line, "END") && trim(line) == "END"; }

/// Frames separated by END. Text before the first atom belongs to every frame.
ModelSpans framesOfPdb(const TextSource& text) {
    ModelSpans spans;
    TextCutter cut(text);
    // The reader of the whole text decides to which structure these belong.
    const auto speaksOfOne = [&] {
        const std::string_view line = cut.line();
        return startsWith(line, "HELIX ") || startsWith(line, "SHEET ") || startsWith(line, "CONECT") || isModel(line);
    };
    for (; !cut.atEnd() && !isAtom(cut.line()); cut.pass())
        if (speaksOfOne()) return {};
    spans.before = cut.since(0);
    while (!cut.atEnd()) {
        const std::uint64_t begin = cut.place();
        bool atoms = false;
        for (bool end = false; !cut.atEnd() && !end; cut.pass()) {
            if (speaksOfOne()) return {};
            atoms = atoms || isAtom(cut.line());
            end = isEnd(cut.line());
        }
        if (atoms) spans.models.push_back(cut.since(begin));
    }
    return spans;
}

/// Models between MODEL and ENDMDL in order. Text around them belongs to every model, except bonds if the models have
/// different atoms: only the reader of the whole text can assign those.
ModelSpans modelsOfPdb(const TextSource& text) {
    ModelSpans spans;
    TextCutter cut(text);
    std::size_t identity = 0, identityOfFirst = 0;
    bool differ = false;
    for (; !cut.atEnd() && !isModel(cut.line()); cut.pass())
        if (isAtom(cut.line())) return {};
    spans.before = cut.since(0);
    std::uint64_t end = cut.place();
    while (!cut.atEnd() && isModel(cut.line())) {
        const std::uint64_t begin = cut.place();
        bool atoms = false;
        for (cut.pass(); !cut.atEnd() && !startsWith(cut.line(), "ENDMDL"); cut.pass()) {
            if (isModel(cut.line())) return {};
            if (!isAtom(cut.line())) continue;
            atoms = true;
            constexpr std::size_t kSerial = 6, kIdentity = 21;  // number, name and residue
            identity = identity * 31 + std::hash<std::string_view>()(columns(cut.line(), kSerial, kIdentity));
        }
        cut.pass();
        if (atoms) spans.models.push_back(cut.since(begin));
        if (spans.models.size() == 1) identityOfFirst = identity;
        differ = differ || identity != identityOfFirst;
        identity = 0;
        end = cut.place();
        while (!cut.atEnd() && trim(cut.line()).empty()) cut.pass();
    }
    spans.after = {end, text.size};
    for (; !cut.atEnd(); cut.pass())
        if (isAtom(cut.line()) || isModel(cut.line()) || (differ && startsWith(cut.line(), "CONECT"))) return {};
    return spans;
}

/// Whether MODEL comes before any atom.
bool hasModels(const TextSource& text) {
    TextCutter cut(text);
    while (!cut.atEnd() && !isAtom(cut.line()) && !isModel(cut.line())) cut.pass();
    return !cut.atEnd() && isModel(cut.line());
}

bool isCount(std::string_view line) {
    const std::string_view text = trim(line);
    return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

/// Whether only blank lines are left.
bool isBlankFrom(TextCutter cut) {
    while (!cut.atEnd() && trim(cut.line()).empty()) cut.pass();
    return cut.atEnd();
}

/// Frames that announce their number of atoms. @param toCount  advances to that number; false: no frame follows
/// @param before, after  lines between the number and the atoms, and after them; the last frame may lack the latter
template <typename ToCount>
ModelSpans countedFrames(const TextSource& text, const ToCount& toCount, std::int64_t before, std::int64_t after) {
    ModelSpans spans;
    for (TextCutter cut(text); !cut.atEnd();) {
        const std::uint64_t begin = cut.place();
        if (!toCount(cut)) break;
        spans.complete = false;  // unless a frame follows
        if (!isCount(cut.line())) break;
        const auto count = parseInteger(cut.line());
        if (!count || *count > static_cast<std::int64_t>(text.size)) break;
        if (!cut.pass(before + *count)) break;
        cut.pass(after);
        spans.complete = true;
        spans.models.push_back(cut.since(begin));
    }
    return spans;
}

/// Records that begin with a line of their own. Text before the first belongs to none.
template <typename Begins>
ModelSpans spansByFirstLine(const TextSource& text, const Begins& begins) {
    ModelSpans spans;
    TextCutter cut(text);
    while (!cut.atEnd() && !begins(cut.line())) cut.pass();
    while (!cut.atEnd()) {
        const std::uint64_t begin = cut.place();
        do cut.pass();
        while (!cut.atEnd() && !begins(cut.line()));
        spans.models.push_back(cut.since(begin));
    }
    return spans;
}

/// Number of words in a row of a CIF loop, and one of them. 0 if a quote is not closed on the line.
std::size_t wordsOfRow(std::string_view row, std::size_t wanted, std::string_view& word) {
    std::size_t count = 0, at = 0;
    const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
    for (;;) {
        while (at < row.size() && blank(row[at])) ++at;
        if (at == row.size()) return count;
        const std::size_t begin = at;
        if (const char quote = row[at]; quote == '\'' || quote == '"') {
            do at = row.find(quote, at + 1);
            while (at != std::string_view::npos && at + 1 < row.size() && !blank(row[at + 1]));
            if (at == std::string_view::npos) return 0;
            ++at;
        } else {
            while (at < row.size() && !blank(row[at])) ++at;
        }
        if (count++ == wanted) word = row.substr(begin, at - begin);
    }
}

/// Whether later rows belong to further models, judged by samples of a long text.
bool mayHaveModels(const TextSource& text, const TextCutter& cut, std::size_t columns, std::size_t number) {
    constexpr std::uint64_t kShort = std::uint64_t{4} << 20, kSample = 4096, kSamples = 16;
    std::string_view first, word;
    if (text.size < kShort || wordsOfRow(cut.line(), number, first) != columns) return true;
    for (std::uint64_t i = 1; i < kSamples; ++i) {
        std::string piece;
        const std::uint64_t at = cut.place() + (text.size - cut.place()) / kSamples * i;
        appendText(piece, text, {at, std::min(at + kSample, text.size)});
        const std::size_t begin = piece.find('\n') + 1, end = piece.find('\n', begin);
        if (begin == 0 || end == std::string::npos) continue;
        const std::string_view row = std::string_view(piece).substr(begin, end - begin);
        if (wordsOfRow(row, number, word) == columns && word != first) return true;
    }
    return false;
}

}  // namespace

ModelSpans pdbSpans(const TextSource& text) { return hasModels(text) ? modelsOfPdb(text) : framesOfPdb(text); }

ModelSpans xyzSpans(const TextSource& text) {
    const auto toCount = [](TextCutter& cut) {
        while (!cut.atEnd() && trim(cut.line()).empty()) cut.pass();
        return !cut.atEnd();
    };
    return countedFrames(text, toCount, 2, 0);
}

ModelSpans groSpans(const TextSource& text) {
    const auto toCount = [](TextCutter& cut) {
        if (trim(cut.line()).empty() && isBlankFrom(cut)) return false;  // a title may be blank
        cut.pass();
        return true;
    };
    return countedFrames(text, toCount, 1, 1);
}

ModelSpans sdfSpans(const TextSource& text) {
    ModelSpans spans;
    for (TextCutter cut(text); !cut.atEnd();) {
        const std::uint64_t begin = cut.place();
        bool blank = true;
        for (; !cut.atEnd() && !startsWith(cut.line(), "$$$$"); cut.pass()) blank = blank && trim(cut.line()).empty();
        blank = blank && cut.atEnd();
        cut.pass();
        if (!blank) spans.models.push_back(cut.since(begin));
    }
    return spans;
}

ModelSpans mol2Spans(const TextSource& text) {
    return spansByFirstLine(text, [](std::string_view line) {
        constexpr std::string_view kMark = "@<TRIPOS>";
        return startsWith(line, kMark) && trim(line.substr(kMark.size())) == "MOLECULE";
    });
}

ModelSpans dumpSpans(const TextSource& text) {
    return spansByFirstLine(text, [](std::string_view line) { return startsWith(line, "ITEM: TIMESTEP"); });
}

ModelSpans maeSpans(const TextSource& text) {
    return spansByFirstLine(text, [](std::string_view line) { return startsWith(line, "f_m_ct"); });
}

/// Rows of the only _atom_site, one per line, by model number.
ModelSpans mmcifSpans(const TextSource& text) {
    ModelSpans spans;
    TextCutter cut(text);
    const auto tag = [&](std::string_view name) {
        return lowerCase(trim(cut.line())) == "_atom_site." + lowerCase(name);
    };
    const auto isTag = [&] { return startsWith(lowerCase(cut.line().substr(0, 11)), "_atom_site."); };
    // Models of a packed scene form one scene.
    const auto isPacked = [&] { return startsWith(cut.line(), kModelOfCopies); };
    for (; !cut.atEnd() && !isTag(); cut.pass())
        if (isPacked()) return {};
    std::size_t columns = 0, number = std::string_view::npos;
    for (; !cut.atEnd() && isTag(); cut.pass(), ++columns)
        if (tag("pdbx_PDB_model_num")) number = columns;
    if (number == std::string_view::npos) return {};
    spans.before = cut.since(0);
    if (!mayHaveModels(text, cut, columns, number)) return {};
    std::vector<std::string> seen;
    std::uint64_t begin = cut.place();
    for (; !cut.atEnd(); cut.pass()) {
        const std::string_view row = cut.line();
        if (trim(row).empty() || row[0] == '#' || row[0] == '_' || startsWith(row, "loop_") || startsWith(row, "data_"))
            break;
        std::string_view word;
        if (row[0] == ';' || wordsOfRow(row, number, word) != columns) return {};
        if (!seen.empty() && word == seen.back()) continue;
        if (std::find(seen.begin(), seen.end(), word) != seen.end()) return {};
        if (!seen.empty()) spans.models.push_back(cut.since(begin));
        begin = cut.place();
        seen.emplace_back(word);
    }
    if (!seen.empty()) spans.models.push_back(cut.since(begin));
    spans.after = {cut.place(), text.size};
    for (; !cut.atEnd(); cut.pass())
        if (isTag() || isPacked()) return {};
    return spans;
}

}  // namespace nacre
