#include "engine/molecule/formats/frames.h"

namespace nacre {

Molecule FrameReader::run(const char* format) {
    std::int64_t frames = 0, atoms = 0;
    while (const std::optional<std::int64_t> count = begin(frames + 1)) {
        const bool wanted = frames + 1 == model_;
        if (wanted) beginAtoms();
        std::int64_t read = 0;
        for (; read < *count && lines_.next(); ++read)
            if (wanted) readAtom(lines_.line());
        if (read < *count) {
            if (wanted)
                cannotRead(name_, "it ends after " + std::to_string(read) + " of " + std::to_string(*count) + " atoms",
                           lines_.number());
            builder_.warn("frame " + std::to_string(frames + 1) + " is incomplete");
            break;
        }
        end(wanted);
        ++frames;
        atoms += *count;
    }
    if (frames == 0) cannotRead(name_, "it has no frames");
    if (model_ > frames)
        cannotRead(name_, "there is no frame " + std::to_string(model_) + "; the file has " + std::to_string(frames));
    FileSummary& file = builder_.molecule().file;
    file.format = format;
    file.models = frames;
    file.totalAtomsAllModels = atoms;
    return builder_.finish();
}

void FrameReader::refuseCount(std::string_view announced, std::uint64_t line) const {
    if (!isCount(announced)) cannotRead(name_, "expected a number of atoms, not '" + printable(announced) + "'", line);
    cannotRead(name_, "it states " + printable(announced) + " atoms, but does not have as many", line);
}

}  // namespace nacre
