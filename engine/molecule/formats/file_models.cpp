#include "engine/molecule/formats/file_models.h"

#include <algorithm>
#include <utility>

#include "engine/error.h"
#include "engine/molecule/assemblies.h"
#include "engine/molecule/formats/readers.h"
#include "engine/molecule/text.h"

namespace nacre {
namespace {

constexpr std::size_t kMaxWarnings = 32;
constexpr std::size_t kMostAround = std::size_t{32} << 20;            // text that every model is read with
constexpr std::size_t kBytesOfAtom = 64;                              // with its share of residues
constexpr std::int64_t kMostRuns = 64;                                // each goes through the whole file
constexpr std::uint64_t kMostBytesOfPasses = std::uint64_t{1} << 32;  // that models read one by one take together

std::vector<Molecule> alone(Molecule molecule) {
    std::vector<Molecule> models;
    models.push_back(std::move(molecule));
    return models;
}

/// What the format's reader gives: one model or, of some formats, as many as are wanted.
std::vector<Molecule> dispatch(const std::string& name, const FileContent& content, const ReadOptions& options,
                               int lastModel) {
    const std::string_view bytes = content.bytes;
    switch (content.format) {
        case Format::pdb:
            return alone(readPdb(name, bytes, options));
        case Format::mmcif:
            return readMmcif(name, bytes, options, lastModel);
        case Format::mmjson:
            return readMmjson(name, bytes, options, lastModel);
        case Format::bcif:
            return readBcif(name, bytes, options, lastModel);
        case Format::mmtf:
            return readMmtf(name, bytes, options, lastModel);
        case Format::sdf:
            return alone(readSdf(name, bytes, options));
        case Format::xyz:
            return alone(readXyz(name, bytes, options));
        case Format::mol2:
            return alone(readMol2(name, bytes, options));
        case Format::pqr:
            return alone(readPqr(name, bytes, options));
        case Format::gro:
            return alone(readGro(name, bytes, options));
        case Format::pdbqt:
            return alone(readPdbqt(name, bytes, options));
        case Format::cml:
            return alone(readCml(name, bytes, options));
    }
    throw Error("cannot read molecule", name, "no reader for its format");
}

bool readsSeveral(Format format) {
    return format == Format::mmcif || format == Format::mmjson || format == Format::bcif || format == Format::mmtf;
}

/// A reader's molecule, fit for the rest of the program. @param model  its number
Molecule cleaned(Molecule molecule, int model) {
    if (molecule.warnings.size() > kMaxWarnings) molecule.warnings.resize(kMaxWarnings);
    for (std::string& warning : molecule.warnings) warning = printable(warning, kMaxMessage);
    molecule.file.title = printable(molecule.file.title, kMaxMessage);
    for (Chain& chain : molecule.chains) chain.model = model;
    return molecule;
}

void boundPasses(const std::string& name, std::int64_t passes, std::size_t bytes) {
    if (static_cast<std::uint64_t>(passes) > kMostBytesOfPasses / std::max<std::size_t>(bytes, 1))
        throw Error("cannot read molecule", name,
                    "it has too many models to read them all: " + std::to_string(passes) + " times " +
                        std::to_string(bytes) + " bytes are more than " + std::to_string(kMostBytesOfPasses));
}

/// The text of one model alone.
FileContent contentOfModel(const TextSource& text, const ModelTexts& texts, Format format, int model) {
    FileContent alone{{}, format};
    const TextSpan& own = texts.models[static_cast<std::size_t>(model - 1)];
    alone.bytes.reserve(static_cast<std::size_t>(texts.before.size() + own.size() + texts.after.size()));
    for (const TextSpan& span : {texts.before, own, texts.after}) appendText(alone.bytes, text, span);
    return alone;
}

}  // namespace

std::int64_t modelsOf(const FileSummary& file) { return std::max(file.models.value_or(1), file.records.value_or(1)); }

Molecule readStated(const std::string& name, const FileContent& content, const ReadOptions& options) {
    return cleaned(std::move(dispatch(name, content, options, options.model).front()), options.model);
}

FileModels::FileModels(const std::string& name, const FileContent& content, const ReadOptions& options,
                       const Molecule& first)
    : name_(name),
      content_(content),
      options_(options),
      text_(textInMemory(content.bytes)),
      count_(modelsOf(first.file)) {
    options_.others = false;
    if (count_ < 2) return;
    if (readsSeveral(content.format)) {
        const std::size_t bytes = kBytesOfAtom * std::max<std::size_t>(first.atoms.size(), 1);
        runLength_ = static_cast<int>(std::clamp<std::int64_t>(
            std::max(static_cast<std::int64_t>(options.heldText / bytes), count_ / kMostRuns), 1, count_));
        boundPasses(name, (count_ - 1) / runLength_ + 1, content.bytes.size());
        subchains_.subchains = first.subchains;
        subchains_.assemblies = first.assemblies;
        return;
    }
    texts_ = modelTexts(content.format, text_);
    cut_ = texts_.models.size() == static_cast<std::size_t>(count_);
    boundPasses(name, count_,
                cut_ ? static_cast<std::size_t>(texts_.before.size() + texts_.after.size()) : content.bytes.size());
}

Molecule FileModels::read(int model, std::size_t maxAtoms) {
    if (readsRuns()) {
        Molecule own = cleaned(ofRun(model), model);
        // The reader has the assemblies at one of them.
        if (own.assemblies.empty()) own.assemblies = assembliesFor(own, subchains_);
        return own;
    }
    options_.maxAtoms = maxAtoms;
    if (cut_)
        if (std::optional<Molecule> alone = readCut(model)) return std::move(*alone);
    options_.model = model;
    return readStated(name_, content_, options_);
}

const Molecule& FileModels::ofRun(int model) {
    const int begin = (model - 1) / runLength_ * runLength_ + 1;
    if (run_.empty() || begin != runBegin_) {
        run_.clear();  // before the others take memory
        options_.model = begin;
        run_ = dispatch(name_, content_, options_,
                        static_cast<int>(std::min<std::int64_t>(begin + runLength_ - 1, count_)));
        runBegin_ = begin;
    }
    return run_.at(static_cast<std::size_t>(model - begin));
}

/// A model from its own text. Nothing if that is otherwise than the cut has it, or if something is to be said of it,
/// since the whole text knows the line; but not of every model, since each look at the whole takes its time.
std::optional<Molecule> FileModels::readCut(int model) {
    options_.model = 1;
    try {
        Molecule molecule = readStated(name_, contentOfModel(text_, texts_, content_.format, model), options_);
        if (modelsOf(molecule.file) == 1 && (molecule.warnings.empty() || told_)) {
            molecule.warnings.clear();
            for (Chain& chain : molecule.chains) chain.model = model;
            return molecule;
        }
        told_ = told_ || !molecule.warnings.empty();
        if (modelsOf(molecule.file) == 1) return std::nullopt;
    } catch (const Error&) {
    }
    cut_ = false;  // a second time in vain would be twice the work
    boundPasses(name_, count_, content_.bytes.size());
    return std::nullopt;
}

TextModels::TextModels(const std::string& name, TextContent content, const ReadOptions& options)
    : name_(name), content_(std::move(content)), options_(options) {
    options_.model = 1;
    options_.others = false;
    texts_ = modelTexts(content_.format, content_.text);
    const auto around = static_cast<std::size_t>(texts_.before.size() + texts_.after.size());
    if (!texts_.complete || around > kMostAround || texts_.models.size() > kMostBytesOfPasses / (around + 1)) return;
    count_ = static_cast<std::int64_t>(texts_.models.size());
}

std::optional<Molecule> TextModels::read(int model) const {
    const TextSpan& own = texts_.models[static_cast<std::size_t>(model - 1)];
    if (own.size() > options_.maxBytes) return std::nullopt;
    try {
        FileContent alone = contentOfModel(content_.text, texts_, content_.format, model);
        unifyLineEnds(alone.bytes);
        Molecule molecule = readStated(name_, alone, options_);
        if (modelsOf(molecule.file) != 1) return std::nullopt;
        for (Chain& chain : molecule.chains) chain.model = model;
        return molecule;
    } catch (const Error&) {
        return std::nullopt;
    }
}

}  // namespace nacre
