#pragma once
// Base of trajectories in text (XYZ, GRO): frames that each state their number of atoms.

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
    /// Reads the wanted frame, and counts all frames for the summary. @throws Error if there is no such frame
    Molecule run(const char* format);

protected:
    /// Reads the head of the next frame and returns its number of atoms; empty after the last frame.
    virtual std::optional<std::int64_t> begin(std::int64_t frame) = 0;
    virtual void beginAtoms() {}
    virtual void readAtom(std::string_view line) = 0;
    /// Reads the lines after the atoms, or skips them for an unwanted frame.
    virtual void end(bool) {}

    static bool isCount(std::string_view text) {
        return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
    }
    /// Handles data after the last frame.
    std::nullopt_t passOver(std::int64_t frame) {
        builder_.warn("what follows frame " + std::to_string(frame - 1) + " is passed over");
        return std::nullopt;
    }
    /// @param announced  text where the number of atoms should be
    [[noreturn]] void refuseCount(std::string_view announced, std::uint64_t line) const;

    const std::string& name_;
    LineReader lines_;
    int model_;
    MoleculeBuilder builder_;
};

}  // namespace nacre
