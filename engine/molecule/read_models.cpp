#include "engine/molecule/read_models.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "engine/error.h"
#include "engine/molecule/bonds/bonds.h"
#include "engine/molecule/formats/model_texts.h"
#include "engine/molecule/formats/readers.h"
#include "engine/molecule/other_models.h"
#include "engine/molecule/overlay_models.h"
#include "engine/molecule/text.h"

namespace nacre {
namespace {

constexpr std::size_t kMaxWarnings = 32;
constexpr std::uint64_t kMostBytesOfPasses = std::uint64_t{1} << 32;  // that models read one by one take together

std::vector<Molecule> alone(Molecule molecule) {
    std::vector<Molecule> models;
    models.push_back(std::move(molecule));
    return models;
}

/// What the format's reader gives: one model or, of some formats and if all are wanted, all of them.
std::vector<Molecule> dispatch(const std::string& name, const FileContent& content, const ReadOptions& options) {
    const std::string_view bytes = content.bytes;
    switch (content.format) {
        case Format::pdb:
            return alone(readPdb(name, bytes, options));
        case Format::mmcif:
            return readMmcif(name, bytes, options);
        case Format::mmjson:
            return readMmjson(name, bytes, options);
        case Format::bcif:
            return readBcif(name, bytes, options);
        case Format::mmtf:
            return readMmtf(name, bytes, options);
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

bool readsAllAtOnce(Format format) {
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

/// Without bonds but those that the file states.
Molecule readStated(const std::string& name, const FileContent& content, const ReadOptions& options) {
    return cleaned(std::move(dispatch(name, content, options).front()), options.model);
}

/// Models or records of the file that a molecule is one of.
std::int64_t modelsOf(const FileSummary& file) { return std::max(file.models.value_or(1), file.records.value_or(1)); }

void boundPasses(const std::string& name, std::int64_t passes, std::size_t bytes) {
    if (static_cast<std::uint64_t>(passes) > kMostBytesOfPasses / std::max<std::size_t>(bytes, 1))
        throw Error("cannot read molecule", name,
                    "it has too many models to read them all: " + std::to_string(passes) + " times " +
                        std::to_string(bytes) + " bytes are more than " + std::to_string(kMostBytesOfPasses));
}

/// The models of a file in their order, each with the bonds that the file states. A reader takes one and steps over
/// the others; so that all of them need not take as many passes over the file, the text of each is cut out, unless the
/// reader gives them all at once.
class Models {
public:
    /// @param first  the first model, read from the whole
    Models(const std::string& name, const FileContent& content, const ReadOptions& options, const Molecule& first)
        : name_(name), content_(content), options_(options), count_(modelsOf(first.file)) {
        options_.others = false;
        if (count_ < 2) return;
        if (readsAllAtOnce(content.format)) {
            options_.model = kAllModels;
            atOnce_ = dispatch(name, content, options_);
            count_ = static_cast<std::int64_t>(atOnce_.size());
            return;
        }
        texts_ = modelTexts(content.format, content.bytes);
        cut_ = texts_.models.size() == static_cast<std::size_t>(count_);
        boundPasses(name, count_, cut_ ? texts_.before.size() + texts_.after.size() : content.bytes.size());
    }
    std::int64_t count() const { return count_; }

    /// @param model     from 1; each at most once
    /// @param maxAtoms  of this one
    Molecule read(int model, std::size_t maxAtoms) {
        const auto index = static_cast<std::size_t>(model - 1);
        if (!atOnce_.empty()) return cleaned(std::exchange(atOnce_[index], Molecule()), model);
        options_.maxAtoms = maxAtoms;
        if (cut_)
            if (std::optional<Molecule> alone = readCut(model)) return std::move(*alone);
        options_.model = model;
        return readStated(name_, content_, options_);
    }

private:
    /// A model from its own text. Nothing if that is otherwise than the cut has it, or if something is to be said of
    /// it, since the whole text knows the line; but not of every model, since each look at the whole takes its time.
    std::optional<Molecule> readCut(int model) {
        options_.model = 1;
        FileContent alone{std::string(texts_.before), content_.format};
        alone.bytes.append(texts_.models[static_cast<std::size_t>(model - 1)]).append(texts_.after);
        try {
            Molecule molecule = readStated(name_, alone, options_);
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

    const std::string& name_;
    const FileContent& content_;
    ReadOptions options_;
    std::int64_t count_;
    std::vector<Molecule> atOnce_;
    ModelTexts texts_;
    bool cut_ = false, told_ = false;
};

/// Puts the places of all other models into a molecule, or the reason why they are not there.
void addOthers(const std::string& name, const FileContent& content, const ReadOptions& options, Molecule& own) {
    try {
        Models models(name, content, options, own);
        OtherModels others(own, options.maxAtoms);
        for (int model = 1; model <= models.count() && others.wanted(); ++model)
            if (model != options.model) others.add(models.read(model, options.maxAtoms));
    } catch (const Error& error) {
        own.others.clear();
        own.othersMissing = std::string("another model cannot be read: ") + error.what();
    }
}

}  // namespace

Molecule readModel(const std::string& name, const FileContent& content, const ReadOptions& options) {
    Molecule molecule = readStated(name, content, options);
    perceiveBonds(molecule);
    if (options.others && modelsOf(molecule.file) > 1) addOthers(name, content, options, molecule);
    return molecule;
}

Molecule readAllModels(const std::string& name, const FileContent& content, const ReadOptions& options) {
    ReadOptions left = options;
    left.model = 1;
    left.others = false;
    std::vector<Molecule> all;
    all.push_back(readModel(name, content, left));
    Models models(name, content, left, all.front());
    const auto tell = [&] {
        if (options.onModel) options.onModel(static_cast<double>(all.size()) / static_cast<double>(models.count()));
    };
    tell();
    for (int model = 2; model <= models.count(); ++model) {
        if (all.back().atoms.size() > left.maxAtoms) throw tooManyAtoms(name + ", all models", options.maxAtoms);
        left.maxAtoms -= all.back().atoms.size();
        all.push_back(models.read(model, left.maxAtoms));
        perceiveBonds(all.back());
        tell();
    }
    return overlayModels(name, std::move(all), options.maxAtoms);
}

}  // namespace nacre
