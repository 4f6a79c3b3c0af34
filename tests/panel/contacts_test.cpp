// Pockets and interactions from the panel.

#include "app/annotation/measurement.h"
#include "tests/panel/panel_bench.h"

namespace nacre::app::test {
namespace {

TEST(PanelContacts, APocketIsShownAndItsInteractionsAreFlownTo) {
    Bench b("sample:dna", {1300, 1200});
    b.viewer.picking().select("chain A and resi 4");
    b.panel.showPage("Select");
    b.settle();
    EXPECT_TRUE(b.viewer.document()->drawing.scene().contacts.empty());
    b.click("Show pocket");
    b.settle();
    const PictureDescription& view = b.viewer.view();
    EXPECT_EQ(view.look.style, Style::cartoon);
    ASSERT_TRUE(view.look.contacts.of);
    EXPECT_EQ(view.look.contacts.of->text, "chain A and resi 4");
    ASSERT_FALSE(b.viewer.document()->drawing.scene().contacts.empty());
    for (int i = 0; i < 200; ++i) b.frame();  // it flies there
    const double zoom = b.viewer.view().camera.zoom;
    EXPECT_GT(zoom, 1.5);
    const Interaction& first = b.viewer.document()->drawing.scene().contacts.front().interaction;
    const std::string said = contactText(*b.viewer.document()->molecule, first);
    b.click(said.substr(said.find(' ', said.find(' ') + 1) + 1));
    for (int i = 0; i < 200; ++i) b.frame();
    EXPECT_NE(b.viewer.view().camera.zoom, zoom);
    b.click("Hide interactions");
    b.settle();
    EXPECT_TRUE(b.viewer.document()->drawing.scene().contacts.empty());
}

}  // namespace
}  // namespace nacre::app::test
