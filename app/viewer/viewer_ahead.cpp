// What a file is going to be drawn with is made while it is read.

#include <utility>
#include <vector>

#include "app/viewer/viewer.h"
#include "engine/error.h"
#include "engine/molecule/drawn_atoms.h"
#include "engine/molecule/read.h"

namespace nacre::app {
namespace {

/// Something in a style, small: what has no backbone makes no cartoon.
Representation standIn(RepresentationOptions look, Style style) {
    look.style = style;
    look.rules.clear();
    look.assembly.clear();
    const Molecule m = sampleMolecule(style == Style::cartoon ? "dna" : "glucose");
    return represent(m, drawnAtoms(m), look);
}

}  // namespace

void Viewer::expectScene(const WindowFrame& frame) {
    if (!loader_.busy()) return;
    const SavedView& coming = loader_.view();
    std::vector<Style> styles{Style::spacefill, Style::cartoon};  // of which firstLook() chooses
    if (coming.look.style) styles = {*coming.look.style};
    if (styles == expected_) return;
    expected_ = styles;
    RenderSettings s = settings();
    try {
        for (const Style style : styles) {
            Representation like = standIn(coming.look, style);
            Camera camera;
            camera.projection = view_.camera.projection;
            s.view = viewOf(camera, like.radius, size_.width, size_.height);
            screen_.expectScene(std::move(like), s, frame);
        }
    } catch (const Error&) {
        // What is read meets the same, or has nothing to do with it.
    }
}

}  // namespace nacre::app
