// Density maps in the panel.

#include "app/input/map_input.h"
#include "tests/panel/panel_bench.h"

namespace nacre::app::test {
namespace {

TEST(MapsPanel, ChoosesWhereMapsAreDrawn) {
    keepMap("flat",
            std::make_shared<const DensityMap>(mapOfValues("flat", glm::ivec3(10), {glm::dvec3(10), glm::dvec3(90)}, {},
                                                           false, std::vector<float>(1000, 1))));
    Bench b("sample:dna", kTall);
    PictureDescription look = b.viewer.view();
    look.maps.files = {"flat"};
    b.viewer.setLook(look, b.now);
    b.panel.showPage(Panel::Page::look);
    b.settle();
    const auto choose = [&](const char* place) {
        for (int i = 0; i < 40 && !b.find("Place of maps", "list"); ++i) {
            b.panel.input().pointer({50, 500});
            b.panel.input().wheel(-1);
            b.frame();
        }
        b.click("Place of maps");
        b.click(place);
    };
    const MapOptions& maps = b.viewer.view().maps;
    choose("Around the centre of the view");
    EXPECT_TRUE(maps.aroundFocus);
    EXPECT_TRUE(b.find("Radius of maps"));
    ASSERT_TRUE(b.viewer.document());
    EXPECT_TRUE(b.viewer.document()->maps.focus);
    EXPECT_GT(expectReadable(b, "maps"), 10u);
    choose("Around ligands");
    EXPECT_FALSE(maps.aroundFocus);
    EXPECT_EQ(maps.around, parseSelection("ligand"));
    choose("Around: default");
    EXPECT_FALSE(maps.around);
    EXPECT_FALSE(b.find("Radius of maps"));
}

}  // namespace
}  // namespace nacre::app::test
