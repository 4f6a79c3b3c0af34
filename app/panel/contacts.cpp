// Interactions in the panel: actions for a selection, and the list of drawn ones.

#include <algorithm>
#include <string_view>
#include <utility>

#include "app/annotation/measurement.h"
#include "app/panel/panel_state.h"
#include "app/picture/looks.h"

namespace nacre::app {
namespace {

constexpr std::size_t kMostListed = 100;

/// Both residues of a contact.
Selection bothResidues(const Interaction& contact) {
    return parseSelection("byres (id " + std::to_string(contact.a.atoms.front() + 1) + "+" +
                          std::to_string(contact.b.atoms.front() + 1) + ")");
}

}  // namespace

void drawContactActions(PanelFrame& f, const std::string& selection) {
    if (f.ui.word("Interactions")) {
        f.look.look.contacts.of = parseSelection(selection);
        f.look.look.contacts.with.reset();
    }
    if (!f.ui.word("Show pocket")) return;
    f.look.look.rules.clear();
    f.look.words.labels.clear();
    applyPocket(selection, f.look);
    f.s.aim.emplace(std::exchange(f.look.aim, {}));
}

void drawContactList(PanelFrame& f) {
    const Document* document = f.viewer.document();
    if (!document || !f.look.look.contacts.of) return;
    f.ui.heading("Interactions");
    if (f.ui.word("Hide interactions", false)) f.look.look.contacts.of.reset();
    bool labels = f.look.words.distances;
    if (f.ui.toggle("Distances", labels)) f.look.words.distances = labels;
    const std::vector<DrawnContact>& contacts = document->drawing.scene().contacts;
    if (contacts.empty()) f.ui.caption("None found.");
    std::optional<InteractionKind> kind;
    for (std::size_t i = 0; i < std::min(contacts.size(), kMostListed); ++i) {
        const Interaction& contact = contacts[i].interaction;
        if (kind != contact.kind) f.ui.caption(contactLook(contact.kind).label);
        kind = contact.kind;
        ImGui::PushID(static_cast<int>(i));
        const std::string said = contactText(*document->molecule, contact);
        // The heading above states the kind.
        const std::string label = said.substr(std::string_view(contactLook(contact.kind).label).size() + 1);
        if (f.ui.row(Icon::fit, label, -1)) {
            f.s.aim.emplace();
            f.s.aim->zoomTo = bothResidues(contact);
        }
        f.ui.explain(said);
        ImGui::PopID();
    }
    if (contacts.size() > kMostListed) f.ui.caption("and " + std::to_string(contacts.size() - kMostListed) + " more");
}

}  // namespace nacre::app
