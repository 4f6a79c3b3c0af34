#pragma once
// Splits a text into its models, so that each can be read alone.

#include <vector>

#include "engine/molecule/formats/text_source.h"
#include "engine/molecule/read.h"

namespace nacre {

/// `before`, one model and `after` form a text with only that model. No models: the text is not split.
struct ModelSpans {
    TextSpan before, after;
    std::vector<TextSpan> models;
    bool complete = true;  ///< no other part of the text could be a model for a reader

    std::uint64_t around() const { return before.size() + after.size(); }  ///< bytes read with every model
};

/// Splits the usual layout of programs, without parsing other syntax. Callers must check that a part contains one
/// model, and that the number of models is right. One pass, in pieces of the text.
ModelSpans modelSpans(Format format, const TextSource& text);

/// By format: MODEL and ENDMDL, or END between whole frames (PDB, PDBQT, PQR); rows of _atom_site by their
/// pdbx_PDB_model_num, one per line (mmCIF); records (SDF, MOL2, MAE); frames (XYZ, GRO, LAMMPS dump, Tinker);
/// configurations (XDATCAR); numbered sections (XSF).
ModelSpans pdbSpans(const TextSource& text);
ModelSpans mmcifSpans(const TextSource& text);
ModelSpans sdfSpans(const TextSource& text);
ModelSpans mol2Spans(const TextSource& text);
ModelSpans xyzSpans(const TextSource& text);
ModelSpans groSpans(const TextSource& text);
ModelSpans dumpSpans(const TextSource& text);
ModelSpans maeSpans(const TextSource& text);
ModelSpans tinkerSpans(const TextSource& text);
ModelSpans poscarSpans(const TextSource& text);
ModelSpans xsfSpans(const TextSource& text);

}  // namespace nacre
