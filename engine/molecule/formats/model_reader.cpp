#include "engine/molecule/formats/model_reader.h"

#include <algorithm>
#include <utility>

#include "engine/error.h"
#include "engine/molecule/assemblies.h"
#include "engine/molecule/formats/format_table.h"
#include "engine/molecule/text.h"

namespace nacre {
namespace {

constexpr std::size_t kMaxWarnings = 32;
constexpr std::size_t kBytesOfAtom = 64;                              // with its share of residues
constexpr std::int64_t kMostRuns = 64;                                // each reads the whole file
constexpr std::uint64_t kMostBytesOfPasses = std::uint64_t{1} << 32;  // for all models read one by one

/// A reader's molecule, cleaned for the rest of the program. @param model  its number
Molecule cleaned(Molecule molecule, int model) {
    for (const ReadNote& note : molecule.notes)
        if (note.action == ReadAction::leftOut) molecule.warnings.push_back(describeNote(note));
    if (molecule.warnings.size() > kMaxWarnings) molecule.warnings.resize(kMaxWarnings);
    for (std::string& warning : molecule.warnings) warning = printable(warning, kMaxMessage);
    molecule.file.title = printable(molecule.file.title, kMaxMessage);
    for (Chain& chain : molecule.chains) chain.model = model;
    return molecule;
}

Molecule readText(const Content& content, std::string_view text, const ReadOptions& options) {
    const FormatRow& row = formatRow(content.format);
    Molecule molecule = row.readTables ? std::move(row.readTables(content.name, text, options, options.model).front())
                                       : row.read(content.name, text, options);
    return cleaned(std::move(molecule), options.model);
}

void boundPasses(const Content& content, std::int64_t passes, std::uint64_t bytes) {
    if (static_cast<std::uint64_t>(passes) > kMostBytesOfPasses / std::max<std::uint64_t>(bytes, 1))
        cannotRead(content.name, "it has too many models to read them all: " + std::to_string(passes) + " times " +
                                     std::to_string(bytes) + " bytes are more than " +
                                     std::to_string(kMostBytesOfPasses));
}

}  // namespace

std::int64_t countModels(const FileSummary& file) {
    return std::max(file.models.value_or(1), file.records.value_or(1));
}

Molecule readStated(const Content& content, const ReadOptions& options) {
    return readText(content, *content.bytes, options);
}

std::optional<Molecule> readSpan(const Content& content, const ReadOptions& options, int model) {
    const TextSpan& own = content.spans.models[static_cast<std::size_t>(model - 1)];
    if (own.size() > options.maxBytes) return std::nullopt;
    ReadOptions alone = options;
    alone.model = 1;
    alone.others = false;
    try {
        std::string text;
        text.reserve(static_cast<std::size_t>(content.spans.around() + own.size()));
        for (const TextSpan& span : {content.spans.before, own, content.spans.after})
            appendText(text, content.text, span);
        if (!content.bytes) unifyLineEnds(text);
        Molecule molecule = readText(content, text, alone);
        if (countModels(molecule.file) != 1) return std::nullopt;
        for (Chain& chain : molecule.chains) chain.model = model;
        return molecule;
    } catch (const Error&) {
        return std::nullopt;
    }
}

ModelReader::ModelReader(Content content, const ReadOptions& options, const Molecule& first, Order order)
    : content_(std::move(content)), options_(options), order_(order), count_(countModels(first.file)) {
    options_.others = false;
    if (count_ < 2) return;
    const bool tables = formatRow(content_.format).readTables && content_.bytes;
    // Tables in text: reads all models in fewer passes, or one from its own text.
    if (content_.bytes && (!tables || order == Order::any)) content_.spans = modelSpans(content_.format, content_.text);
    cut_ = content_.spans.models.size() == static_cast<std::size_t>(count_);
    if (tables && !cut_) {
        const std::size_t bytes = kBytesOfAtom * std::max<std::size_t>(first.atoms.size(), 1);
        runLength_ = static_cast<int>(std::clamp<std::int64_t>(
            std::max(static_cast<std::int64_t>(options.heldText / bytes), count_ / kMostRuns), 1, count_));
        boundPasses(content_, (count_ - 1) / runLength_ + 1, content_.text.size);
        subchains_.subchains = first.subchains;
        subchains_.assemblies = first.assemblies;
        return;
    }
    if (order == Order::all) boundPasses(content_, count_, cut_ ? content_.spans.around() : content_.text.size);
}

Molecule ModelReader::read(int model, std::size_t maxAtoms) {
    if (runLength_ > 0) {
        Molecule own = cleaned(ofRun(model), model);
        // The reader attaches assemblies to one model only.
        if (own.assemblies.empty()) own.assemblies = assembliesFor(own, subchains_);
        return own;
    }
    options_.maxAtoms = maxAtoms;
    if (!cut_) return readWhole(model);
    std::optional<Molecule> alone = readSpan(content_, options_, model);
    if (alone && !content_.bytes) return std::move(*alone);
    // A warning needs the whole text for its line; but not for every model, since each pass takes time.
    if (alone && (alone->warnings.empty() || warned_)) {
        alone->warnings.clear();
        return std::move(*alone);
    }
    if (alone) {
        warned_ = true;
    } else if (order_ == Order::all) {
        cut_ = false;  // a second failure would double the work
        boundPasses(content_, count_, content_.text.size);
    }
    return readWhole(model);
}

Molecule ModelReader::readWhole(int model) const {
    ReadOptions own = options_;
    own.model = model;
    return content_.bytes ? readStated(content_, own) : readStated(heldWhole(content_, own), own);
}

const Molecule& ModelReader::ofRun(int model) {
    const int begin = (model - 1) / runLength_ * runLength_ + 1;
    if (run_.empty() || begin != runBegin_) {
        run_.clear();  // frees memory before the next run
        options_.model = begin;
        run_ = formatRow(content_.format)
                   .readTables(content_.name, *content_.bytes, options_,
                               static_cast<int>(std::min<std::int64_t>(begin + runLength_ - 1, count_)));
        runBegin_ = begin;
    }
    return run_.at(static_cast<std::size_t>(model - begin));
}

}  // namespace nacre
