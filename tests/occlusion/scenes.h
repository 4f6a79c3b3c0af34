#pragma once
// The molecules that occlusion is judged on.

#include <ostream>

#include "engine/error.h"
#include "tests/renderer/scenes.h"

namespace nacre::test {

struct OcclusionScene {
    const char* name;  ///< as docs/measurements.md has it
    const char* file;
    Style style;
};
inline constexpr OcclusionScene kSmallOcclusionScenes[] = {
    {"sample:dna", "sample:dna", Style::spacefill},
    {"1CRN, ball and stick", "1crn.pdb", Style::ballAndStick},
    {"caffeine, ball and stick", "small/caffeine.cml", Style::ballAndStick},
};
inline constexpr OcclusionScene kLargeOcclusionScenes[] = {
    {"1BNA", "1bna.pdb", Style::spacefill},
    {"4HHB", "4hhb.pdb", Style::spacefill},
    {"neon pump", "neon-pump.pdb", Style::spacefill},
    {"4TRA", "trna-4tra.pdb", Style::spacefill},
};
/// With ligands as sticks.
inline constexpr OcclusionScene kMeshOcclusionScenes[] = {
    {"4HHB, cartoon", "4hhb.pdb", Style::cartoon},
    {"4HHB, surface", "4hhb.pdb", Style::surface},
    {"1CRN, cartoon", "1crn.pdb", Style::cartoon},
};
inline void PrintTo(const OcclusionScene& s, std::ostream* out) { *out << s.name; }
inline bool isSample(const OcclusionScene& s) { return std::string_view(s.file).starts_with("sample:"); }

inline Representation makeScene(const OcclusionScene& s) { return scene(s.file, s.style); }

}  // namespace nacre::test
