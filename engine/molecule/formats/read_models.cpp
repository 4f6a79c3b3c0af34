#include "engine/molecule/formats/read_models.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "engine/error.h"
#include "engine/molecule/bonds/bonds.h"
#include "engine/molecule/formats/file_models.h"
#include "engine/molecule/formats/readers.h"
#include "engine/molecule/other_models.h"
#include "engine/molecule/overlay_models.h"

namespace nacre {
namespace {

/// Puts the places of all other models into a molecule, or the reason why they are not there.
void addOthers(FileModels& models, const ReadOptions& options, Molecule& own) {
    try {
        OtherModels others(own, options.maxAtoms);
        for (int model = 1; model <= models.count() && others.wanted(); ++model)
            if (model != options.model) others.add(models.read(model, options.maxAtoms));
    } catch (const Error& error) {
        own.others.clear();
        own.othersMissing = std::string("another model cannot be read: ") + error.what();
    }
}

/// What a file holds altogether, which the text of one model does not tell.
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

}  // namespace

Molecule readModel(const std::string& name, const FileContent& content, const ReadOptions& options) {
    Molecule molecule = readStated(name, content, options);
    perceiveBonds(molecule);
    if (!options.others || modelsOf(molecule.file) < 2) return molecule;
    try {
        FileModels models(name, content, options, molecule);
        addOthers(models, options, molecule);
    } catch (const Error& error) {
        molecule.othersMissing = std::string("another model cannot be read: ") + error.what();
    }
    return molecule;
}

std::optional<Molecule> readModelAlone(const std::string& name, TextContent content, const ReadOptions& options) {
    const TextModels models(name, std::move(content), options);
    if (options.model < 1 || options.model > models.count() || models.count() < 2) return std::nullopt;
    std::optional<Molecule> own = models.read(options.model);
    if (!own || !own->warnings.empty()) return std::nullopt;
    OtherModels others(*own, options.maxAtoms);
    FileSummary sum = own->file;
    for (int model = 1; model <= models.count(); ++model) {
        if (model == options.model) continue;
        std::optional<Molecule> other = models.read(model);
        if (!other) return std::nullopt;
        addUp(sum, other->file);
        if (options.others && others.wanted()) others.add(std::move(*other));
    }
    own->file = sum;
    perceiveBonds(*own);
    return own;
}

Molecule readAllModels(const std::string& name, const FileContent& content, const ReadOptions& options) {
    ReadOptions left = options;
    left.model = 1;
    left.others = false;
    std::vector<Molecule> all;
    all.push_back(readModel(name, content, left));
    FileModels models(name, content, left, all.front());
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
