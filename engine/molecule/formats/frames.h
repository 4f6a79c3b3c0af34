#pragma once
// What trajectories as text (XYZ, GRO) have in common: frame after frame, each of which announces its atoms.

#include <cstdint>
#include <optional>
#include <string>

#include "engine/error.h"
#include "engine/molecule/formats/molecule_builder.h"

namespace nacre {

/// Walks through the frames of a file, reads the one that is wanted, and notes in the summary how many there are.
/// @param reader  begin(frame): the number of atoms of the next frame, empty at the end of the frames;
///                read(atoms): reads the frame that was begun; skip(atoms): steps over it, false if it is incomplete
/// @throws Error if there is no such frame
template <typename Reader>
void readFrames(MoleculeBuilder& builder, const char* format, int wanted, Reader& reader) {
    std::int64_t frames = 0, atoms = 0;
    while (const std::optional<std::int64_t> count = reader.begin(frames + 1)) {
        if (frames + 1 == wanted) {
            reader.read(*count);
        } else if (!reader.skip(*count)) {
            builder.warn("frame " + std::to_string(frames + 1) + " is incomplete");
            break;
        }
        ++frames;
        atoms += *count;
    }
    if (frames == 0) throw Error("cannot read molecule", builder.name(), "it has no frames");
    if (wanted > frames)
        throw Error("cannot read molecule", builder.name(),
                    "there is no frame " + std::to_string(wanted) + "; the file has " + std::to_string(frames));
    FileSummary& file = builder.molecule().file;
    file.format = format;
    file.models = frames;
    file.totalAtomsAllModels = atoms;
}

}  // namespace nacre
