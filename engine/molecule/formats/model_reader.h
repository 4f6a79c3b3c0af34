#pragma once
// How a file becomes a molecule, and who does which step:
//
//   openContent()     content.h       the file's bytes, inflated, text in one encoding; or where a long text lies
//   modelSpans()      model_spans.h   which part of a text is which model's
//   formatRow()       format_table.h  the format's reader: text to Molecule, with the bonds that the file states
//   ModelReader       this header     the models of a content one by one
//   perceiveBonds()   bonds.h         the other bonds
//
// Then, by what is wanted:
//
//   readMolecule()        read.h        one model, and where the others are (other_models.h); or all, joined
//                                       (join_models.h)
//   ModelFile             model_file.h  a file that is kept open; each model is read when it is needed
//   trajectoryOfModels()  trajectory.h  the models as frames

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/molecule/formats/content.h"
#include "engine/molecule/molecule.h"

namespace nacre {

/// Models or records of the file that a molecule is one of.
std::int64_t modelsOf(const FileSummary& file);

/// The model that the options name, read from the whole text, with the bonds that the file states. @throws Error
Molecule readStated(const Content& content, const ReadOptions& options);

/// A model read from its own text alone. Nothing if that holds no model, several, or a fault: then the whole text tells
/// what is wrong, and in which line. @param model  from 1, one of content.spans
std::optional<Molecule> readSpan(const Content& content, const ReadOptions& options, int model);

/// A format's reader takes one model and steps over the others. So that reading all takes one pass over the file, not
/// one per model, each is read from its own text. Where models stand in common tables, as many are read in one pass as
/// take no more memory than ReadOptions::heldText, or a 64th of them.
class ModelReader {
public:
    enum class Order { all, any };  ///< all of them one after the other, or some in any order

    /// @param first  the first model, as readStated() has it
    /// @throws Error if reading all takes too many passes over the file
    ModelReader(Content content, const ReadOptions& options, const Molecule& first, Order order);

    std::int64_t count() const { return count_; }
    /// Whether a model is read without a pass over the whole text.
    bool skipsOthers() const { return cut_ || runLength_ > 0; }
    /// With the bonds that the file states. @param model  from 1 @param maxAtoms  of this one @throws Error
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
    Molecule subchains_;  ///< of the first model, with its assemblies; without atoms
    bool cut_ = false, warned_ = false;
};

}  // namespace nacre
