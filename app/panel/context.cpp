// The menu of a right click: actions for the residue there, its chain, or the picture.

#include <algorithm>
#include <utility>

#include "app/annotation/measurement.h"
#include "app/panel/panel_state.h"
#include "app/picture/options.h"
#include "app/viewer/parts.h"

namespace nacre::app {
namespace {

constexpr float kContextPoints = 300;

/// Widens the selection from the residue that was clicked.
void drawScope(PanelFrame& f, const Molecule& molecule, std::uint32_t atom) {
    const Residue& residue = molecule.residues[molecule.atoms[atom].residue];
    const std::string& chain = molecule.chains[residue.chain].name;
    const std::string name(residue.name.view());
    const auto offer = [&](const std::string& label, const std::string& selection, bool more) {
        if (f.ui.word(label.c_str(), more)) f.viewer.picking().select(selection);
    };
    offer("Residue", "byres id " + std::to_string(atom + 1), false);
    if (!chain.empty()) offer("Chain " + chain, "chain " + quotedName(chain), true);
    if (!name.empty()) offer("All " + name, "resn " + quotedName(name), true);
}

}  // namespace

void drawContext(PanelFrame& f) {
    const Rectangle& window = f.s.window;
    const float width = std::min(f.ui.px(kContextPoints), window.width());
    const ImVec2 at(std::max(std::min(f.s.context->x, window.right - width), window.left), f.s.context->y);
    // As far up as needed; its height is that of the last frame.
    const float top = std::max(std::min(at.y, window.bottom - f.s.contextHeight), window.top);
    beginGrown(f, "Actions", ImVec2(at.x, top), ImVec2(0, 0), width, window.height());
    if (ImGui::IsWindowAppearing()) ImGui::SetWindowFocus();
    Picking& picking = f.viewer.picking();
    bool done = false;
    beginLook(f);
    if (!picking.picks().empty() && picking.selection().any()) {
        const Molecule& molecule = *f.viewer.document()->molecule;
        f.ui.paragraph(atomText(molecule, picking.picks().back()));
        f.ui.heading("Select");
        drawScope(f, molecule, picking.picks().back());
        f.ui.caption(selectedText(picking.selection().count));
        f.ui.heading("Actions");
        drawSelectionActions(f, picking.selection().text);
    } else {
        using C = ViewerCommand;
        for (const auto& [label, command] : {std::pair("Zoom to all", C::fit),
                                             {"Reset view", C::reset},
                                             {"Align to principal axes", C::orient},
                                             {"Next background", C::nextBackground},
                                             {"Save image ...", C::saveAs},
                                             {"Copy image", C::copyPicture},
                                             {"Show or hide the panel", C::panel},
                                             {"Full screen", C::fullScreen},
                                             {"Commands and options ...", C::palette}})
            if (f.ui.row(Icon::none, label, -1)) {
                f.s.context.reset();
                f.host.run(command);
                done = true;
            }
    }
    const float height = ImGui::GetWindowSize().y;
    if (std::exchange(f.s.contextHeight, height) != height) f.s.restless = std::max(f.s.restless, 2);
    endGrown(f);
    const bool changed = f.s.aim || difference(f.look, f.before) != 0;
    takeLook(f);
    if (!done && !changed) return;
    f.s.context.reset();
    f.s.restless = 3;
}

}  // namespace nacre::app
