#pragma once
// Options of cartoons and surfaces, in one table: the command line and saved views read it.

#include <span>
#include <string>
#include <string_view>

#include "engine/scene/appearance.h"

namespace nacre::app {

struct MeshOption {
    const char* name;  ///< without its dashes; the key in a JSON, too
    const char* type;
    const char* fallback;  ///< for the help
    const char* help;
    /// @throws std::invalid_argument with the reason, in words that continue "--option: "
    void (*set)(std::string_view text, RepresentationOptions& look);
    std::string (*text)(const RepresentationOptions& look);  ///< what set() reads
};

/// In the order of the help.
std::span<const MeshOption> meshOptions();
/// Null if there is none of that name.
const MeshOption* meshOption(std::string_view name);

/// A style for all. A cartoon in the colours of elements would be that of its alpha carbons: where no colours were
/// asked for, its chains have their own.
void setStyle(Style style, RepresentationOptions& look);

}  // namespace nacre::app
