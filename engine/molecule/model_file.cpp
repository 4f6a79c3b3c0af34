#include "engine/molecule/model_file.h"

#include <optional>
#include <utility>
#include <vector>

#include "engine/molecule/bonds/bonds.h"
#include "engine/molecule/formats/content.h"
#include "engine/molecule/formats/decompress.h"
#include "engine/molecule/formats/file_models.h"

namespace nacre {

struct ModelFile::State {
    std::string name;
    ReadOptions options;
    std::shared_ptr<const std::string> bytes;  ///< as in the file; null: the file has them
    Molecule first;
    std::optional<TextModels> texts;   ///< one by one
    std::optional<FileContent> whole;  ///< of formats whose models stand in common tables
    std::optional<FileModels> runs;    ///< of it
    std::vector<Molecule> all;         ///< of other formats

    /// From the whole.
    Molecule readWhole(int model, bool others) const {
        ReadOptions own = options;
        own.model = model;
        own.others = others;
        return bytes ? readMolecule(name, *bytes, own) : readMoleculeFile(name, own);
    }

    int count() const { return static_cast<int>(modelsOf(first.file)); }

    /// Whether models stand in common tables, so that no text is one model's.
    bool packed() const {
        const std::string& format = first.file.format;
        return format == "bcif" || format == "mmtf" || format == "mmjson";
    }

    void takeText(std::optional<TextContent> content) {
        if (!content) return;
        texts.emplace(name, std::move(*content), options);
        if (texts->count() != count()) texts.reset();
    }

    /// Of a file that is short, or in memory anyway.
    void takeBytes(std::string content) {
        if (!packed()) {
            const auto shared = std::make_shared<const std::string>(std::move(content));
            takeText(textContentOf(name, shared, options));
            if (texts) return;
            content = *shared;
        }
        whole.emplace(contentOf(name, std::move(content), options));
        FileModels& models = runs.emplace(name, *whole, options, first);
        if (models.readsRuns()) return;
        for (int model = 1; model <= models.count(); ++model) {
            all.push_back(models.read(model, options.maxAtoms));
            perceiveBonds(all.back());
        }
        runs.reset();
        whole.reset();
    }
};

ModelFile::ModelFile(const std::string& path, const ReadOptions& options)
    : state_(std::make_unique<State>(State{path, options, nullptr, {}, {}, {}, {}, {}})) {
    State& state = *state_;
    state.first = state.readWhole(1, true);
    if (count() < 2) return;
    std::string content;
    state.takeText(textContentOf(path, options, content));
    if (state.texts) return;
    const std::shared_ptr<ByteFile> file = ByteFile::open(path);
    const bool packed = state.packed();
    if (content.empty() && file && (packed || file->size() <= options.heldText)) {
        content.resize(static_cast<std::size_t>(file->size()));
        file->read(0, content.data(), content.size());
    }
    if (!content.empty() && (packed || content.size() <= options.heldText)) state.takeBytes(std::move(content));
}

ModelFile::ModelFile(const std::string& name, std::string bytes, const ReadOptions& options)
    : state_(std::make_unique<State>(State{name, options, nullptr, {}, {}, {}, {}, {}})) {
    State& state = *state_;
    state.bytes = std::make_shared<const std::string>(std::move(bytes));
    state.first = state.readWhole(1, true);
    if (count() < 2) return;
    const bool plain = compressionOf(*state.bytes).empty();
    state.takeBytes(plain ? *state.bytes : decompress(name, *state.bytes, options.maxBytes));
}

ModelFile::~ModelFile() = default;

int ModelFile::count() const { return state_->count(); }

const Molecule& ModelFile::first() const { return state_->first; }

Molecule ModelFile::read(int model) {
    State& state = *state_;
    if (state.runs) {
        Molecule own = state.runs->read(model, state.options.maxAtoms);
        perceiveBonds(own);
        return own;
    }
    if (!state.all.empty()) return state.all.at(static_cast<std::size_t>(model - 1));
    if (state.texts)
        if (std::optional<Molecule> alone = state.texts->read(model)) {
            perceiveBonds(*alone);
            return std::move(*alone);
        }
    return state.readWhole(model, false);  // which says what is wrong with it, and where
}

}  // namespace nacre
