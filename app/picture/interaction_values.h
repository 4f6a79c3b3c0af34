#pragma once
// Values of options about interactions. Every function throws std::invalid_argument with the reason, as text that
// continues "--option: "; functions for selections also nacre::Error.

#include <string>
#include <string_view>

#include "engine/scene/build/contacts.h"

namespace nacre::app {

/// "off", "SEL" or "SEL,SEL". A comma inside a selection's list does not split: `chain A,B` is one selection.
void parseInteractions(std::string_view text, ContactOptions& contacts);
std::string interactionsText(const ContactOptions& contacts);

/// "molstar", "plip", "baker-hubbard" or "wernet-nilsson".
InteractionRules parseInteractionRules(std::string_view name);

/// "all", or names separated by commas: "hydrogen-bond,metal".
std::array<bool, kInteractionKinds> parseInteractionKinds(std::string_view text);
std::string interactionKindsText(const std::array<bool, kInteractionKinds>& kinds);
/// Names of interaction kinds, separated by commas.
std::string interactionKindNames();
/// "KIND=COLOR", or "COLOR" for all kinds; "" clears all. @throws std::invalid_argument
void parseInteractionColor(std::string_view text, ContactOptions& contacts);
/// One line per kind with its own colour.
std::string interactionColorsText(const ContactOptions& contacts);

}  // namespace nacre::app
