#include "engine/passes/plates.h"

#include <cmath>

namespace nacre::passes {

PlateShape choosePlates(PlateShape wanted, const graph::GeometryCaps& caps, double radiusPixels) {
    if (wanted != PlateShape::automatic) return wanted;
    if (radiusPixels >= caps.domes) return PlateShape::dome3;
    return radiusPixels >= caps.plateOctagons ? PlateShape::octagon : PlateShape::square;
}

ImpostorShape chooseImpostor(ImpostorShape wanted, const graph::GeometryCaps& caps, double radiusPixels, bool flat) {
    if (wanted == ImpostorShape::automatic)
        wanted = radiusPixels >= caps.domes      ? ImpostorShape::pyramid
                 : radiusPixels >= caps.octagons ? ImpostorShape::octagon
                                                 : ImpostorShape::square;
    return wanted == ImpostorShape::pyramid && flat ? ImpostorShape::octagon : wanted;
}

double steadyRadius(double before, double now, const graph::GeometryCaps& caps) {
    constexpr double kWidth = 7.0 / 6;
    if (before <= 0) return now;
    for (const double threshold : {caps.domes, caps.octagons, caps.plateOctagons}) {
        if ((before >= threshold) == (now >= threshold)) continue;
        if (now < threshold && now * kWidth >= threshold) now = threshold;
        if (now >= threshold && before < threshold && now < threshold * kWidth) now = std::nextafter(threshold, 0.0);
    }
    return now;
}

std::span<const Plate> listPlates(PlateShape shape) {
    static constexpr Plate kSquare[]{{4, 0.98516f}}, kDome2[]{{8, 0.98516f}, {8, 0.75f}},
        kDome3[]{{8, 0.98516f}, {8, 0.86f}, {8, 0.6f}};
    if (shape == PlateShape::square) return kSquare;
    if (shape == PlateShape::octagon) return std::span(kDome2).first(1);
    if (shape == PlateShape::dome2) return kDome2;
    if (shape == PlateShape::dome3) return kDome3;
    return {};
}

}  // namespace nacre::passes
