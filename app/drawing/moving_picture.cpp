#include "app/drawing/moving_picture.h"

#include "app/drawing/scenes.h"

namespace nacre::app {

MovingPicture::MovingPicture(const ResidueFacts& facts, const PictureDescription& picture, Recolor recolor)
    : scene_(buildMovingScene(facts, picture)),
      radius_(scene_.scene().radius),
      recolor_(std::move(recolor)),
      surfaces_(facts, picture) {
    if (picture.maps.surface.file.empty()) return;
    Representation first = scene_.scene();
    surfaces_(first);
}

Representation MovingPicture::moved(const Molecule& molecule) {
    scene_.move(molecule);
    Representation scene = scene_.scene();
    if (recolor_) recolor_(scene);
    surfaces_(scene);
    return scene;
}

}  // namespace nacre::app
