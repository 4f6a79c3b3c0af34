"""Tables of docs/measurements.md whose figures tools/measure knows: each stands below a line `<!-- measured: NAME -->`."""

import pathlib
import re

PAGE = pathlib.Path(__file__).resolve().parents[1] / "docs/measurements.md"
MARK = re.compile(r"<!-- measured: ([a-z-]+) -->")


def cells(line):
    return [cell.strip() for cell in line.strip().strip("|").split("|")]


def number(text):
    """The number of a cell, or None: "1,229", "0.40"."""
    plain = text.replace(",", "").strip()
    return float(plain) if re.fullmatch(r"\d+(\.\d+)?", plain) else None


def written(value):
    """A figure as the page has it: counts whole, measured values with two or three digits."""
    if isinstance(value, int):
        return f"{value:,}"
    if value >= 99.5:
        return f"{value:,.0f}"
    return f"{value:.1f}" if value >= 9.95 else f"{value:.2f}" if value >= 0.0995 else f"{value:.3f}"


def tables(text):
    """@returns name -> row -> column -> the cell's text. A row is called by its first cell."""
    found, lines = {}, text.splitlines()
    for at, line in enumerate(lines):
        mark = MARK.fullmatch(line)
        if not mark:
            continue
        header = cells(lines[at + 1])
        rows = found[mark[1]] = {}
        for row in lines[at + 3:]:
            if not row.startswith("|"):
                break
            name, *rest = cells(row)
            assert name not in rows, f"{mark[1]} has two rows '{name}'"
            rows[name] = dict(zip(header[1:], rest))
    return found


def figure(found, table, row, column):
    """The page's figure, or None where it has none."""
    return number(found.get(table, {}).get(row, {}).get(column, ""))


def with_rows(text, rows):
    """The page with rows that it lacks, empty: each after the last of its kind, which is its name up to the last comma, or
    at its table's end. @param rows  (table, row)"""
    lines = text.splitlines()
    for table, row in rows:
        start = next((at for at, line in enumerate(lines) if (mark := MARK.fullmatch(line)) and mark[1] == table), None)
        if start is None:
            continue
        end = next((at for at in range(start + 1, len(lines)) if not lines[at].startswith("|")), len(lines))
        names = [cells(line)[0] for line in lines[start + 3:end]]
        if row not in names:
            alike = [at for at, name in enumerate(names) if name.rpartition(", ")[0] == row.rpartition(", ")[0]]
            lines.insert(start + 4 + alike[-1] if alike else end, f"| {row} |" + " |" * (len(cells(lines[start + 1])) - 1))
    return "\n".join(lines) + "\n"


def with_figures(text, figures):
    """The page with new numbers in its cells. @param figures  (table, row, column) -> value"""
    lines, table, header = with_rows(text, dict.fromkeys(key[:2] for key in figures)).splitlines(), None, None
    for at, line in enumerate(lines):
        if mark := MARK.fullmatch(line):
            table, header = mark[1], cells(lines[at + 1])
        elif not line.startswith("|"):
            table = None
        elif table and not re.match(r"\|-", line):
            row = cells(line)
            new = [figures.get((table, row[0], column)) for column in header]
            shown = [cell if value is None else written(value) for cell, value in zip(row, new)]
            lines[at] = "|" + "".join(f" {cell} |" if cell else " |" for cell in shown)
    return "\n".join(lines) + "\n"
