// Every look, as `nacre looks` draws them: the same picture on every path, and what it was when it was last looked at.

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "tests/support/run_program.h"

namespace nacre {
namespace {

using test::nacreDone;
using test::readContents;
using test::TemporaryFolder;

std::string drawnBy(const TemporaryFolder& folder, const std::string& options) {
    nacreDone(folder,
              "looks sample:dna -o sheet.png --rotate 0,30,0 --occlusion 16 --cache off --validate --size " + options);
    return readContents(folder / "sheet.png");
}

TEST(LooksSheet, IsTheSameOnEveryPathWithoutAWordFromValidation) {
    const TemporaryFolder folder;
    const std::string sheet = drawnBy(folder, "96x96 --supersample 1 --visibility tiles");
    for (const char* path : {"encoded", "fragdepth", "deferred", "raster-order"}) {
        const std::string other = drawnBy(folder, std::string("96x96 --supersample 1 --visibility ") + path);
        EXPECT_EQ(other == sheet, true) << path;
    }
}

std::vector<std::uint8_t> readPicture(const std::string& path, std::size_t& width) {
    const auto input = OIIO::ImageInput::open(path);
    if (!input) throw std::runtime_error(path + ": " + OIIO::geterror());
    width = static_cast<std::size_t>(input->spec().width);
    std::vector<std::uint8_t> bytes(input->spec().image_bytes());
    input->read_image(0, 0, 0, input->spec().nchannels, OIIO::TypeDesc::UINT8, bytes.data());
    return bytes;
}

/// The golden is lavapipe's by tiles. What other drivers and paths may differ by, of 255: on average, and where more
/// than a little does: edges, whose samples other paths take from a grid.
constexpr double kMostOnAverage = 0.75, kLittle = 10, kMostShare = 0.01;

TEST(LooksSheet, IsWhatItWasWhenItWasLookedAt) {
    const TemporaryFolder folder;
    for (const auto& [name, options] : {std::pair{"looks_sheet", "96x96 --visibility tiles"},
                                        {"looks_sheet", "96x96 --visibility fragdepth"},
                                        {"looks_cartoon_sheet", "80x80 --style cartoon"},
                                        {"looks_surface_sheet", "64x64 --style surface --zoom 2"}}) {
        drawnBy(folder, options);
        std::size_t width = 0, goldenWidth = 0;
        const std::vector<std::uint8_t> drawn = readPicture(folder / "sheet.png", width),
                                        wanted = readPicture(
                                            std::string(NACRE_SOURCE_DIR) + "/tests/cli/" + name + ".png", goldenWidth);
        ASSERT_EQ(drawn.size(), wanted.size());
        ASSERT_EQ(width, goldenWidth);
        double sum = 0, far = 0;
        for (std::size_t i = 0; i < drawn.size(); ++i) {
            const double apart = std::abs(int{drawn[i]} - int{wanted[i]});
            sum += apart;
            far += apart > kLittle;
        }
        EXPECT_LE(sum / static_cast<double>(drawn.size()), kMostOnAverage) << options;
        EXPECT_LE(far / static_cast<double>(drawn.size()), kMostShare) << options;
    }
}

}  // namespace
}  // namespace nacre
