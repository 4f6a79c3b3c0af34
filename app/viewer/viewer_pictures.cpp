// Words of pictures that are kept or shared.

#include "app/shared/word_painter.h"
#include "app/viewer/viewer.h"

namespace nacre::app {

void Viewer::paintWords(const View& view, double size, bool transparent, Picture& picture) const {
    const SavedView saved = savedView();
    std::array<float, 4> background = saved.background;
    if (transparent) background = {0, 0, 0, 0};
    WordPainter().paint(placeWords(saved.words, *document_.placed, document_.scene, WordsOfHidden::leftOut), view, size,
                        saved.words.color, background, picture, saved.effects.clip);
}

}  // namespace nacre::app
