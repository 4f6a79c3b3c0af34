#include "engine/molecule/formats/mmcif_model_texts.h"

#include <algorithm>
#include <cstddef>
#include <optional>

#include "engine/molecule/text.h"

namespace nacre {
namespace {

/// The line at the begin of a text, without its end.
std::string_view firstLine(std::string_view text) { return text.substr(0, text.find('\n')); }

void dropLine(std::string_view& text, std::string_view line) {
    text.remove_prefix(line.size() < text.size() ? line.size() + 1 : line.size());
}

/// Cuts the next value off; a quote ends one only before a blank. Empty at the end of the line.
std::string_view nextValue(std::string_view& line) {
    constexpr std::string_view kBlanks = " \t";
    line.remove_prefix(std::min(line.find_first_not_of(kBlanks), line.size()));
    if (line.empty()) return {};
    std::size_t end = line.find_first_of(kBlanks);
    if (line[0] == '\'' || line[0] == '"') {
        std::size_t quote = line.find(line[0], 1);
        while (quote + 1 < line.size() && kBlanks.find(line[quote + 1]) == std::string_view::npos)
            quote = line.find(line[0], quote + 1);
        end = quote == std::string_view::npos ? quote : quote + 1;
    }
    const std::string_view value = line.substr(0, end);
    line.remove_prefix(value.size());
    return value;
}

/// The value of a column of a row; empty if the row has not as many as there are columns.
std::string_view valueOf(std::string_view row, std::size_t column, std::size_t columns) {
    std::string_view wanted;
    std::size_t count = 0;
    for (std::string_view value = nextValue(row); !value.empty(); value = nextValue(row))
        if (count++ == column) wanted = value;
    return count == columns ? wanted : std::string_view();
}

bool endsRows(std::string_view line) {
    return line.empty() || line[0] == '#' || line[0] == '_' || startsWith(line, "loop_") || startsWith(line, "data_");
}

}  // namespace

MmcifModelTexts mmcifModelTexts(std::string_view text) {
    constexpr std::string_view kBegin = "\nloop_\n_atom_site.";
    const std::size_t begin = text.find(kBegin);
    if (begin == std::string_view::npos) return {};
    std::string_view rest = text.substr(begin + 7);  // at the first tag
    std::size_t columns = 0;
    std::optional<std::size_t> model;
    for (std::string_view line = firstLine(rest); startsWith(line, "_atom_site."); line = firstLine(rest)) {
        if (trim(line) == "_atom_site.pdbx_PDB_model_num") model = columns;
        ++columns;
        dropLine(rest, line);
    }
    if (!model) return {};
    MmcifModelTexts texts;
    texts.before = text.substr(0, text.size() - rest.size());
    std::string_view latest;
    while (!rest.empty()) {
        const std::string_view row = firstLine(rest), all = rest;
        if (endsRows(row)) break;
        const std::string_view number = valueOf(row, *model, columns);
        if (number.empty() || row[0] == ';') return {};
        dropLine(rest, row);
        const std::size_t taken = all.size() - rest.size();
        if (texts.models.empty() || number != latest)
            texts.models.push_back(all.substr(0, taken));
        else
            texts.models.back() = {texts.models.back().data(), texts.models.back().size() + taken};
        latest = number;
    }
    texts.after = rest;
    return texts;
}

}  // namespace nacre
