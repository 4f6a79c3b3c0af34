// What a view shows of copies, by cameras that a picture seldom has.
#include "engine/lists/seen_copies.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

namespace nacre::test {
namespace {

/// @param parts  spheres with the same copies, of which there is one
SphereLevels makeLevels(const std::vector<std::vector<Sphere>>& parts, Representation& r) {
    r = {};
    r.copies.transforms = {glm::dmat4x3(1.0)};
    r.copies.lists = {{0}};
    for (const std::vector<Sphere>& part : parts) {
        r.copies.spheres.push_back({static_cast<std::uint32_t>(r.spheres.size()),
                                    static_cast<std::uint32_t>(part.size()), 0, part.front().center, 100});
        for (const Sphere& s : part) {
            r.spheres.push_back(s);
            r.sphereLooks.push_back({0xffffffff, static_cast<std::uint32_t>(r.spheres.size())});
        }
    }
    return makeSphereLevels(r);
}

/// 200 x 200 pixels, the eye at 100 Å.
ScreenView eyeView() {
    ScreenView view;
    view.width = view.height = 200;
    view.perspective = true;
    view.axis = {100, 100};
    view.origin = 100;
    view.range = 300;
    return view;
}

std::vector<std::uint32_t> seenBy(const ScreenView& view, const SphereLevels& levels, const Representation& r) {
    SeenCopies seen;
    seen.draw(view, {levels, r.copies}, 0.5f, 1, false);
    std::vector<std::uint32_t> atoms;
    for (const SphereLook& look : seen.looks()) atoms.push_back(look.atom);
    return atoms;
}

TEST(SeenCopies, ShowWhatIsBeforeTheEyeOfAPartAboutIt) {
    Representation r;
    const SphereLevels levels = makeLevels({{{{0, 0, 180}, 2}, {{0, 0, 20}, 2}}}, r);
    EXPECT_EQ(seenBy(eyeView(), levels, r), std::vector<std::uint32_t>{2});
}

// Far beside the axis a sphere's picture is an ellipse, a third narrower than it is long.
TEST(SeenCopies, ShowWhatIsBesideAnEllipse) {
    for (int turns = 0; turns < 4; ++turns) {
        ScreenView view = eyeView();
        view.quarterTurns = turns;
        const glm::vec3 way = glm::normalize(glm::vec3(1, -1, 0));
        const glm::vec3 large(80, 80, 0), beside = (large * 1.02f + way * 12.5f) * 1.5f + glm::vec3(0, 0, -50);
        Representation r;
        const SphereLevels levels = makeLevels({{{large, 10}}, {{beside, 1.5f}}}, r);
        EXPECT_EQ(seenBy(view, levels, r).size(), 2u) << turns;
        // Behind it nothing shows.
        const SphereLevels hidden = makeLevels({{{large, 10}}, {{large * 1.5f + glm::vec3(0, 0, -50), 1.5f}}}, r);
        EXPECT_EQ(seenBy(view, hidden, r), std::vector<std::uint32_t>{1}) << turns;
    }
}

}  // namespace
}  // namespace nacre::test
