#pragma once
// Options of engine/effects.h, in one table: the command line, saved views, looks and the panel all read it.

#include <span>
#include <string>
#include <string_view>

#include "engine/effects.h"

namespace nacre::app {

struct EffectOption {
    const char* name;  ///< without its dashes; the key in a JSON, too
    const char* type;
    const char* fallback;  ///< for the help
    const char* help;
    /// @throws std::invalid_argument with the reason, in words that continue "--option: "
    void (*set)(std::string_view text, Effects& effects);
    std::string (*text)(const Effects& effects);  ///< what set() reads
    bool look = true;                             ///< part of a look; else of what is seen
    const char* of = nullptr;                     ///< the option without which this one shows nothing
};

/// In the order of the help.
std::span<const EffectOption> effectOptions();
/// Null if there is none of that name.
const EffectOption* effectOption(std::string_view name);

/// The two planes of a slab about the centre. @param text  its thickness, Å
void setSlab(std::string_view text, Effects& effects);

}  // namespace nacre::app
