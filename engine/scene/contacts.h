#pragma once
// Interactions that are drawn: which, how they look, and what of a scene they are.

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <string_view>
#include <vector>

#include "engine/molecule/chemistry/interactions.h"
#include "engine/molecule/selection/selection.h"
#include "engine/scene/dashes.h"

namespace nacre {

struct ContactOptions {
    std::optional<Selection> of;    ///< empty: none are drawn
    std::optional<Selection> with;  ///< empty: what is around `of`
    InteractionRules rules = InteractionRules::molstar;
    std::array<bool, kInteractionKinds> kinds{true, true, true, true, true, true, true, true};
    double width = 0.14;  ///< of the dashes, Å
    friend bool operator==(const ContactOptions&, const ContactOptions&) = default;
};

/// How a kind of interaction is drawn and called.
struct ContactLook {
    const char* label;    ///< "Hydrogen bond"
    std::uint32_t color;  ///< packed as in colors.h
    DashPattern pattern;
};
const ContactLook& contactLook(InteractionKind kind);

/// Legend::scheme of the legend of contacts.
constexpr std::string_view kContactScheme = "interactions";

/// An interaction that a scene draws. What is drawn of the i-th has the number `atoms of the molecule` + 1 + i, where
/// atoms have theirs.
struct DrawnContact {
    Interaction interaction;
    glm::dvec3 middle{};  ///< on its line, Å from the scene's centre
};

}  // namespace nacre
