#pragma once
// Which part of a text is which model's, so that each can be read alone.

#include <vector>

#include "engine/molecule/formats/text_source.h"
#include "engine/molecule/read.h"

namespace nacre {

/// `before`, one of the models, and `after` are a text of that model alone. No models: the text is not cut.
struct ModelSpans {
    TextSpan before, after;
    std::vector<TextSpan> models;
    bool complete = true;  ///< nothing else that a reader might take for a model stands in the text

    std::uint64_t around() const { return before.size() + after.size(); }  ///< bytes that every model is read with
};

/// Cuts what is written as programs write it, and looks at no other syntax: whoever reads a part has to check that it
/// holds one model, and that there are as many as a reader finds. One pass, by pieces of the text.
ModelSpans modelSpans(Format format, const TextSource& text);

/// Of each format: MODEL and ENDMDL, or END between whole frames (PDB, PDBQT, PQR); rows of _atom_site by their
/// pdbx_PDB_model_num, a line each (mmCIF); records (SDF, MOL2); frames (XYZ, GRO).
ModelSpans pdbSpans(const TextSource& text);
ModelSpans mmcifSpans(const TextSource& text);
ModelSpans sdfSpans(const TextSource& text);
ModelSpans mol2Spans(const TextSource& text);
ModelSpans xyzSpans(const TextSource& text);
ModelSpans groSpans(const TextSource& text);

}  // namespace nacre
