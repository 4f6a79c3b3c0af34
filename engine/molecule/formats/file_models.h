#pragma once
// The models of a file's content one after the other, each with the bonds that the file states.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/molecule/formats/content.h"
#include "engine/molecule/formats/model_texts.h"
#include "engine/molecule/molecule.h"

namespace nacre {

/// Models or records of the file that a molecule is one of.
std::int64_t modelsOf(const FileSummary& file);

/// The model that the options name, read from the whole, without bonds but those that the file states. @throws Error
Molecule readStated(const std::string& name, const FileContent& content, const ReadOptions& options);

/// A reader takes one model and steps over the others; so that all of them need not take as many passes over the file,
/// the text of each is cut out; where models stand in common tables, as many are read in one go as take no more memory
/// than ReadOptions::heldText, or a 64th of them.
class FileModels {
public:
    /// @param first          the first model, read from the whole
    /// @param name, content  outlive it
    FileModels(const std::string& name, const FileContent& content, const ReadOptions& options, const Molecule& first);

    std::int64_t count() const { return count_; }
    /// Whether models are read in such goes: in any order then.
    bool readsRuns() const { return runLength_ > 0; }
    /// @param model     from 1; each at most once
    /// @param maxAtoms  of this one @throws Error
    Molecule read(int model, std::size_t maxAtoms);

private:
    std::optional<Molecule> readCut(int model);
    const Molecule& ofRun(int model);

    const std::string& name_;
    const FileContent& content_;
    ReadOptions options_;
    TextSource text_;
    std::int64_t count_;
    std::vector<Molecule> run_;
    int runBegin_ = 0;  ///< the first model of the run
    int runLength_ = 0;
    Molecule subchains_;  ///< of the first model, with its assemblies; without atoms
    ModelTexts texts_;
    bool cut_ = false, told_ = false;
};

/// Models of a text that is never held whole.
class TextModels {
public:
    /// @param name  outlives it
    TextModels(const std::string& name, TextContent content, const ReadOptions& options);

    /// None: they cannot be read one by one.
    std::int64_t count() const { return count_; }
    /// @param model  from 1, in any order
    /// @returns nothing if that wants the whole text: to tell what is wrong, and where, or what there is to say of it
    std::optional<Molecule> read(int model) const;

private:
    const std::string& name_;
    TextContent content_;
    ReadOptions options_;
    ModelTexts texts_;
    std::int64_t count_ = 0;
};

}  // namespace nacre
