#include "engine/molecule/formats/detect.h"

#include <algorithm>
#include <array>

#include "engine/molecule/formats/decompress.h"
#include "engine/molecule/formats/format_table.h"
#include "engine/molecule/text.h"

namespace nacre {

namespace {

constexpr std::size_t kHead = std::size_t{64} << 10;  // number of bytes examined

/// Result from content or name: a readable format, or a description of another one.
struct Guess {
    std::optional<Format> format;
    std::string_view other;
    explicit operator bool() const { return format || !other.empty(); }
};

Guess is(Format format) { return {format, {}}; }
Guess isNot(std::string_view words) { return {std::nullopt, words}; }

bool contains(std::string_view text, std::string_view part) { return text.find(part) != std::string_view::npos; }

Guess guessBinary(std::string_view head) {
    struct Signature {
        std::string_view bytes, words;
    };
    static constexpr Signature kSignatures[] = {{"\x89PNG", "a PNG picture, not a molecule"},
                                                {"\xff\xd8\xff", "a JPEG picture, not a molecule"},
                                                {"GIF8", "a GIF picture, not a molecule"},
                                                {"%PDF", "a PDF document, not a molecule"},
                                                {"PK\x03\x04", "a ZIP archive; unpack it first"},
                                                {"\x7f"
                                                 "ELF",
                                                 "a program, not a molecule"}};
    if (!detectCompression(head).empty()) return isNot("compressed twice; unpack it first");
    for (const Signature& signature : kSignatures)
        if (startsWith(head, signature.bytes)) return isNot(signature.words);
    if (head.substr(0, 1) == std::string_view("\0", 1) && contains(head.substr(0, 16), "VERSION "))
        return isNot("a GROMACS run input; `gmx editconf -f FILE.tpr -conect -o FILE.pdb` writes its structure");
    // NetCDF, DCD, TRR and XTC.
    const bool netcdf = startsWith(head, "CDF") && head.size() > 3 && head[3] < ' ';
    const std::string_view number = head.substr(0, std::min<std::size_t>(head.size(), 4));
    if (netcdf || head.substr(std::min<std::size_t>(head.size(), 4), 4) == "CORD" ||
        number == std::string_view("\0\0\x07\xc9", 4) || number == std::string_view("\0\0\x07\xcb", 4))
        return isNot("a trajectory; open its structure, and pass this file with --trajectory");
    if (const auto format = detectBinaryFormat(head)) return is(*format);
    return {};
}

bool isInteger(std::string_view text) {
    text = trim(text);
    return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

bool areNumbers(const Words& words, std::size_t first, std::size_t count) {
    for (std::size_t i = first; i < first + count; ++i)
        if (!parseNumber(words[i])) return false;
    return true;
}

/// A count with or without a title; then, possibly after a box, a line of number, name, position and type.
bool isTinker(std::string_view counts, std::string_view atom) {
    const Words words = splitWords(atom);
    return isInteger(splitWords(counts)[0]) && words.count >= 6 && isInteger(words[0]) && !parseNumber(words[1]) &&
           areNumbers(words, 2, 3) && isInteger(words[5]);
}

/// A scale and three vectors after the title.
bool isPoscar(const std::array<std::string_view, 6>& line) {
    const Words scale = splitWords(line[1]);
    if ((scale.count != 1 && scale.count != 3) || !parseNumber(scale[0])) return false;
    for (std::size_t i = 2; i < 5; ++i)
        if (!areNumbers(splitWords(line[i]), 0, 3)) return false;
    return splitWords(line[5]).count > 0 && splitWords(line[2]).count == 3;
}

/// A count, possibly with a time, and numbers of twelve columns.
bool isInpcrd(std::string_view counts, std::string_view numbers) {
    const Words words = splitWords(counts);
    if (words.count < 1 || words.count > 2 || !isInteger(words[0])) return false;
    if (words.count == 2 && !parseNumber(words[1])) return false;
    constexpr std::size_t kColumns = 12, kPoint = 4;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::string_view field = columns(numbers, i * kColumns, kColumns);
        if (field.size() != kColumns || field[kPoint] != '.' || !parseNumber(field)) return false;
    }
    return true;
}

/// Guesses by the first lines, where several formats have a mark at a fixed position.
Guess guessByFirstLines(std::string_view text) {
    std::array<std::string_view, 6> line{};
    LineReader lines(text);
    for (std::string_view& next : line)
        if (lines.next()) next = lines.line();
    const std::string_view mark = columns(line[3], 33, 12);
    if (contains(mark, "V2000") || contains(mark, "V3000")) return is(Format::sdf);
    const Words third = splitWords(line[2]);
    const auto numbers = [&](std::size_t first, std::size_t count) {
        for (std::size_t i = first; i < first + count; ++i)
            if (!parseNumber(third[i])) return false;
        return true;
    };
    const bool groAtom = parseInteger(columns(line[2], 0, 5)) && parseInteger(columns(line[2], 15, 5)) &&
                         parseNumber(columns(line[2], 20, 8)) && parseNumber(columns(line[2], 28, 8));
    if (isInteger(line[1]) && groAtom) return is(Format::gro);
    if (splitWords(line[0])[0] == "PSF") return is(Format::psf);
    if (startsWith(line[0], "%VERSION") || startsWith(line[0], "%FLAG")) return is(Format::prmtop);
    if (startsWith(line[0], "ITEM: ")) return is(Format::lammpstrj);
    if (startsWith(line[0], "LAMMPS")) return is(Format::lammps);
    if (isTinker(line[0], line[1]) || isTinker(line[0], line[2])) return is(Format::tinker);
    if (isPoscar(line)) return is(Format::poscar);
    if (isInpcrd(line[1], line[2])) return is(Format::inpcrd);
    if (isInteger(line[0]) && (numbers(1, 3) || contains(line[1], "Properties="))) return is(Format::xyz);
    return {};
}

bool isPdbRecord(std::string_view line) {
    static constexpr std::string_view kRecords[] = {
        "HEADER", "TITLE ", "COMPND", "SOURCE", "KEYWDS", "EXPDTA", "AUTHOR", "REVDAT", "REMARK", "SEQRES",
        "HETNAM", "HELIX ", "SHEET ", "CRYST1", "ORIGX1", "SCALE1", "MODEL ", "ATOM  ", "HETATM", "CONECT",
        "ENDMDL", "OBSLTE", "CAVEAT", "SPLIT ", "NUMMDL", "DBREF ", "SSBOND", "MASTER"};
    return std::any_of(std::begin(kRecords), std::end(kRecords), [&](auto record) { return startsWith(line, record); });
}

/// A GROMACS topology begins with comments, and then a section or a directive of its preprocessor.
bool isTop(std::string_view head) {
    std::string_view line;
    for (LineReader lines(head); (line.empty() || line.front() == ';') && lines.next();) line = trim(lines.line());
    bool begins = startsWith(line, "[");
    for (const std::string_view directive : {"#include", "#define", "#ifdef", "#ifndef"})
        begins = begins || startsWith(line, directive);
    return begins && (contains(head, "moleculetype") || contains(head, "defaults") || contains(head, ".itp\""));
}

std::size_t decimals(std::string_view number) {
    const std::size_t point = number.find('.');
    return point == std::string_view::npos || !parseNumber(number) ? 0 : number.size() - point - 1;
}

/// PQR and PDBQT resemble PDB: the last columns of an atom line decide.
Guess guessPdbFamily(std::string_view line) {
    if (!startsWith(line, "ATOM  ") && !startsWith(line, "HETATM")) return is(Format::pdb);
    const std::string_view charge = columns(line, 70, 6);
    if (charge.size() == 6 && charge[2] == '.' && parseNumber(charge) && !trim(columns(line, 77, 2)).empty())
        return is(Format::pdbqt);
    // PQR ends in x, y, z, charge and radius; PDB gives occupancy and B factor two decimals.
    const Words words = splitWords(line);
    bool pqr = words.count >= 9;
    for (std::size_t back = 1; back <= 5 && pqr; ++back)
        pqr = decimals(words[words.count - back]) >= (back <= 2 ? 3u : 1u);
    return is(pqr ? Format::pqr : Format::pdb);
}

Guess guessByLines(std::string_view head) {
    LineReader lines(head);
    bool pdb = false;
    while (lines.next()) {
        const std::string_view line = trim(lines.line());
        if (startsWith(line, "@<TRIPOS>")) return is(Format::mol2);
        if (startsWith(line, "f_m_ct")) return is(Format::mae);
        const std::string_view keyword = line.substr(0, line.find(' '));
        for (const std::string_view xsf : {"CRYSTAL", "SLAB", "POLYMER", "PRIMVEC", "ANIMSTEPS", "PRIMCOORD", "ATOMS"})
            if (keyword == xsf) return is(Format::xsf);
        if (keyword == "Atoms" || line == "Masses") return is(Format::lammps);
        if (pdb && (startsWith(line, "ROOT") || startsWith(line, "TORSDOF"))) return is(Format::pdbqt);
        const bool atom = startsWith(lines.line(), "ATOM  ") || startsWith(lines.line(), "HETATM");
        if (atom) return guessPdbFamily(lines.line());
        pdb = pdb || isPdbRecord(lines.line());
        if (line.empty() || line.front() == '#' || pdb) continue;
        const std::string start = lowerCase(line.substr(0, 16));
        if (startsWith(start, "data_") || startsWith(start, "loop_")) return is(Format::mmcif);
    }
    return pdb ? is(Format::pdb) : Guess{};
}

Guess guessByContent(std::string_view text) {
    const std::string_view head = text.substr(0, kHead);
    if (const Guess guess = guessBinary(head)) return guess;
    const std::string_view start = trim(head);
    if (startsWith(start, "{")) return is(contains(start, "s_m_m2io_version") ? Format::mae : Format::mmjson);
    if (startsWith(start, "<")) {
        const std::string lower = lowerCase(start);
        if (contains(lower, "<html") || startsWith(lower, "<!doctype html")) return isNot("a web page, not a molecule");
        if (contains(lower, "<cml") || contains(lower, "<molecule") || contains(lower, "xml-cml.org"))
            return is(Format::cml);
        if (contains(lower, "pdbx:datablock")) return isNot("pdbml");
    }
    if (isTop(head)) return is(Format::top);
    if (const Guess guess = guessByFirstLines(text)) return guess;
    return guessByLines(head);
}

/// Without the extension of the compression.
std::string_view uncompressedName(std::string_view name) {
    for (const std::string_view ending : {".gz", ".xz", ".bz2", ".zst"})
        if (name.size() > ending.size() && name.substr(name.size() - ending.size()) == ending)
            return name.substr(0, name.size() - ending.size());
    return name;
}

bool hasWord(std::string_view list, std::string_view word) {
    const std::string spaced = " " + std::string(list) + " ";
    return !word.empty() && contains(spaced, " " + std::string(word) + " ");
}

Guess guessByName(const std::string& name) {
    const std::string whole = lowerCase(name);
    const std::string_view lower = uncompressedName(whole);
    const std::size_t dot = lower.find_last_of("./\\");
    if (dot == std::string::npos || lower[dot] != '.') return {};
    const std::string_view ending = lower.substr(dot + 1);
    for (const FormatRow& row : formatRows())
        if (hasWord(row.endings, ending)) return is(row.format);
    for (const std::string_view other : {"pdbml", "dcd", "xtc", "trr", "cube"})
        if (ending == other) return isNot(other);
    return {};
}

}  // namespace

std::optional<Format> formatOfFileName(const std::string& name) { return guessByName(name).format; }

namespace {

[[noreturn]] void refuse(const std::string& name, std::string_view other) {
    const bool isFormat = other.find(' ') == std::string_view::npos;
    if (!isFormat) cannotRead(name, "it is " + std::string(other));
    cannotRead(name, "format " + std::string(other) + " is not supported; supported: " + formatNames());
}

}  // namespace

std::optional<Format> detectBinaryFormat(std::string_view bytes) {
    if (startsWith(bytes, "\xDF\x65\xDF\x65\xDF\x65\xDF\x65")) return Format::gsd;
    if (startsWith(bytes, "\x89HDF\r\n\x1a\n")) return Format::h5md;
    const auto first = bytes.empty() ? 0u : static_cast<unsigned char>(bytes.front());
    if ((first & 0xF0u) != 0x80 && first != 0xDE && first != 0xDF) return std::nullopt;  // not a MessagePack map
    const std::string_view head = bytes.substr(0, 4096);
    if (contains(head, "dataBlocks")) return Format::bcif;
    if (contains(head, "mmtfVersion") || contains(head, "CoordList")) return Format::mmtf;
    return std::nullopt;
}

Format detectFormat(const std::string& name, std::string_view text) {
    const Guess content = guessByContent(text), named = guessByName(name);
    // A name may override content that resembles PDB: PQR files have free columns.
    const bool narrowed = named.format == Format::pqr || named.format == Format::pdbqt;
    const Guess guess = content && !(content.format == Format::pdb && narrowed) ? content : named;
    if (!guess) cannotRead(name, "neither content nor name tell its format; name it (" + formatNames() + ")");
    if (!guess.format) refuse(name, guess.other);
    return *guess.format;
}

}  // namespace nacre
