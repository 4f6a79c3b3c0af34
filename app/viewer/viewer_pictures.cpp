// Words of pictures that are kept or shared.

#include "app/annotation/painter.h"
#include "app/viewer/viewer.h"
#include "engine/scene/orientation.h"

namespace nacre::app {

RenderSettings Viewer::pictureWithWords(PixelSize size, double textSize) const {
    constexpr std::size_t kMany = 200000;  // spheres and vertices: their sphere is nearly as good
    RenderSettings settings = pictureSettings(size);
    const Camera camera = view().camera;
    if (!placedWords_.any() || camera.zoom != 1 || camera.pan != glm::dvec2(0)) return settings;
    const Representation& scene = document_.scene;
    std::vector<glm::dvec4> balls{{0, 0, 0, settings.view.radius}};
    if (scene.drawnAtoms + scene.meshVertices.size() < kMany) balls = drawnBalls(scene);
    settings.view = WordPainter().besideWords(settings.view, placedWords_, textSize, balls, camera.zoom);
    return settings;
}

void Viewer::paintWords(const View& view, double size, bool transparent, Picture& picture) const {
    const SavedView saved = savedView();
    std::array<float, 4> background = saved.background;
    if (transparent) background = {0, 0, 0, 0};
    WordPainter().paint(placeWords(saved.words, *document_.placed, document_.scene, WordsOfHidden::leftOut), view, size,
                        saved.words.color, background, picture, saved.effects.clip);
}

}  // namespace nacre::app
