#include "app/mvs/molstar_radii.h"

#include <iterator>

namespace nacre::app::mvs {
namespace {

// From hydrogen to meitnerium, as in Mol* 5.6.
constexpr float kRadii[] = {
    1.1f,  1.4f,  1.81f, 1.53f, 1.92f, 1.7f,  1.55f, 1.52f, 1.47f, 1.54f, 2.27f, 1.73f, 1.84f, 2.1f,  1.8f,  1.8f,
    1.75f, 1.88f, 2.75f, 2.31f, 2.3f,  2.15f, 2.05f, 2.05f, 2.05f, 2.05f, 2,     2,     2,     2.1f,  1.87f, 2.11f,
    1.85f, 1.9f,  1.83f, 2.02f, 3.03f, 2.49f, 2.4f,  2.3f,  2.15f, 2.1f,  2.05f, 2.05f, 2,     2.05f, 2.1f,  2.2f,
    2.2f,  1.93f, 2.17f, 2.06f, 1.98f, 2.16f, 3.43f, 2.68f, 2.5f,  2.48f, 2.47f, 2.45f, 2.43f, 2.42f, 2.4f,  2.38f,
    2.37f, 2.35f, 2.33f, 2.32f, 2.3f,  2.28f, 2.27f, 2.25f, 2.2f,  2.1f,  2.05f, 2,     2,     2.05f, 2.1f,  2.05f,
    1.96f, 2.02f, 2.07f, 1.97f, 2.02f, 2.2f,  3.48f, 2.83f, 2,     2.4f,  2,     2.3f,  2,     2,     2,     2,
    2,     2,     2,     2,     2,     2,     2,     2,     2,     2,     2,     2,     2};
constexpr float kUnknown = 1.7f;

}  // namespace

float molstarRadius(Element element) {
    if (isHydrogen(element)) return kRadii[0];  // deuterium
    const auto number = static_cast<std::size_t>(element);
    return number >= 1 && number <= std::size(kRadii) ? kRadii[number - 1] : kUnknown;
}

}  // namespace nacre::app::mvs
