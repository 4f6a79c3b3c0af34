#include "app/picture/interaction_values.h"

#include <algorithm>
#include <span>
#include <stdexcept>
#include <utility>

#include "app/picture/color_values.h"
#include "app/picture/option_values.h"
#include "engine/error.h"
#include "engine/scene/color/palettes.h"

namespace nacre::app {
namespace {

std::optional<Selection> parsed(std::string_view text) {
    try {
        return parseSelection(text);
    } catch (const Error&) {
        return std::nullopt;
    }
}

/// Words of other programs.
constexpr std::pair<std::string_view, std::string_view> kKindSynonyms[] = {
    {"hbond", "hydrogen-bond"}, {"hbonds", "hydrogen-bond"},    {"h-bond", "hydrogen-bond"},
    {"polar", "hydrogen-bond"}, {"salt", "salt-bridge"},        {"ionic", "salt-bridge"},
    {"pi-pi", "pi-stacking"},   {"pi-stack", "pi-stacking"},    {"stacking", "pi-stacking"},
    {"pi-cation", "cation-pi"}, {"halogen", "halogen-bond"},    {"metal-coordination", "metal"},
    {"water", "water-bridge"},  {"waterbridge", "water-bridge"}};

std::vector<std::string> kindNames() {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < kInteractionKinds; ++i)
        names.emplace_back(interactionKindName(static_cast<InteractionKind>(i)));
    return names;
}

[[noreturn]] void refuseKind(std::string_view text, std::span<const std::string> names) {
    const std::string wanted = "all, or of " + interactionKindNames();
    for (const auto& [theirs, ours] : kKindSynonyms)
        if (text == theirs)
            throw std::invalid_argument("expected " + wanted + ", not '" + std::string(text) + "' (did you mean '" +
                                        std::string(ours) + "'?)");
    refuse(text, wanted, names);
}

}  // namespace

void parseInteractions(std::string_view text, ContactOptions& contacts) {
    contacts.of.reset();
    contacts.with.reset();
    if (text == "off" || (contacts.of = parsed(text))) return;
    for (std::size_t at = text.find(','); at != std::string_view::npos; at = text.find(',', at + 1)) {
        contacts.of = parsed(text.substr(0, at));
        contacts.with = parsed(text.substr(at + 1));
        if (contacts.of && contacts.with) return;
    }
    contacts.with.reset();
    const std::string_view first = text.substr(0, text.find(','));
    parseSelection(first);  // throws the error of the first selection of two
    // A comma that does not continue a list, as in "chain A,B", begins the second selection.
    if (first.size() < text.size() && !parsed(std::string(first) + ",A")) parseSelection(text.substr(first.size() + 1));
    contacts.of = parseSelection(text);
}

std::string interactionsText(const ContactOptions& contacts) {
    if (!contacts.of) return "off";
    return contacts.of->text + (contacts.with ? "," + contacts.with->text : "");
}

InteractionRules parseInteractionRules(std::string_view name) {
    if (const auto rules = interactionRulesFromName(name)) return *rules;
    constexpr const char* kNames[] = {"molstar", "plip", "baker-hubbard", "wernet-nilsson"};
    return static_cast<InteractionRules>(parseChoice(name, kNames));
}

std::array<bool, kInteractionKinds> parseInteractionKinds(std::string_view text) {
    std::array<bool, kInteractionKinds> kinds{};
    if (text == "all") {
        kinds.fill(true);
        return kinds;
    }
    std::vector<std::string> names = kindNames();
    names.insert(names.begin(), "all");
    for (std::size_t from = 0; from <= text.size();) {
        const std::size_t end = std::min(text.find(',', from), text.size());
        const auto kind = interactionKindFromName(text.substr(from, end - from));
        if (!kind) refuseKind(text.substr(from, end - from), names);
        kinds[static_cast<std::size_t>(*kind)] = true;
        from = end + 1;
    }
    return kinds;
}

std::string interactionKindsText(const std::array<bool, kInteractionKinds>& kinds) {
    if (std::find(kinds.begin(), kinds.end(), false) == kinds.end()) return "all";
    std::string text;
    for (std::size_t i = 0; i < kInteractionKinds; ++i)
        if (kinds[i])
            text += (text.empty() ? "" : ",") + std::string(interactionKindName(static_cast<InteractionKind>(i)));
    return text;
}

std::string interactionKindNames() { return joinWords(kindNames()); }

void parseInteractionColor(std::string_view text, ContactOptions& contacts) {
    if (text.empty()) return contacts.colors.fill(0);
    const std::size_t sign = text.rfind('=');
    const auto color = parseColor(sign == std::string_view::npos ? text : text.substr(sign + 1));
    if (color[3] < 1.0f) throw std::invalid_argument("interactions cannot be transparent: '" + std::string(text) + "'");
    std::array<bool, kInteractionKinds> kinds{};
    kinds.fill(true);
    if (sign != std::string_view::npos) kinds = parseInteractionKinds(text.substr(0, sign));
    for (std::size_t i = 0; i < kinds.size(); ++i)
        if (kinds[i]) contacts.colors[i] = opaqueColor(color);
}

std::string interactionColorsText(const ContactOptions& contacts) {
    std::string text;
    for (std::size_t i = 0; i < kInteractionKinds; ++i)
        if (contacts.colors[i] != 0)
            text += (text.empty() ? "" : "\n") + std::string(interactionKindName(static_cast<InteractionKind>(i))) +
                    "=" + colorText(contacts.colors[i]);
    return text;
}

}  // namespace nacre::app
