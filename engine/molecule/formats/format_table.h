#pragma once
// The formats that are read: a row each, from which names, messages, endings and the call of the reader come.

#include <span>
#include <string_view>
#include <vector>

#include "engine/molecule/formats/model_spans.h"
#include "engine/molecule/molecule.h"
#include "engine/molecule/read.h"

namespace nacre {

struct FormatRow {
    Format format;
    std::string_view name;     ///< as `--format` takes it
    std::string_view title;    ///< as people call it
    std::string_view endings;  ///< of file names, with blanks between them
    bool binary = false;
    /// The reader: of one model, or where models stand in common tables of those up to the last one.
    Molecule (*read)(const std::string& name, std::string_view text, const ReadOptions&) = nullptr;
    std::vector<Molecule> (*readTables)(const std::string& name, std::string_view bytes, const ReadOptions&,
                                        int lastModel) = nullptr;
    ModelSpans (*spans)(const TextSource& text) = nullptr;  ///< null: a text of this format is not cut
};

std::span<const FormatRow> formatRows();
const FormatRow& formatRow(Format format);

}  // namespace nacre
