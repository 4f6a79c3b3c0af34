#pragma once
// What trajectories as text (XYZ, GRO) have in common: frame after frame, each of which announces its atoms.

#include <cstdint>
#include <optional>
#include <string>

#include "engine/molecule/formats/molecule_builder.h"
#include "engine/molecule/read.h"
#include "engine/molecule/text.h"

namespace nacre {

class FrameReader {
public:
    FrameReader(const std::string& name, std::string_view text, const ReadOptions& options)
        : name_(name), lines_(text), model_(options.model), builder_(name, options.maxAtoms) {}
    virtual ~FrameReader() = default;
    /// Walks through the frames, reads the one that is wanted, and notes in the summary how many there are.
    /// @throws Error if there is no such frame
    Molecule run(const char* format);

protected:
    /// The number of atoms of the next frame, with what stands before them read; empty at the end of the frames.
    virtual std::optional<std::int64_t> begin(std::int64_t frame) = 0;
    virtual void beginAtoms() {}
    virtual void readAtom(std::string_view line) = 0;
    /// What follows the atoms; of a frame that is not wanted it is passed over.
    virtual void end(bool) {}

    static bool isCount(std::string_view text) {
        return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
    }
    /// Behind the last frame stands something else.
    std::nullopt_t passOver(std::int64_t frame) {
        builder_.warn("what follows frame " + std::to_string(frame - 1) + " is passed over");
        return std::nullopt;
    }
    /// @param announced  the text that should be a number of atoms for which there are lines
    [[noreturn]] void refuseCount(std::string_view announced, std::uint64_t line) const;

    const std::string& name_;
    LineReader lines_;
    int model_;
    MoleculeBuilder builder_;
};

}  // namespace nacre
