#pragma once
// Values of the options about interactions. Every function throws std::invalid_argument with the reason, in words that
// continue "--option: "; those that take a selection also nacre::Error.

#include <string>
#include <string_view>

#include "engine/scene/contacts.h"

namespace nacre::app {

/// "off", "SEL" or "SEL,SEL". A comma that is part of a selection's list stays one: `chain A,B` is one selection.
void parseInteractions(std::string_view text, ContactOptions& contacts);
std::string interactionsText(const ContactOptions& contacts);

/// "molstar", "plip", "baker-hubbard" or "wernet-nilsson".
InteractionRules parseInteractionRules(std::string_view name);

/// "all", or names with commas between them: "hydrogen-bond,metal".
std::array<bool, kInteractionKinds> parseInteractionKinds(std::string_view text);
std::string interactionKindsText(const std::array<bool, kInteractionKinds>& kinds);
/// Their names, with commas.
std::string interactionKindNames();

}  // namespace nacre::app
