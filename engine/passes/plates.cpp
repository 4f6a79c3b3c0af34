#include "engine/passes/plates.h"

#include <array>

namespace nacre::passes {

std::span<const Plate> platesOf(PlateShape shape) {
    static constexpr std::array kSquare{Plate{4, 0.98516f}};
    static constexpr std::array kOctagon{Plate{8, 0.98516f}};
    static constexpr std::array kDome2{Plate{8, 0.98516f}, Plate{8, 0.75f}};
    static constexpr std::array kDome3{Plate{8, 0.98516f}, Plate{8, 0.86f}, Plate{8, 0.6f}};
    switch (shape) {
        case PlateShape::none: return {};
        case PlateShape::square: return kSquare;
        case PlateShape::octagon: return kOctagon;
        case PlateShape::dome2: return kDome2;
        case PlateShape::dome3: return kDome3;
    }
    return {};
}

}  // namespace nacre::passes
