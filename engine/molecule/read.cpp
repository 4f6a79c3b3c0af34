// Reads the requested models of a content (overview: formats/model_reader.h).

#include "engine/molecule/read.h"

#include <limits>
#include <new>
#include <utility>

#include "engine/error.h"
#include "engine/molecule/bonds/bonds.h"
#include "engine/molecule/formats/model_reader.h"
#include "engine/molecule/join_models.h"
#include "engine/molecule/model_file.h"
#include "engine/molecule/text.h"

namespace nacre {
namespace {

/// Error messages may quote files and names: makes each one line of clean text.
template <typename Read>
auto cleanly(const std::string& name, Read&& read) {
    try {
        return read();
    } catch (const Error& error) {
        throw Error(printable(error.what(), kMaxMessage), "", "");
    } catch (const std::bad_alloc&) {
        cannotRead(printable(name, kMaxMessage), "not enough memory");
    }
}

/// The selected model of a text in memory.
Molecule readOne(const Content& content, const ReadOptions& options) {
    Molecule molecule = readStated(content, options);
    perceiveBonds(molecule);
    if (!options.others || countModels(molecule.file) < 2) return molecule;
    try {
        ModelReader models(content, options, molecule, ModelReader::Order::all);
        OtherModelCollector others(molecule, options.maxAtoms);
        for (int model = 1; model <= models.count() && others.wanted(); ++model)
            if (model != options.model) others.add(models.read(model, options.maxAtoms));
    } catch (const Error& error) {
        molecule.others.clear();
        molecule.othersMissing = std::string("another model cannot be read: ") + error.what();
    }
    return molecule;
}

/// Adds a model's counts to the file's totals, which the text of one model lacks.
void addUp(FileSummary& sum, const FileSummary& model) {
    const auto add = [](std::optional<std::int64_t>& to, const std::optional<std::int64_t>& more) {
        if (to && more) *to += *more;
    };
    add(sum.models, model.models);
    add(sum.records, model.records);
    add(sum.totalAtomsAllModels, model.totalAtomsAllModels);
    add(sum.totalAtomsAllRecords, model.totalAtomsAllRecords);
    add(sum.totalBondsAllRecords, model.totalBondsAllRecords);
}

/// As above for a text read model by model. Empty if a message requires the whole text.
std::optional<Molecule> readOneOfSpans(const Content& content, const ReadOptions& options) {
    const auto count = static_cast<int>(content.spans.models.size());
    if (options.model < 1 || options.model > count) return std::nullopt;
    std::optional<Molecule> own = readSpan(content, options, options.model);
    if (!own || !own->warnings.empty()) return std::nullopt;
    OtherModelCollector others(*own, options.maxAtoms);
    FileSummary sum = own->file;
    for (int model = 1; model <= count; ++model) {
        if (model == options.model) continue;
        std::optional<Molecule> other = readSpan(content, options, model);
        if (!other) return std::nullopt;
        addUp(sum, other->file);
        if (options.others && others.wanted()) others.add(std::move(*other));
    }
    own->file = sum;
    perceiveBonds(*own);
    return own;
}

Molecule readJoined(const Content& content, const ReadOptions& options) {
    ReadOptions left = options;
    left.model = 1;
    left.others = false;
    std::vector<Molecule> all;
    all.push_back(readOne(content, left));
    ModelReader models(content, left, all.front(), ModelReader::Order::all);
    const auto tell = [&] {
        if (options.onModel) options.onModel(static_cast<double>(all.size()) / static_cast<double>(models.count()));
    };
    tell();
    for (int model = 2; model <= models.count(); ++model) {
        if (all.back().atoms.size() > left.maxAtoms)
            throw tooManyAtoms(content.name + ", all models", options.maxAtoms);
        left.maxAtoms -= all.back().atoms.size();
        all.push_back(models.read(model, left.maxAtoms));
        perceiveBonds(all.back());
        tell();
    }
    return joinModels(content.name, std::move(all), options.maxAtoms);
}

Molecule readContent(const Content& content, const ReadOptions& options) {
    if (options.model < 0) cannotRead(content.name, "models are numbered from 1");
    if (options.model == kAllModels) return readJoined(content, options);
    if (content.bytes) return readOne(content, options);
    if (std::optional<Molecule> molecule = readOneOfSpans(content, options)) return std::move(*molecule);
    return readOne(heldWhole(content, options), options);
}

}  // namespace

Molecule readMolecule(const std::string& name, std::string bytes, const ReadOptions& options) {
    return cleanly(name, [&] { return readContent(makeContent(name, std::move(bytes), options), options); });
}

Molecule readMoleculeFile(const std::string& path, const ReadOptions& options) {
    return cleanly(path, [&] {
        ReadOptions own = options;
        if (options.model == kAllModels) own.heldText = std::numeric_limits<std::size_t>::max();
        return readContent(openContent(path, own), options);
    });
}

struct ModelFile::State {
    std::string path;  ///< to open it again; empty: it is in memory
    ReadOptions options;
    Content content;
    Molecule first;
    std::optional<ModelReader> models;
    std::vector<Molecule> all;  ///< all models, if one cannot be read without the others

    State(std::string from, Content opened, const ReadOptions& own)
        : path(std::move(from)), options(own), content(std::move(opened)) {
        options.model = 1;
        options.others = true;
        first = readContent(content, options);
        options.others = false;
        if (countModels(first.file) > 1) keep();
    }

    void keep() {
        models.emplace(content, options, first, ModelReader::Order::any);
        if (models->skipsOthers()) return;
        const bool held = path.empty() || content.text.size <= options.heldText;
        for (int model = 1; held && model <= models->count(); ++model) {
            all.push_back(models->read(model, options.maxAtoms));
            perceiveBonds(all.back());
        }
        models.reset();
        content = {content.name, content.format, nullptr, {}, {}};
    }

    Molecule read(int model) {
        if (!all.empty()) return all.at(static_cast<std::size_t>(model - 1));
        if (!models) {
            options.model = model;
            return readContent(content.text.size > 0 ? content : openContent(path, options), options);
        }
        Molecule own = models->read(model, options.maxAtoms);
        perceiveBonds(own);
        return own;
    }
};

ModelFile::ModelFile(const std::string& path, const ReadOptions& options)
    : state_(cleanly(path, [&] {
          return std::make_unique<State>(path == "-" ? "" : path, openContent(path, options), options);
      })) {}

ModelFile::ModelFile(const std::string& name, std::string bytes, const ReadOptions& options)
    : state_(cleanly(
          name, [&] { return std::make_unique<State>("", makeContent(name, std::move(bytes), options), options); })) {}

ModelFile::~ModelFile() = default;

int ModelFile::count() const { return static_cast<int>(countModels(state_->first.file)); }

const Molecule& ModelFile::first() const { return state_->first; }

Molecule ModelFile::read(int model) {
    return cleanly(state_->content.name, [&] { return state_->read(model); });
}

}  // namespace nacre
