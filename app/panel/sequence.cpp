// The sequence of a chain: one letter a residue, its colour and its fold above. A click selects one, a drag or Shift
// with the arrow keys several.

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/panel/panel_state.h"
#include "engine/molecule/drawn_atoms.h"
#include "engine/molecule/kabsch_sander.h"
#include "engine/scene/appearance.h"
#include "engine/scene/colors.h"

namespace nacre::app {
namespace {

constexpr int kBlock = 10;  // letters between two gaps

/// Where letters stand.
struct Letters {
    ImVec2 at;
    float cell, line, gap, left;
    int perLine, count;

    int lines() const { return (count + perLine - 1) / perLine; }
    ImVec2 placeOf(int i) const {
        const int in = i % perLine;
        return {at.x + left + static_cast<float>(in) * cell + static_cast<float>(in / kBlock) * gap,
                at.y + static_cast<float>(i / perLine) * line};
    }
    /// -1: none
    int under(ImVec2 point) const {
        const int row = static_cast<int>((point.y - at.y) / line);
        if (point.y < at.y || row >= lines()) return -1;
        for (int i = row * perLine; i < std::min((row + 1) * perLine, count); ++i)
            if (const float x = placeOf(i).x; point.x >= x - gap / 2 && point.x < x + cell) return i;
        return -1;
    }
};

/// Of each residue the colour that its first seen atom is drawn in; 0: none is seen, or copies have colours of their
/// own.
std::vector<std::uint32_t> residueColors(const Molecule& molecule, const SavedView& view) {
    const Appearance seen = appearanceOf(molecule, drawnAtoms(molecule, view.drawn), view.look);
    std::vector<std::uint32_t> colors(molecule.residues.size());
    const auto take = [&](const std::vector<std::uint32_t>& atoms, const std::vector<std::uint32_t>& of) {
        for (std::size_t i = 0; i < atoms.size(); ++i) {
            std::uint32_t& color = colors[molecule.atoms[atoms[i]].residue];
            if (color == 0 && !isCopyTint(of[i])) color = of[i];
        }
    };
    take(seen.cartoon.atoms, seen.cartoon.colors);
    take(seen.atoms, seen.colors);
    take(seen.surface.atoms, seen.surface.colors);
    return colors;
}

/// A helix as a bar, a strand as a line that ends in an arrow, what is neither as a thin line.
void drawFold(ImDrawList& list, SecondaryStructure fold, bool last, ImVec2 low, ImVec2 high, ImU32 ink, float unit) {
    const float y = std::round((low.y + high.y) / 2);
    if (fold == SecondaryStructure::helix) return list.AddRectFilled(low, high, ink);
    const bool strand = fold == SecondaryStructure::strand;
    const float half = strand ? unit : unit / 2;
    const float end = strand && last ? high.x - 5 * unit : high.x;
    list.AddRectFilled(ImVec2(low.x, y - half), ImVec2(end, y + half), ink);
    if (strand && last)
        list.AddTriangleFilled(ImVec2(end, low.y - unit), ImVec2(high.x, y), ImVec2(end, high.y + unit), ink);
}

}  // namespace

/// Selects what lies between two residues of the sequence.
void Panel::selectResidues(Viewer& viewer) {
    const std::vector<std::uint32_t>& sequence = state_->sequence;
    const auto [low, high] = std::minmax(state_->dragFrom, state_->dragTo);
    viewer.select(residuesText(*state_->molecule, sequence[static_cast<std::size_t>(low)],
                               sequence[static_cast<std::size_t>(high)], state_->sequenceInput));
}

void Panel::drawSequence(const Part& part, const SavedView& look, Viewer& viewer) {
    Widgets& ui = state_->ui;
    State& s = *state_;
    if (s.sequence.empty()) return;
    if (s.folds.empty()) s.folds = secondaryStructure(*s.molecule);
    if (s.residueColors.empty() || s.colored != std::pair(look.look, look.drawn.hydrogens)) {
        s.residueColors = residueColors(*s.molecule, look);
        s.colored = {look.look, look.drawn.hydrogens};
    }
    Letters letters{};
    letters.cell = ui.px(forFingers() ? 20 : 11.5f), letters.line = ui.px(forFingers() ? 42 : 31);
    letters.gap = ui.px(6), letters.left = ui.px(36);
    const float room = ImGui::GetContentRegionAvail().x - letters.left;
    letters.perLine =
        kBlock * std::max(static_cast<int>((room + letters.gap) / (kBlock * letters.cell + letters.gap)), 1);
    letters.count = static_cast<int>(s.sequence.size());
    letters.at = ImGui::GetCursorScreenPos();
    ImGui::InvisibleButton(
        "##sequence", ImVec2(ImGui::GetContentRegionAvail().x, letters.line * static_cast<float>(letters.lines())));
    ui.ringFocus();
    ui.note("sequence", "Sequence of " + part.name, viewer.selection().text);
    const int under = letters.under(ImGui::GetIO().MousePos);
    if (ImGui::IsItemActivated() && under >= 0) s.dragFrom = s.dragTo = under;
    if (ImGui::IsItemActive() && under >= 0 && s.dragFrom >= 0) {
        s.dragTo = under;
        selectResidues(viewer);
    }
    s.alongSequence = ImGui::IsItemFocused() && ImGui::GetIO().NavVisible;
    if (const int step = std::exchange(s.sequenceStep, 0); step != 0 && s.alongSequence) {
        s.dragTo = s.dragTo < 0 ? 0 : std::clamp(s.dragTo + step, 0, letters.count - 1);
        if (!s.sequenceExtends || s.dragFrom < 0) s.dragFrom = s.dragTo;
        selectResidues(viewer);
    }
    const bool hovered = ImGui::IsItemHovered() && under >= 0;
    const auto [low, high] = std::minmax(s.dragFrom, s.dragTo);
    const ImDrawList& list = *ImGui::GetWindowDrawList();
    for (int i = 0; i < letters.count; ++i) {
        const ImVec2 p = letters.placeOf(i);
        if (p.y + letters.line < list.GetClipRectMin().y || p.y > list.GetClipRectMax().y) continue;
        drawLetter(i, p, ImVec2(letters.cell, letters.line), low >= 0 && i >= low && i <= high, hovered && i == under);
        if (i % letters.perLine == 0)
            drawResidueNumber(i, ImVec2(letters.at.x + letters.left - ui.px(5), p.y), letters.line);
    }
    if (hovered) {
        const Residue& residue = s.molecule->residues[s.sequence[static_cast<std::size_t>(under)]];
        ImGui::SetTooltip("%s %d", std::string(residue.name.view()).c_str(), residue.number);
    }
    ui.caption("Above: colours as drawn; bars are helices, arrows are strands.");
}

/// @param i  of the sequence
void Panel::drawLetter(int i, ImVec2 p, ImVec2 size, bool chosen, bool hovered) {
    const Widgets& ui = state_->ui;
    const Theme& theme = ui.theme();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const std::uint32_t r = state_->sequence[static_cast<std::size_t>(i)];
    const SecondaryStructure fold = state_->folds[r];
    const bool more = i + 1 < static_cast<int>(state_->sequence.size());
    const bool last = !more || state_->folds[state_->sequence[static_cast<std::size_t>(i) + 1]] != fold;
    const float above = ui.px(14);
    if (chosen)
        list.AddRectFilled(ImVec2(p.x, p.y + above), ImVec2(p.x + size.x, p.y + size.y - ui.px(2)),
                           ImGui::GetColorU32(theme.accent));
    if (const std::uint32_t color = state_->residueColors[r]; color != 0)
        list.AddRectFilled(ImVec2(p.x, p.y + ui.px(5)), ImVec2(p.x + size.x, p.y + ui.px(8)), color | 0xff000000);
    drawFold(list, fold, last, ImVec2(p.x, p.y + ui.px(10)), ImVec2(p.x + size.x, p.y + ui.px(13)),
             ImGui::GetColorU32(theme.faint), ui.px(1));
    const char letter[2] = {letterOf(state_->molecule->residues[r]), '\0'};
    const float width = ImGui::CalcTextSize(letter).x;
    const ImVec4& ink = chosen ? theme.onAccent : hovered ? theme.mark : theme.text;
    list.AddText(ImVec2(std::round(p.x + (size.x - width) / 2),
                        std::round(p.y + (size.y + above - ui.px(2) - ImGui::GetFontSize()) / 2)),
                 ImGui::GetColorU32(ink), letter);
}

/// The number of the first residue of a line, to the left of it.
void Panel::drawResidueNumber(int i, ImVec2 right, float line) {
    const Widgets& ui = state_->ui;
    const std::string number =
        std::to_string(state_->molecule->residues[state_->sequence[static_cast<std::size_t>(i)]].number);
    ImGui::PushFont(fontOf(TextSize::caption));
    ImGui::GetWindowDrawList()->AddText(ImVec2(std::round(right.x - ImGui::CalcTextSize(number.c_str()).x),
                                               std::round(right.y + (line + ui.px(12) - ImGui::GetFontSize()) / 2)),
                                        ImGui::GetColorU32(ui.theme().faint), number.c_str());
    ImGui::PopFont();
}

}  // namespace nacre::app
