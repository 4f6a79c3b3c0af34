// Dashes of interactions: one picture, one number and one depth on every path, and picked as anything else.

#include "tests/renderer/scenes.h"

namespace nacre::test {
namespace {

Representation boundStrands() {
    const Molecule m = molecule("sample:dna");
    RepresentationOptions options{Style::licorice, ColorScheme::element};
    options.contacts.of = parseSelection("all");
    options.contacts.width = 0.3;
    return represent(m, drawnAtoms(m), options);
}

struct ContactCase {
    const char* name;
    Projection projection = Projection::orthographic;
    bool clip = false;
};
void PrintTo(const ContactCase& c, std::ostream* out) { *out << c.name; }

class ContactScenes : public SharedRenderers<ContactCase> {};

TEST_P(ContactScenes, AreTheSameOnEveryPath) {
    const Representation r = boundStrands();
    ASSERT_GT(r.contacts.size(), 20u);
    RenderSettings s = settings(r, 96, GetParam().projection, {20, 30, 10}, 2);
    s.occlusion.directions = 4;
    if (GetParam().clip) s.effects.clip = {-2, 12, Clip::Cap::plain};
    FirstPicture picture;
    for (const Visibility visibility : devicePaths())
        picture.expectSame(sharedRenderer(visibility, r), s, visibilityName(visibility));
    const LayerPicture& first = picture.layers;
    std::size_t dashed = 0, dark = 0, missed = 0;
    for (std::uint32_t i = 0; i < first.id.size(); ++i) {
        if (!r.findContact(first.id[i])) continue;
        dark += first.occlusion[i] < 1;
        if (++dashed % 60 == 0)
            missed += sharedRenderer(Visibility::tiles)->atomAt(s, i % 96 + 0.5, i / 96 + 0.5, 0) != first.id[i];
    }
    EXPECT_GT(dashed, 120u);
    EXPECT_GT(dark, dashed / 2);  // between the bases it is dark
    EXPECT_EQ(missed, 0u);
}

INSTANTIATE_TEST_SUITE_P(Dashes, ContactScenes,
                         testing::Values(ContactCase{"Ortho"}, ContactCase{"Perspective", Projection::perspective},
                                         ContactCase{"Cut", Projection::orthographic, true}),
                         [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
}  // namespace nacre::test
