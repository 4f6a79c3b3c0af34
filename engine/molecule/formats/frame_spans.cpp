// Splits the frames of Tinker, VASP and XCrySDen.
#include "engine/molecule/formats/model_spans.h"
#include "engine/molecule/formats/text_cutter.h"
#include "engine/molecule/text.h"

namespace nacre {
namespace {

bool isConfiguration(std::string_view line) {
    return lowerCase(line.substr(0, 80)).find("configuration") != std::string::npos;
}

/// Number of header lines of an XDATCAR before its first configuration, and the atoms of one; empty if there is no
/// header.
struct XdatcarHeader {
    std::int64_t lines = 0, atoms = 0;
};
std::optional<XdatcarHeader> xdatcarHeader(TextCutter cut) {
    constexpr std::int64_t kMostLines = 7;
    XdatcarHeader header;
    std::string counts;
    for (; !cut.atEnd() && !isConfiguration(cut.line()); cut.pass()) {
        if (++header.lines > kMostLines) return std::nullopt;
        counts = std::string(cut.line());
    }
    if (cut.atEnd() || header.lines < kMostLines - 1) return std::nullopt;
    for (const std::string_view word : splitAllWords(counts)) {
        const auto count = parseInteger(word);
        if (!count || *count < 0 || *count > INT32_MAX) return std::nullopt;
        header.atoms += *count;
    }
    return header;
}

}  // namespace

/// Frames of a count and a title, possibly a box, and the atoms.
ModelSpans tinkerSpans(const TextSource& text) {
    ModelSpans spans;
    TextCutter cut(text);
    for (;;) {
        while (!cut.atEnd() && trim(cut.line()).empty()) cut.pass();
        if (cut.atEnd()) return spans;
        const std::uint64_t begin = cut.place();
        spans.complete = false;  // unless a frame follows
        const auto count = parseInteger(splitWords(cut.line())[0]);
        if (!count || *count < 1 || *count > static_cast<std::int64_t>(text.size)) return spans;
        cut.pass();
        const Words words = cut.atEnd() ? Words() : splitWords(cut.line());
        if (words.count == 6 && parseNumber(words[1])) cut.pass();  // an atom's second word is its name
        if (!cut.pass(*count)) return spans;
        spans.complete = true;
        spans.models.push_back(cut.since(begin));
    }
}

/// Configurations with one header for all, or one each if the cell varies.
ModelSpans poscarSpans(const TextSource& text) {
    ModelSpans spans;
    TextCutter cut(text);
    const auto header = xdatcarHeader(cut);
    if (!header) return spans;
    cut.pass(header->lines);
    spans.before = cut.since(0);
    for (std::uint64_t begin = cut.place(); !cut.atEnd(); begin = cut.place()) {
        if (!isConfiguration(cut.line())) {
            if (spans.models.size() > 1 && spans.before.size() > 0) return {};  // some have a header, some have none
            if (spans.before.size() > 0) spans.models[0].begin = 0;
            spans.before = {};
            cut.pass(header->lines);
        }
        if (cut.atEnd() || !isConfiguration(cut.line()) || !cut.pass(1 + header->atoms)) return {};
        spans.models.push_back(cut.since(begin));
        while (!cut.atEnd() && trim(cut.line()).empty()) cut.pass();
    }
    return spans;
}

/// Numbered sections of coordinates, each with its own cell or one for all.
ModelSpans xsfSpans(const TextSource& text) {
    ModelSpans spans;
    TextCutter cut(text);
    const auto keyword = [&] { return upperCase(splitWords(cut.line())[0]); };
    const auto isCell = [&] { return keyword() == "PRIMVEC"; };
    const auto isAtoms = [&] { return keyword() == "PRIMCOORD" || keyword() == "ATOMS"; };
    bool varies = false;
    for (; !cut.atEnd() && !isAtoms(); cut.pass()) {
        varies = isCell() && splitWords(cut.line()).count > 1;
        if (varies) break;
    }
    spans.before = cut.since(0);
    while (!cut.atEnd()) {
        const std::uint64_t begin = cut.place();
        do cut.pass();
        while (!cut.atEnd() && !(varies ? isCell() : isAtoms()));
        spans.models.push_back(cut.since(begin));
    }
    return spans;
}

}  // namespace nacre
