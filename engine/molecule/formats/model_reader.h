#pragma once
// How a file becomes a molecule, step by step:
//   openContent()     content.h       the file's bytes, inflated, text in one encoding; or the position of a long text
//   modelSpans()      model_spans.h   the part of a text that belongs to each model
//   formatRow()       format_table.h  the format's reader: text to Molecule, with the bonds from the file
//   ModelReader       this header     the models of a content one by one
//   perceiveBonds()   bonds.h         the other bonds
// Then, depending on the caller:
//   readMolecule()        read.h        one model, and the positions of the others (other_models.h); or all, joined
//                                       (join_models.h)
//   ModelFile             model_file.h  a file that is kept open; models are read on demand
//   trajectoryOfModels()  trajectory.h  the models as frames

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/molecule/formats/content.h"
#include "engine/molecule/molecule.h"

namespace nacre {

/// Number of models or records in the file.
std::int64_t countModels(const FileSummary& file);

/// The model selected in the options, read from the whole text, with the bonds from the file. @throws Error
Molecule readStated(const Content& content, const ReadOptions& options);

/// A model read from its own text. Empty if that has no model, several, or an error: reading the whole text then gives
/// the error and its line.
/// @param model  from 1, one of content.spans
std::optional<Molecule> readSpan(const Content& content, const ReadOptions& options, int model);

/// Reads models one by one. A format's reader takes one model and skips the others; to avoid a pass over the file for
/// each, models are read from their own text. If models share tables, a pass reads as many as fit into
/// ReadOptions::heldText, but at least a 64th of them.
class ModelReader {
public:
    enum class Order { all, any };  ///< all in order, or some in any order

    /// @param first  the first model, from readStated()
    /// @throws Error if reading all takes too many passes over the file
    ModelReader(Content content, const ReadOptions& options, const Molecule& first, Order order);

    std::int64_t count() const { return count_; }
    /// Whether a model is read without a pass over the whole text.
    bool skipsOthers() const { return cut_ || runLength_ > 0; }
    /// With the bonds from the file. @param model  from 1 @param maxAtoms  of this one @throws Error
    Molecule read(int model, std::size_t maxAtoms);

private:
    Molecule readWhole(int model) const;
    const Molecule& ofRun(int model);

    Content content_;
    ReadOptions options_;
    Order order_;
    std::int64_t count_;
    std::vector<Molecule> run_;
    int runBegin_ = 0;  ///< the first model of the run
    int runLength_ = 0;
    Molecule subchains_;  ///< subchains and assemblies of the first model, without atoms
    bool cut_ = false, warned_ = false;
};

}  // namespace nacre
