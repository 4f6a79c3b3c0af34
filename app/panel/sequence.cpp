// The sequence of a chain: one letter per residue, with its colour, and its fold above. A click selects one residue; a
// drag, or Shift with the arrow keys, several.

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/panel/panel_state.h"

namespace nacre::app {
namespace {

constexpr int kBlock = 10;  // letters between two gaps

/// Layout of the letters.
struct Letters {
    ImVec2 at;
    float cell, line, gap, left;
    int perLine, count;

    int lines() const { return (count + perLine - 1) / perLine; }
    ImVec2 cellPosition(int i) const {
        const int in = i % perLine;
        return {at.x + left + static_cast<float>(in) * cell + static_cast<float>(in / kBlock) * gap,
                at.y + static_cast<float>(i / perLine) * line};
    }
    /// Index of the letter at a point; -1: none.
    int under(ImVec2 point) const {
        const int row = static_cast<int>((point.y - at.y) / line);
        if (point.y < at.y || row >= lines()) return -1;
        for (int i = row * perLine; i < std::min((row + 1) * perLine, count); ++i)
            if (const float x = cellPosition(i).x; point.x >= x - gap / 2 && point.x < x + cell) return i;
        return -1;
    }
};

/// The drawn colour of each residue; 0: none, or copies have different colours.
std::vector<std::uint32_t> residueColors(const Molecule& molecule, const Representation& scene) {
    const std::vector<std::uint32_t> drawn = drawnColors(molecule, scene);
    std::vector<std::uint32_t> colors(molecule.residues.size());
    for (std::size_t atom = 0; atom < drawn.size(); ++atom) {
        std::uint32_t& color = colors[molecule.atoms[atom].residue];
        if (color == 0) color = drawn[atom];
    }
    return colors;
}

/// A helix as a bar, a strand as an arrow, everything else as a thin line.
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

/// Selects the residues between two positions of the sequence.
void selectResidues(PanelFrame& f) {
    const std::vector<std::uint32_t>& sequence = f.s.sequence.residues;
    const auto [low, high] = std::minmax(f.s.sequence.dragFrom, f.s.sequence.dragTo);
    f.viewer.picking().select(residuesText(*f.s.molecule, sequence[static_cast<std::size_t>(low)],
                                           sequence[static_cast<std::size_t>(high)], f.s.sequence.input));
}

/// @param i  position in the sequence
void drawLetter(PanelFrame& f, int i, ImVec2 p, ImVec2 size, bool chosen, bool hovered) {
    const Theme& theme = f.ui.theme();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const std::uint32_t r = f.s.sequence.residues[static_cast<std::size_t>(i)];
    const SecondaryStructure fold = f.s.facts->folds()[r];
    const bool more = i + 1 < static_cast<int>(f.s.sequence.residues.size());
    const bool last = !more || f.s.facts->folds()[f.s.sequence.residues[static_cast<std::size_t>(i) + 1]] != fold;
    const float above = f.ui.px(14);
    if (chosen)
        list.AddRectFilled(ImVec2(p.x, p.y + above), ImVec2(p.x + size.x, p.y + size.y - f.ui.px(2)),
                           ImGui::GetColorU32(theme.accent));
    if (const std::uint32_t color = f.s.sequence.colors[r]; color != 0)
        list.AddRectFilled(ImVec2(p.x, p.y + f.ui.px(5)), ImVec2(p.x + size.x, p.y + f.ui.px(8)), color | 0xff000000);
    drawFold(list, fold, last, ImVec2(p.x, p.y + f.ui.px(10)), ImVec2(p.x + size.x, p.y + f.ui.px(13)),
             ImGui::GetColorU32(theme.faint), f.ui.px(1));
    const char letter[2] = {residueLetter(f.s.molecule->residues[r]), '\0'};
    const float width = ImGui::CalcTextSize(letter).x;
    const ImVec4& ink = chosen ? theme.onAccent : hovered ? theme.mark : theme.text;
    f.ui.write(ImVec2(p.x + (size.x - width) / 2, p.y + (size.y + above - f.ui.px(2) - ImGui::GetFontSize()) / 2),
               ImGui::GetColorU32(ink), letter);
}

/// The number of a line's first residue, at its left.
void drawResidueNumber(PanelFrame& f, int i, ImVec2 right, float line) {
    const std::string number =
        std::to_string(f.s.molecule->residues[f.s.sequence.residues[static_cast<std::size_t>(i)]].number);
    ImGui::PushFont(findFont(TextSize::caption));
    f.ui.write(ImVec2(right.x - ImGui::CalcTextSize(number.c_str()).x,
                      right.y + (line + f.ui.px(12) - ImGui::GetFontSize()) / 2),
               ImGui::GetColorU32(f.ui.theme().faint), number);
    ImGui::PopFont();
}

}  // namespace

void drawSequence(PanelFrame& f, const Part& part) {
    if (f.s.sequence.residues.empty()) return;
    const Drawing& drawing = f.viewer.document()->drawing;
    if (f.s.sequence.colors.empty() || f.s.sequence.colorsScene != drawing.sceneNumber()) {
        f.s.sequence.colors = residueColors(*f.s.molecule, drawing.scene());
        f.s.sequence.colorsScene = drawing.sceneNumber();
    }
    Letters letters{};
    letters.cell = f.ui.px(f.ui.forFingers() ? 20 : 11.5f), letters.line = f.ui.px(f.ui.forFingers() ? 42 : 31);
    letters.gap = f.ui.px(6), letters.left = f.ui.px(36);
    const float room = ImGui::GetContentRegionAvail().x - letters.left;
    letters.perLine =
        kBlock * std::max(static_cast<int>((room + letters.gap) / (kBlock * letters.cell + letters.gap)), 1);
    letters.count = static_cast<int>(f.s.sequence.residues.size());
    letters.at = ImGui::GetCursorScreenPos();
    ImGui::InvisibleButton(
        "##sequence", ImVec2(ImGui::GetContentRegionAvail().x, letters.line * static_cast<float>(letters.lines())));
    f.ui.ringFocus();
    f.ui.note("sequence", "Sequence of " + part.name, f.viewer.picking().selection().text);
    const int under = letters.under(ImGui::GetIO().MousePos);
    if (ImGui::IsItemActivated() && under >= 0) f.s.sequence.dragFrom = f.s.sequence.dragTo = under;
    if (ImGui::IsItemActive() && under >= 0 && f.s.sequence.dragFrom >= 0) {
        f.s.sequence.dragTo = under;
        selectResidues(f);
    }
    f.s.sequence.focused = ImGui::IsItemFocused() && ImGui::GetIO().NavVisible;
    if (const int step = std::exchange(f.s.sequence.step, 0); step != 0 && f.s.sequence.focused) {
        f.s.sequence.dragTo =
            f.s.sequence.dragTo < 0 ? 0 : std::clamp(f.s.sequence.dragTo + step, 0, letters.count - 1);
        if (!f.s.sequence.extends || f.s.sequence.dragFrom < 0) f.s.sequence.dragFrom = f.s.sequence.dragTo;
        selectResidues(f);
    }
    const bool hovered = ImGui::IsItemHovered() && under >= 0;
    const auto [low, high] = std::minmax(f.s.sequence.dragFrom, f.s.sequence.dragTo);
    const ImDrawList& list = *ImGui::GetWindowDrawList();
    for (int i = 0; i < letters.count; ++i) {
        const ImVec2 p = letters.cellPosition(i);
        if (p.y + letters.line < list.GetClipRectMin().y || p.y > list.GetClipRectMax().y) continue;
        drawLetter(f, i, p, ImVec2(letters.cell, letters.line), low >= 0 && i >= low && i <= high,
                   hovered && i == under);
        if (i % letters.perLine == 0)
            drawResidueNumber(f, i, ImVec2(letters.at.x + letters.left - f.ui.px(5), p.y), letters.line);
    }
    if (hovered) {
        const Residue& residue = f.s.molecule->residues[f.s.sequence.residues[static_cast<std::size_t>(under)]];
        ImGui::SetTooltip("%s %d", std::string(residue.name.view()).c_str(), residue.number);
    }
    f.ui.caption("Above: colours as drawn; bars are helices, arrows are strands.");
}

}  // namespace nacre::app
