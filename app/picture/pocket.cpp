#include "app/picture/pocket.h"

#include "app/picture/appearance_values.h"
#include "app/picture/option_text.h"

namespace nacre::app {

void applyPocket(std::string_view text, PictureDescription& d) {
    const Selection ligand = parseSelection(text);
    const std::string it = "(" + std::string(text) + ")";
    const std::string around = "byres (within " + numberText(kPocketReach) + " of " + it + ")";
    d.look.style = Style::cartoon;
    d.look.color = Coloring::uniform(0xffc8c4be);  // a pale grey, as background
    d.look.cartoonOpacity = 0.3;
    const Rule rules[] = {parseShow(around + "=licorice"), parseColorBy(around + "=element:#b8b8b0"),
                          parseColorBy(it + "=element:#e8b04b")};
    d.look.rules.insert(d.look.rules.begin(), std::begin(rules), std::end(rules));
    d.look.contacts.of = ligand;
    d.look.contacts.with.reset();
    d.words.labels.insert(d.words.labels.begin(),
                          parseLabel(around + " and polymer and not " + it + "={residue} {number}"));
    d.words.seenOnly = true;
    d.aim.lookAt = ligand;
    d.aim.zoomTo = ligand;
    d.aim.uncovers = false;  // residues in front of the ligand may bind it
}

}  // namespace nacre::app
