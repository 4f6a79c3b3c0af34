#include "app/images/image_file.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <limits>
#include <vector>

#include "app/picture/picture_names.h"
#include "engine/error.h"
#include "engine/srgb.h"
#include "tests/support/temporary_folder.h"

namespace nacre::app {
namespace {

using test::TemporaryFolder;

// Wide and high enough that rows are written in several goes.
constexpr std::uint32_t kWidth = 37, kHeight = 150;

/// What is off over black and over white, both together: a straight pixel mixed as code values. None but what is
/// rounded.
template <typename At>
double offTogether(const At& at, const std::array<float, 4>& light) {
    double worst = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        const double share = at(3), mixed = at(c) * share;
        const double black = mixed - linearToSrgb(light[c]);
        const double white = mixed + 1 - share - linearToSrgb(light[c] + 1 - light[3]);
        worst = std::max(worst, std::abs(black + white));
    }
    return worst;
}

/// A ramp of light, its left half at half coverage.
std::vector<float> ramp() {
    std::vector<float> rgba;
    for (std::uint32_t y = 0; y < kHeight; ++y)
        for (std::uint32_t x = 0; x < kWidth; ++x) {
            const float alpha = x < kWidth / 2 ? 0.5f : 1.0f;
            const float light = static_cast<float>(y) / static_cast<float>(kHeight);
            rgba.insert(rgba.end(), {alpha * light, alpha * 0.25f, alpha * (1 - light), alpha});
        }
    return rgba;
}

struct ReadBack {
    OIIO::ImageSpec spec;
    std::vector<float> values;
    float at(std::uint32_t x, std::uint32_t y, std::size_t channel) const {
        return values[(std::size_t{y} * kWidth + x) * static_cast<std::size_t>(spec.nchannels) + channel];
    }
    /// Position of a channel by name, since EXR files keep an order of their own.
    std::size_t channel(const std::string& name) const { return static_cast<std::size_t>(spec.channelindex(name)); }
};

ReadBack readBack(const std::string& path) {
    OIIO::ImageSpec config;
    config.attribute("oiio:UnassociatedAlpha", 1);
    const auto input = OIIO::ImageInput::open(path, &config);
    if (!input) throw std::runtime_error(OIIO::geterror());
    ReadBack result{input->spec(), {}};
    result.values.resize(result.spec.image_pixels() * static_cast<std::size_t>(result.spec.nchannels));
    input->read_image(0, 0, 0, result.spec.nchannels, OIIO::TypeDesc::FLOAT, result.values.data());
    return result;
}

void write(const std::string& path, const std::vector<float>& rgba, bool alpha) {
    OutputFile file(path);
    writePicture(file, Picture{kWidth, kHeight, rgba}, {alpha});
}

TEST(ImageFile, KnowsItsExtensionsInAnyCase) {
    for (const char* name : {"a.png", "b.PNG", "c.tif", "d.Tiff", "e.jpg", "f.jpeg", "g.webp", "folder.x/g.exr", "-"})
        EXPECT_TRUE(isPictureName(name)) << name;
    for (const char* name : {"", "png", "a", "a.bmp", "a.png.gz", "folder.png/a"})
        EXPECT_FALSE(isPictureName(name)) << name;
}

TEST(ImageFile, StraightAlphaInPngAndTiff) {
    const TemporaryFolder folder;
    for (const char* name : {"a.png", "a.tif"}) {
        write(folder / name, ramp(), true);
        const ReadBack back = readBack(folder / name);
        ASSERT_EQ(back.spec.nchannels, 4) << name;
        ASSERT_EQ(back.spec.format, OIIO::TypeDesc::UINT8) << name;
        EXPECT_NEAR(back.at(kWidth - 1, 100, 0), linearToSrgb(100.0f / kHeight), 0.003f) << name;
        EXPECT_NEAR(back.at(kWidth - 1, 100, 1), linearToSrgb(0.25f), 0.003f) << name;
        const std::array<float, 4> light{0.5f * 100 / kHeight, 0.125f, 0.5f - 0.5f * 100 / kHeight, 0.5f};
        EXPECT_LT(offTogether([&](std::size_t c) { return back.at(0, 100, c); }, light), 0.006) << name;
        EXPECT_EQ(back.at(kWidth - 1, 100, 3), 1.0f) << name;
    }
}

/// What a browser shows of code values with alpha over black (0) or white (1).
double mixed(std::uint8_t code, std::uint8_t alpha, double ground) {
    return code / 255.0 * alpha / 255.0 + (1 - alpha / 255.0) * ground;
}

TEST(ImageFile, AlphaMixedAsBrowsersDoIsThePictureOnBlackAndOnWhite) {
    double sum = 0;
    int count = 0;
    for (int share = 0; share <= 16; ++share)
        for (int r = 0; r <= 8; ++r)
            for (int g = 0; g <= 8; ++g) {
                const float a = static_cast<float>(share) / 16;
                const float light[] = {srgbToLinear(static_cast<float>(r) / 8) * a,
                                       srgbToLinear(static_cast<float>(g) / 8) * a, srgbToLinear(0.5f) * a, a};
                std::uint8_t code[4];
                codePixel(light, true, code);
                if (share == 0 || share == 16) {
                    EXPECT_EQ(code[3], share == 0 ? 0 : 255);
                }
                for (int c = 0; c < 3; ++c) {
                    const double onBlack = linearToSrgb(light[c]), onWhite = linearToSrgb(light[c] + 1 - a);
                    const double offBlack = mixed(code[c], code[3], 0) - onBlack;
                    const double offWhite = mixed(code[c], code[3], 1) - onWhite;
                    if (r == 4 && g == 4) {  // gray is exact
                        EXPECT_NEAR(offBlack, 0, 1.1 / 255) << share;
                        EXPECT_NEAR(offWhite, 0, 1.1 / 255) << share;
                    }
                    sum += offBlack * offBlack + offWhite * offWhite;
                    count += 2;
                }
            }
    // Of all colours, at all shares; straight alpha of linear light comes to 21 dB.
    EXPECT_GT(10 * std::log10(count / sum), 26);
}

TEST(ImageFile, WithoutAlphaWhatIsOpenIsOverWhite) {
    const TemporaryFolder folder;
    for (const char* name : {"a.png", "a.tiff", "a.jpg"}) {
        write(folder / name, ramp(), std::string(name) == "a.jpg");
        const ReadBack back = readBack(folder / name);
        ASSERT_EQ(back.spec.nchannels, 3) << name;
        EXPECT_NEAR(back.at(2, 75, 1), linearToSrgb(0.125f + 0.5f), 0.02f) << name;
        EXPECT_NEAR(back.at(kWidth - 3, 75, 1), linearToSrgb(0.25f), 0.02f) << name;
    }
}

TEST(ImageFile, CodedPicturesGiveTheSameFile) {
    const TemporaryFolder folder;
    for (const char* name : {"a.png", "a.tiff", "a.jpg", "a.webp"})
        for (const bool alpha : {false, true}) {
            const PictureFormat format{alpha, 8, 300};
            OutputFile file(folder / name), other(folder / (std::string("other_") + name));
            const Picture picture{kWidth, kHeight, ramp()};
            writePicture(file, picture, format);
            writePicture(other, coded(picture, hasAlpha(format, name)), format.dpi);
            EXPECT_EQ(test::readContents(folder / name), test::readContents(folder / (std::string("other_") + name)))
                << name;
        }
}

TEST(ImageFile, SixteenBitsInPngAndTiff) {
    const TemporaryFolder folder;
    for (const char* name : {"a.png", "a.tif"}) {
        OutputFile file(folder / name);
        writePicture(file, Picture{kWidth, kHeight, ramp()}, {true, 16});
        const ReadBack back = readBack(folder / name);
        ASSERT_EQ(back.spec.nchannels, 4) << name;
        ASSERT_EQ(back.spec.format, OIIO::TypeDesc::UINT16) << name;
        for (std::uint32_t y = 0; y < kHeight; y += 7)
            EXPECT_NEAR(back.at(kWidth - 1, y, 0), linearToSrgb(static_cast<float>(y) / kHeight), 1.1f / 65535) << name;
        const std::array<float, 4> light{0.5f * 100 / kHeight, 0.125f, 0.5f - 0.5f * 100 / kHeight, 0.5f};
        EXPECT_LT(offTogether([&](std::size_t c) { return back.at(0, 100, c); }, light), 3.0 / 65535) << name;
    }
}

TEST(ImageFile, PngSaysWhoWroteItAndThatItsColoursAreSrgb) {
    const TemporaryFolder folder;
    write(folder / "a.png", ramp(), true);
    const OIIO::ImageSpec spec = readBack(folder / "a.png").spec;
    EXPECT_EQ(spec.get_string_attribute("Software"), "nacre");
    EXPECT_EQ(spec.get_string_attribute("oiio:ColorSpace"), "sRGB");
    const std::string bytes = test::readContents(folder / "a.png");
    for (const char* chunk : {"sRGB", "gAMA", "cHRM"}) EXPECT_NE(bytes.find(chunk), std::string::npos) << chunk;
    EXPECT_EQ(bytes.at(bytes.find("sRGB") + 4), 0);  // perceptual
}

TEST(ImageFile, OthersHaveTheProfileOfSrgb) {
    const TemporaryFolder folder;
    for (const char* name : {"a.jpg", "a.tif", "a.webp"})
        for (const bool alpha : {false, true}) {
            write(folder / name, ramp(), alpha);
            const std::string bytes = test::readContents(folder / name);
            // A header of ICC.1: RGB of a display; tests/python has LittleCMS read it.
            const std::size_t header = bytes.find("mntrRGB XYZ ");
            ASSERT_NE(header, std::string::npos) << name;
            EXPECT_EQ(bytes.substr(header + 24, 4), "acsp") << name;
            const ReadBack back = readBack(folder / name);
            EXPECT_EQ(back.spec.nchannels, alpha && name != std::string("a.jpg") ? 4 : 3) << name;
            EXPECT_NEAR(back.at(kWidth - 3, 75, 1), linearToSrgb(0.25f), 0.02f) << name;
        }
}

TEST(ImageFile, PngIsCompressedFast) {
    const TemporaryFolder folder;
    write(folder / "a.png", ramp(), true);
    const std::string bytes = test::readContents(folder / "a.png");
    const std::size_t data = bytes.find("IDAT");
    ASSERT_NE(data, std::string::npos);
    // The second byte of what zlib writes says how it did (RFC 1950): 1 fast, 2 by default.
    EXPECT_EQ(static_cast<unsigned char>(bytes.at(data + 5)) >> 6, 1);
}

TEST(ImageFile, APngHasEachByte) {
    const TemporaryFolder folder;
    for (const bool alpha : {false, true}) {
        CodedPicture picture{97, 75, alpha, {}};
        std::uint32_t noise = 1;
        for (std::size_t i = 0; i < picture.channels() * 97 * 75; ++i)
            picture.bytes.push_back(static_cast<std::uint8_t>((noise = noise * 1664525 + 1013904223) >> 24));
        OutputFile file(folder / "a.png");
        writePicture(file, picture, 0);
        const ReadBack back = readBack(folder / "a.png");
        ASSERT_EQ(back.values.size(), picture.bytes.size());
        std::size_t differing = 0;
        for (std::size_t i = 0; i < back.values.size(); ++i)
            differing += std::lround(back.values[i] * 255) != picture.bytes[i];
        EXPECT_EQ(differing, 0u);
    }
}

TEST(ImageFile, DotsAnInchAreSaid) {
    const TemporaryFolder folder;
    for (const char* name : {"a.png", "a.tif", "a.jpg"}) {
        OutputFile file(folder / name);
        writePicture(file, Picture{kWidth, kHeight, ramp()}, {false, 8, 254});
        const OIIO::ImageSpec spec = readBack(folder / name).spec;
        const double unit = spec.get_string_attribute("ResolutionUnit") == "cm" ? 2.54 : 1;
        EXPECT_NEAR(spec.get_float_attribute("XResolution") * unit, 254, 0.01) << name;
        EXPECT_NEAR(spec.get_float_attribute("YResolution") * unit, 254, 0.01) << name;
    }
}

TEST(ImageFile, WebpIsWithoutLoss) {
    const TemporaryFolder folder;
    for (const bool alpha : {false, true}) {
        write(folder / "a.webp", ramp(), alpha);
        write(folder / "a.png", ramp(), alpha);
        const ReadBack webp = readBack(folder / "a.webp"), png = readBack(folder / "a.png");
        ASSERT_EQ(webp.spec.nchannels, alpha ? 4 : 3);
        ASSERT_EQ(webp.values.size(), png.values.size());
        for (std::size_t i = 0; i < png.values.size(); ++i) {
            const float share = alpha && i % 4 != 3 ? png.values[i / 4 * 4 + 3] : 1;  // which the reader multiplies by
            EXPECT_NEAR(webp.values[i], png.values[i] * share, share < 1 ? 0.6f / 255 : 0) << i;
        }
    }
}

TEST(ImageFile, ExrKeepsLinearPremultipliedLight) {
    const TemporaryFolder folder;
    write(folder / "a.exr", ramp(), false);
    const ReadBack back = readBack(folder / "a.exr");
    ASSERT_EQ(back.spec.nchannels, 4);
    EXPECT_EQ(back.spec.format, OIIO::TypeDesc::HALF);
    EXPECT_EQ(back.at(0, 75, 0), 0.25f);
    EXPECT_EQ(back.at(0, 75, 1), 0.125f);
    EXPECT_EQ(back.at(0, 75, 3), 0.5f);
}

TEST(ImageFile, EqualPicturesAreEqualFiles) {
    const TemporaryFolder folder;
    for (const char* extension : {".png", ".tif", ".jpg", ".webp", ".exr"}) {
        write(folder / "one" + extension, ramp(), true);
        // OpenImageIO would write the time of day in seconds.
        usleep(1100000);
        write(folder / "two" + extension, ramp(), true);
        EXPECT_EQ(test::readContents(folder / "one" + extension), test::readContents(folder / "two" + extension))
            << extension;
        EXPECT_GT(test::readContents(folder / "one" + extension).size(), 100u);
    }
}

TEST(ImageFile, LayersKeepEveryBit) {
    const TemporaryFolder folder;
    const std::size_t pixels = kWidth * kHeight;
    std::vector<float> z(pixels, std::numeric_limits<float>::infinity()), normal(pixels * 3), occlusion(pixels);
    std::vector<std::uint32_t> id(pixels, 0);
    for (std::size_t i = 0; i < pixels / 2; ++i) {
        z[i] = 1.0f / static_cast<float>(i + 3);
        normal[3 * i + 2] = std::nextafter(1.0f, 0.0f);
        occlusion[i] = static_cast<float>(i) / 7.0f;
        id[i] = static_cast<std::uint32_t>(1032840 + i);
    }
    {
        OutputFile file(folder / "l.exr");
        writeLayers(file, {kWidth, kHeight, ramp(), z, normal, occlusion, id});
    }
    const ReadBack back = readBack(folder / "l.exr");
    ASSERT_EQ(back.spec.nchannels, 10);
    for (const char* name : {"R", "G", "B", "A", "Z", "N.X", "N.Y", "N.Z", "id.Y", "occlusion.Y"})
        ASSERT_GE(back.spec.channelindex(name), 0) << name;
    EXPECT_EQ(back.spec.format, OIIO::TypeDesc::FLOAT);
    for (std::uint32_t y = 0; y < kHeight; ++y)
        for (std::uint32_t x = 0; x < kWidth; ++x) {
            const std::size_t i = std::size_t{y} * kWidth + x;
            ASSERT_EQ(back.at(x, y, back.channel("Z")), z[i]);
            ASSERT_EQ(back.at(x, y, back.channel("N.Z")), normal[3 * i + 2]);
            ASSERT_EQ(back.at(x, y, back.channel("id.Y")), static_cast<float>(id[i]));
            ASSERT_EQ(back.at(x, y, back.channel("occlusion.Y")), occlusion[i]);
            ASSERT_EQ(back.at(x, y, back.channel("R")), ramp()[4 * i]);
            if (x > 3) x += 7;  // ramp() is slow; a grid of pixels will do
        }
}

TEST(OutputFile, LeavesNothingBehindUnlessCommitted) {
    const TemporaryFolder folder;
    {
        OutputFile file(folder / "a.txt");
        EXPECT_EQ(folder.count(), 1u);
        EXPECT_FALSE(std::filesystem::exists(folder / "a.txt"));
        EXPECT_EQ(fileExtension(file.temporary()), ".txt");
    }
    EXPECT_EQ(folder.count(), 0u);
    OutputFile file(folder / "a.txt");
    writeText(file, "whole");
    EXPECT_EQ(folder.count(), 1u);
    EXPECT_EQ(test::readContents(folder / "a.txt"), "whole");
}

TEST(OutputFile, ASignalLeavesNothingBehind) {
    const TemporaryFolder folder;
    EXPECT_EXIT(
        {
            const OutputFile one(folder / "a.png");
            const OutputFile two(folder / "b.json");
            std::raise(folder.count() == 2 ? SIGTERM : SIGABRT);
        },
        testing::KilledBySignal(SIGTERM), "");
    EXPECT_EQ(folder.count(), 0u);
}

TEST(OutputFile, KeepsTheOldFileUntilTheNewOneIsWhole) {
    const TemporaryFolder folder;
    std::ofstream(folder / "a.txt") << "old";
    { OutputFile abandoned(folder / "a.txt"); }
    EXPECT_EQ(test::readContents(folder / "a.txt"), "old");
    OutputFile file(folder / "a.txt");
    writeText(file, "new");
    EXPECT_EQ(test::readContents(folder / "a.txt"), "new");
}

TEST(OutputFile, ReplacesWhatALinkPointsTo) {
    const TemporaryFolder folder;
    std::ofstream(folder / "real.txt") << "old";
    std::filesystem::create_symlink("real.txt", folder / "link.txt");
    OutputFile file(folder / "link.txt");
    writeText(file, "new");
    EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.txt"));
    EXPECT_EQ(test::readContents(folder / "real.txt"), "new");
}

TEST(OutputFile, RefusesFoldersAndMissingFolders) {
    const TemporaryFolder folder;
    EXPECT_THROW(OutputFile(folder.path()), Error);
    EXPECT_THROW(OutputFile(folder / "none/a.txt"), Error);
    EXPECT_THROW(OutputFile("/dev/null"), Error);
    EXPECT_EQ(folder.count(), 0u);
}

}  // namespace
}  // namespace nacre::app
