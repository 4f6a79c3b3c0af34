// The legend: the meaning of colours.

#include <algorithm>
#include <span>

#include "app/annotation/room.h"
#include "app/picture/option_text.h"
#include "app/picture/options.h"
#include "engine/scene/color/palettes.h"

namespace nacre::app {
namespace {

struct LegendRow {
    std::string text;
    std::uint32_t color = 0;  // 0: a heading
    bool gapBefore = false;
    const Legend* ramp = nullptr;
    std::size_t stop = 0;  // ramp stop, from the top
};

std::string makeHeading(const Legend& legend) {
    if (!legend.title.empty()) return legend.title;
    const std::string scheme = legend.scheme.substr(0, legend.scheme.find(':'));
    std::string heading;
    for (const Option::Control::Choice& choice : option("color").control.choices)
        if (choice.value == scheme) heading = choice.heading;
    if (heading.empty() && !scheme.empty() && scheme[0] != '#') {
        heading = scheme;
        if (heading[0] >= 'a' && heading[0] <= 'z') heading[0] = static_cast<char>(heading[0] - 'a' + 'A');
    }
    if (legend.selection == "all") return heading;
    return heading.empty() ? "" : heading + ", " + selectionWords(legend.selection);
}

/// Escapes a text of the program or the file for markup.
std::string escaped(const std::string& text) {
    std::string safe;
    for (const char c : text) {
        if (c == '_' || c == '^' || c == '\\') safe += '\\';
        safe += c;
    }
    return safe;
}

/// Headings and entries of all legends, one below the other.
std::vector<LegendRow> makeRows(const std::vector<Legend>& legends) {
    std::vector<LegendRow> rows;
    for (const Legend& legend : legends) {
        // A single colour of all other atoms needs no name if there are more legends.
        if (legends.size() > 1 && legend.selection == "all" && legend.scheme.starts_with('#')) continue;
        const std::string heading = makeHeading(legend);
        const bool titled = !legend.title.empty();  // with markup of its own
        if (!heading.empty()) rows.push_back({titled ? heading : escaped(heading), 0, !rows.empty()});
        // A single colour is labelled with the atoms that have it.
        const bool named = legend.entries.size() == 1 && heading.empty() && legend.selection != "all";
        for (std::size_t i = 0; i < legend.entries.size(); ++i) {
            // High values on top, as on an axis.
            const bool ramp = i < legend.stops;
            const LegendEntry& entry = legend.entries[ramp ? legend.stops - 1 - i : i];
            const bool first = !rows.empty() && i == 0 && heading.empty();
            const bool inside = ramp && i > 0 && i + 1 < legend.stops;  // only the ends are named
            rows.push_back({inside ? "" : escaped(named ? selectionWords(legend.selection) : entry.label), entry.color,
                            first, ramp ? &legend : nullptr, i});
        }
    }
    return rows;
}

/// A row's swatch: a disc, or its part of a ramp, centred on the row.
void legendSwatch(Room& room, const LegendRow& row, const glm::dvec2& middle, double radius, double line) {
    if (!row.ramp) {
        room.marks.discs.push_back({middle, radius, row.color});
        return;
    }
    RampMark ramp{middle - glm::dvec2(radius, line / 2), middle + glm::dvec2(radius, line / 2), {}};
    const double last = static_cast<double>(row.ramp->stops - 1), stop = static_cast<double>(row.stop);
    for (int k = 0; k <= 8; ++k) ramp.colors.push_back(paletteColor(row.ramp->ramp, 1 - (stop - 0.5 + k / 8.0) / last));
    room.marks.ramps.push_back(std::move(ramp));
}

/// Arrangement of rows in columns.
struct Columns {
    double size, line;
    std::size_t perColumn;
    std::vector<double> widths;  ///< of columns, from the left

    double width() const {
        double all = 0;
        for (const double column : widths) all += column + 1.2 * size;
        return all;
    }
};

/// The first rows; the last of them states how many others there are.
std::vector<LegendRow> truncateRows(const std::vector<LegendRow>& rows, std::size_t count) {
    std::vector<LegendRow> first(rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(count - 1));
    first.push_back({"and " + std::to_string(rows.size() - first.size()) + " more"});
    return first;
}

double computeIndent(double size) { return 1.25 * size; }

Columns layOutColumns(const Room& room, const std::vector<LegendRow>& rows, double size, double height) {
    Columns columns{size, 1.42 * size, 0, {}};
    columns.perColumn = static_cast<std::size_t>(std::max(3.0, height / columns.line - 1));
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (i % columns.perColumn == 0) columns.widths.push_back(0);
        double& width = columns.widths.back();
        width = std::max(width, room.widthOfRuns(rows[i].text, size) + (rows[i].color ? computeIndent(size) : 0));
    }
    return columns;
}

}  // namespace

/// Many rows become smaller and use columns, as long as most of the picture is left for the molecule; then the last
/// ones are omitted.
void layLegends(Room& room, const std::vector<Legend>& legends) {
    constexpr double kMostShare = 0.34, kSizes[] = {0.92, 0.8, 0.7};  // of the picture's width; of the text's size
    const std::vector<LegendRow> all = makeRows(legends);
    if (all.empty()) return;
    std::vector<LegendRow> rows = all;
    const double top = room.margin + room.titleDepth;
    const double height = room.view.height - room.margin - 2.6 * room.size - top;
    Columns columns{};
    for (const double share : kSizes) {
        columns = layOutColumns(room, rows, share * room.size, height);
        if (columns.widths.size() == 1 || columns.width() <= kMostShare * room.view.width) break;
    }
    while (columns.widths.size() > 1 && columns.width() > kMostShare * room.view.width) {
        rows = truncateRows(all, (columns.widths.size() - 1) * columns.perColumn);
        columns = layOutColumns(room, rows, columns.size, height);
    }
    const double size = columns.size, line = columns.line, swatch = 0.36 * size, indent = computeIndent(size);
    double right = room.view.width - room.margin;
    for (std::size_t column = columns.widths.size(); column-- > 0;) {
        const std::size_t first = column * columns.perColumn;
        const auto part = std::span(rows).subspan(first).first(std::min(columns.perColumn, rows.size() - first));
        const double left = right - columns.widths[column];
        double y = top;
        for (const LegendRow& row : part) {
            if (row.gapBefore && &row != part.data()) y += 0.7 * line;
            const double baseline = y + kRise * size;
            room.put(row.text, {left + (row.color ? indent : 0), baseline}, size);
            if (row.color) legendSwatch(room, row, {left + swatch, baseline - kMiddle * size}, swatch, line);
            y += line;
        }
        room.marks.backs.push_back({{left - 0.5 * size, top - 0.3 * size}, {right + 0.5 * size, y + 0.1 * size}});
        room.taken.push_back({{left - 0.3 * size, top}, {right, y}});
        right = left - 1.2 * size;
    }
}

}  // namespace nacre::app
