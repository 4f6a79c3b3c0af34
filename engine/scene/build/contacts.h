#pragma once
// Interactions in a scene: selection, look, and drawn ones.

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <string_view>

#include "engine/molecule/chemistry/interactions.h"
#include "engine/molecule/selection/selection.h"
#include "engine/scene/build/dashes.h"

namespace nacre {

struct ContactOptions {
    std::optional<Selection> of;    ///< empty: none
    std::optional<Selection> with;  ///< empty: the surroundings of `of`
    InteractionRules rules = InteractionRules::molstar;
    std::array<bool, kInteractionKinds> kinds{true, true, true, true, true, true, true, true};
    double width = 0.14;                                    ///< of the dashes, Å
    std::array<std::uint32_t, kInteractionKinds> colors{};  ///< packed; 0: contactLook()
    friend bool operator==(const ContactOptions&, const ContactOptions&) = default;
};

/// Colour, pattern and name of a kind of interaction.
struct ContactLook {
    const char* label;    ///< "Hydrogen bond"
    std::uint32_t color;  ///< packed as in colors.h
    DashPattern pattern;
};
const ContactLook& contactLook(InteractionKind kind);

/// Legend::scheme for interactions.
constexpr std::string_view kContactScheme = "interactions";

/// A drawn interaction. Primitives of the i-th one have the number (atoms of the molecule) + 1 + i instead of an
/// atom's.
struct DrawnContact {
    Interaction interaction;
    glm::dvec3 middle{};     ///< on its line, Å from the scene's centre
    std::uint32_t copy = 0;  ///< in an assembly: the first copy (Copies::transforms) in whose place it is drawn
};

}  // namespace nacre
