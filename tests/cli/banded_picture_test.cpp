// A picture that is drawn in bands while it is written: the very one that is drawn at once, words and all.

#include "app/cli/banded_picture.h"

#include <gtest/gtest.h>

#include "app/annotation/painter.h"
#include "app/drawing/drawing.h"
#include "app/images/image_codec.h"
#include "engine/molecule/read.h"

namespace nacre::app {
namespace {

TEST(BandedPicture, IsThePictureThatIsDrawnAtOnce) {
    PictureDescription options;
    options.input.path = "sample:dna";
    options.size = {301, 203};
    options.occlusion.directions = 16;
    options.input.cache = "off";
    options.effects.contours = {2, 1.5, 3, {0, 0, 0}};
    options.effects.halos.width = 5;
    options.words.title = "DNA^{2+}";
    options.words.scaleBar = ScaleBar::nanometre;
    options.words.legend = true;
    options.words.labels.push_back(parseLabel("name P={residue}{number}"));
    const Molecule molecule = sampleMolecule("dna");
    Drawing prepared;
    prepared.prepare(molecule, options);
    Canvas canvas{DeviceOptions{}};
    Renderer& renderer = canvas.renderer;
    prepared.show(canvas);
    const View& view = prepared.settings.view;
    EXPECT_FALSE(isBanded(renderer, prepared.settings));
    Picture whole = renderer.render(prepared.settings);
    const std::uint64_t covered = renderer.stats().coveredPixels;
    const std::vector<std::string> said = prepared.addWords(prepared.settings, whole);

    const WordPainter painter;
    Marks marks = painter.layOut(prepared.words, view, options.words.size, options.words.color, options.background);
    EXPECT_EQ(painter.listWarnings(marks), said);
    double share = 0;
    // Bands of 64 rows, in parts of 128 columns.
    BandedPicture banded(renderer, prepared.settings, [&](double done) { share = done; }, {301 * 100, 170});
    banded.setMarks(painter, std::move(marks));
    std::size_t differing = 0;
    for (std::uint32_t row = 0; row < view.height; row += kRowsAtOnce) {
        const float* rows = banded.rows(row);
        const std::size_t values = std::size_t{4} * view.width * std::min(kRowsAtOnce, view.height - row);
        for (std::size_t i = 0; i < values; ++i)
            differing += rows[i] != whole.rgba[std::size_t{4} * view.width * row + i];
    }
    EXPECT_EQ(differing, 0u);
    EXPECT_EQ(share, 1);
    EXPECT_EQ(banded.parts(), 12u);
    EXPECT_EQ(banded.stats().coveredPixels, covered);
}

TEST(BandedPicture, IsForWhatIsLarge) {
    const Renderer renderer{DeviceOptions{}};
    const auto banded = [&](std::uint32_t width, std::uint32_t height, std::uint32_t supersample) {
        RenderSettings s;
        s.view.width = width, s.view.height = height, s.supersample = supersample;
        return isBanded(renderer, s);
    };
    EXPECT_FALSE(banded(4096, 4096, RenderSettings::kEdges));
    EXPECT_TRUE(banded(4096, 4097, RenderSettings::kEdges));
    EXPECT_TRUE(banded(1024, 1025, 4));
    EXPECT_TRUE(banded(renderer.maxSize() + 1, 1, 1));
}

}  // namespace
}  // namespace nacre::app
