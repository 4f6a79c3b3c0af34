// MOL and SDF files: splits the records and reads the header; the tables are in ctab_v2000.cpp and ctab_v3000.cpp.
#include "engine/molecule/formats/ctab.h"
#include "engine/molecule/read.h"

namespace nacre {

namespace {

/// Cuts the next record off, without its "$$$$" line.
std::string_view nextRecord(std::string_view& text) {
    std::size_t end = 0;
    while (end < text.size() && text.substr(end, 4) != "$$$$") {
        const std::size_t at = text.find("\n$$$$", end);
        end = at == std::string_view::npos ? text.size() : at + 1;
    }
    const std::string_view record = text.substr(0, end);
    text.remove_prefix(end);
    const std::size_t line = text.find('\n');
    text.remove_prefix(line == std::string_view::npos ? text.size() : line + 1);
    return record;
}

std::uint64_t countLines(std::string_view text) {
    std::uint64_t count = 0;
    for (const char c : text) count += c == '\n';
    return count;
}

struct Heading {
    std::string_view title, counts;
    bool v3000 = false;
};

Heading readHeader(LineReader& lines) {
    Heading header;
    for (int i = 0; i < 4 && lines.next(); ++i) {
        if (i == 0) header.title = trim(lines.line());
        if (i == 3) header.counts = lines.line();
    }
    header.v3000 = header.counts.find("V3000") != std::string_view::npos;
    return header;
}

/// Counts of a skipped record, for the summary: as announced, limited by its number of lines.
CtabCounts announcedCounts(std::string_view record) {
    LineReader lines(record);
    const Heading header = readHeader(lines);
    CtabCounts counts;
    if (!header.v3000) {
        counts = parseCountsV2000(header.counts).value_or(CtabCounts());
    } else {
        while (lines.next())
            if (startsWith(lines.line(), "M  V30 COUNTS")) {
                const Words words = splitWords(lines.line());
                counts = {parseInteger(words[3]).value_or(0), parseInteger(words[4]).value_or(0)};
                break;
            }
    }
    const auto most = static_cast<std::int64_t>(countLines(lines.rest())) + 1;
    if (counts.atoms < 0 || counts.bonds < 0 || counts.atoms > most || counts.bonds > most) return {};
    return counts;
}

CtabCounts readRecord(MoleculeBuilder& builder, std::string_view record, std::uint64_t firstLine) {
    LineReader lines(record, firstLine);
    const Heading header = readHeader(lines);
    if (lines.number() < firstLine + 3) cannotRead(builder.name(), "it ends before the counts line", lines.number());
    FileSummary& file = builder.molecule().file;
    file.title = printable(header.title, 200);
    file.format = header.v3000 ? "sdf-v3000" : "sdf-v2000";
    const CtabCounts counts =
        header.v3000 ? readCtabV3000(builder, lines) : readCtabV2000(builder, lines, header.counts);
    file.bonds = counts.bonds;
    std::int64_t items = 0;
    while (lines.next()) items += startsWith(lines.line(), ">");
    builder.pass("data items", items);
    return counts;
}

}  // namespace

Molecule readSdf(const std::string& name, std::string_view text, const ReadOptions& options) {
    MoleculeBuilder builder(name, options.maxAtoms);
    std::int64_t records = 0, atoms = 0, bonds = 0;
    std::uint64_t line = 1;
    // Blank text after the last "$$$$" is not a record.
    for (std::string_view rest = text; !rest.empty();) {
        const std::string_view before = rest;
        const std::string_view record = nextRecord(rest);
        if (records > 0 && rest.empty() && trim(record).empty()) break;
        const CtabCounts counts =
            ++records == options.model ? readRecord(builder, record, line) : announcedCounts(record);
        atoms += counts.atoms;
        bonds += counts.bonds;
        line += countLines(before.substr(0, before.size() - rest.size()));
    }
    if (options.model > records)
        cannotRead(name,
                   "there is no record " + std::to_string(options.model) + "; the file has " + std::to_string(records));
    FileSummary& file = builder.molecule().file;
    file.records = records;
    file.totalAtomsAllRecords = atoms;
    file.totalBondsAllRecords = bonds;
    return builder.finish();
}

}  // namespace nacre
