#pragma once
// The formats that can be read: one row each with names, file endings and reader.

#include <span>
#include <string_view>
#include <vector>

#include "engine/molecule/formats/model_spans.h"
#include "engine/molecule/molecule.h"
#include "engine/molecule/read.h"

namespace nacre {

struct FormatRow {
    Format format;
    std::string_view name;     ///< for `--format`
    std::string_view title;    ///< for people
    std::string_view endings;  ///< of file names, separated by blanks
    bool binary = false;
    /// Reads one model or, in formats whose models share tables, the models up to `lastModel`.
    Molecule (*read)(const std::string& name, std::string_view text, const ReadOptions&) = nullptr;
    std::vector<Molecule> (*readTables)(const std::string& name, std::string_view bytes, const ReadOptions&,
                                        int lastModel) = nullptr;
    ModelSpans (*spans)(const TextSource& text) = nullptr;  ///< null: models of this format are not separated
};

std::span<const FormatRow> formatRows();
const FormatRow& formatRow(Format format);

}  // namespace nacre
