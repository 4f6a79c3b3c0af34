#pragma once
// A text of many models, cut so that each can be read alone.

#include <vector>

#include "engine/molecule/formats/text_source.h"
#include "engine/molecule/read.h"

namespace nacre {

/// `before`, one of the models, and `after` are a text of that model alone. No models: the text is not cut.
struct ModelTexts {
    TextSpan before, after;
    std::vector<TextSpan> models;
    bool complete = true;  ///< nothing else that a reader might take for a model stands in the text
};

/// Cuts what is written as programs write it: MODEL and ENDMDL, or END between whole frames (PDB, PDBQT, PQR), rows of
/// _atom_site by their pdbx_PDB_model_num, a line each (mmCIF), records (SDF, MOL2), frames (XYZ, GRO). Looks at no
/// other syntax, so that whoever reads a part has to check that it holds one model, and that there are as many as a
/// reader finds. One pass, by pieces of the text.
ModelTexts modelTexts(Format format, const TextSource& text);

}  // namespace nacre
