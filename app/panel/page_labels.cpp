// The page of words in the picture: labels, measurements, title, scale and legend, all saved with it.

#include <string>

#include "app/panel/panel_state.h"
#include "app/picture/option_text.h"
#include "app/picture/words.h"

namespace nacre::app {
namespace {

/// A measurement's atoms and value; while the atoms are not drawn, its text as written.
std::string rowText(const Measure& measure, const PlacedWords& placed) {
    for (const PlacedMeasure& at : placed.measures)
        if (at.of == measure.text) return at.text + ", " + at.atoms;
    return "Atoms " + measure.text;
}

/// A row each, with a button that removes it. @param id  of the first row
template <typename Word, typename GetText>
void listWords(PanelFrame& f, int id, std::vector<Word>& words, GetText getText) {
    const float side = f.ui.rowHeight();
    std::erase_if(words, [&](const Word& word) {
        ImGui::PushID(id++);
        const float x = ImGui::GetCursorPosX(), room = ImGui::GetContentRegionAvail().x;
        f.ui.name(getText(word), room - side - f.ui.px(8));
        ImGui::SameLine(x + room - side);
        const bool gone = f.ui.sign(Icon::close, "Remove");
        ImGui::PopID();
        return gone;
    });
}

}  // namespace

void drawLabelsPage(PanelFrame& f) {
    Words& words = f.look.words;
    f.ui.caption("Included in saved images and views.");
    f.ui.heading("Title");
    if (!f.s.typingTitle) f.s.title = words.title;
    f.ui.field("Title", "None", f.s.title);
    f.s.typingTitle = ImGui::IsItemActive();
    if (f.ui.edited()) f.s.take([&] { words.title = parseTitle(f.s.title); });
    if (!f.s.ruleError.empty()) f.ui.warning(f.s.ruleError);
    toggleOption(f, "legend");
    toggleOption(f, "axes");
    f.ui.heading("Scale bar");
    chooseOption(f, "scale-bar");
    f.ui.heading("Measurements");
    Picking& picking = f.viewer.picking();
    constexpr const char* kModes[] = {"Off", "Distances", "Angles", "Torsion angles"};
    Measuring measuring = picking.measuring();
    if (f.ui.choose("Measure", kModes, measuring)) picking.measure(measuring);
    if (measuring != Measuring::off)
        f.ui.caption((f.ui.forFingers() ? "Tap " : "Click ") + std::to_string(picking.mostPicks()) +
                     " atoms. One more starts again.");
    if (picking.picks().size() > 1) {
        f.ui.paragraph(picking.annotations().measurement);
        if (f.ui.button(Icon::none, "Pin measurement")) f.host.run(ViewerCommand::keepMeasurement);
    }
    listWords(f, 0, words.measures,
              [&](const Measure& measure) { return rowText(measure, f.viewer.words().placed()); });
    f.ui.heading("Labels");
    if (words.labels.empty())
        f.ui.caption("Choose atoms under \"Select\", then \"Label\".");
    else
        toggleOption(f, "show-labels");
    listWords(f, 1000, words.labels, [](const Label& label) { return selectionWords(label.selection.text); });
}

}  // namespace nacre::app
