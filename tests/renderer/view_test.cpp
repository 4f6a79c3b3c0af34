// What a hand does to the view: panning, turning the image for a display, picking.

#include <cmath>
#include <type_traits>

#include "engine/error.h"
#include "engine/gpu/pipeline_cache.h"
#include "engine/molecule/read.h"
#include "tests/renderer/scenes.h"

namespace nacre::test {
namespace {

RenderSettings oblong(const Representation& r, Projection projection) {
    Camera camera{.projection = projection, .rotationDegrees = {20, 30, 10}, .zoom = 1.3};
    RenderSettings s{.view = makeView(camera, r.radius, 150, 110), .supersample = 1};
    s.occlusion.directions = 0;
    return s;
}

TEST(View, ThoseThatCannotBeDrawnAreErrors) {
    const Representation r = scene("sample:glucose", Style::ballAndStick);
    ValidatedRenderer renderer(Visibility::automatic, r);
    const RenderSettings good = oblong(r, Projection::orthographic);
    const auto refuses = [&](const auto& change) {
        RenderSettings s = good;
        if constexpr (std::is_invocable_v<decltype(change), View&>)
            change(s.view);
        else
            change(s);
        EXPECT_THROW(renderer->render(s), Error);
        EXPECT_THROW(renderer->renderCoded(s, false), Error);
        EXPECT_THROW(renderer->startCoded(s, false), Error);
        EXPECT_THROW(renderer->layers(s), Error);
        EXPECT_THROW(renderer->drawFrame(s), Error);
        EXPECT_EQ(renderer->started(), 0u);
    };
    refuses([](View& view) { view.width = view.height = 0; });
    refuses([](View& view) { view.height = 0; });
    refuses([](View& view) { view.rotation[1][2] = NAN; });
    refuses([](View& view) { view.pixelsPerAngstrom = INFINITY; });
    refuses([](View& view) { view.pan.x = NAN; });
    refuses([](View& view) { view.pixelsPerAngstrom = 0; });
    refuses([](View& view) { view.radius = -1; });
    refuses([](View& view) { view.projection = Projection::perspective; });  // without an eye
    refuses([](RenderSettings& s) { s.occlusion.directions = -5; });
    refuses([](RenderSettings& s) { s.occlusion.directions = 1 << 30; });
    refuses([](RenderSettings& s) { s.background[0] = NAN; });
    refuses([](RenderSettings& s) { s.effects.contours.width = NAN; });
    refuses([](RenderSettings& s) { s.effects.clip.near = NAN; });
    EXPECT_FALSE(renderer->render(good).rgba.empty());
    // Without a surface there is no window.
    EXPECT_THROW(renderer->present(good, {}), Error);
    EXPECT_THROW(renderer->windowSize(), Error);
    EXPECT_THROW(renderer->setOverlayGlyphs({}), Error);
    renderer->awaitFrame();
}

TEST(View, AtomsThatAreNotThereAreErrors) {
    const Molecule molecule = sampleMolecule("glucose");
    const std::uint32_t beyond[] = {0, static_cast<std::uint32_t>(molecule.atoms.size())};
    EXPECT_THROW(represent(molecule, beyond, {}), Error);
}

TEST(View, PanningByWholePixelsMovesThePictureByThem) {
    const Representation r = scene("sample:glucose", Style::ballAndStick);
    for (const Visibility path : devicePaths()) {
        ValidatedRenderer renderer(path, r);
        for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
            RenderSettings s = oblong(r, projection);
            const LayerPicture still = renderer->layers(s);
            s.view.pan = glm::dvec2(13, -7) / s.view.pixelsPerAngstrom;  // right and down
            const LayerPicture moved = renderer->layers(s);
            std::size_t covered = 0, differing = 0;
            for (int y = 7; y < 110; ++y)
                for (int x = 13; x < 150; ++x) {
                    const auto to = static_cast<std::size_t>(y * 150 + x), from = to - 7 * 150 - 13;
                    covered += still.id[from] != 0;
                    differing += still.id[from] != moved.id[to];
                }
            EXPECT_GT(covered, 1000u);
            EXPECT_LE(differing, 2u);  // the shift itself is rounded to 24 bits
        }
    }
}

TEST(View, ATurnedImageIsThePictureTurnedBitForBit) {
    const Representation r = scene("sample:glucose", Style::ballAndStick);
    for (const Visibility path : devicePaths()) {
        ValidatedRenderer renderer(path, r);
        for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
            RenderSettings s = oblong(r, projection);
            s.view.pan = glm::dvec2(13.25, -7.5) / s.view.pixelsPerAngstrom;  // what a float holds exactly, turned too
            const Picture upright = renderer->render(s);
            const int w = 150, h = 110;
            for (int turns = 1; turns < 4; ++turns) {
                s.view.quarterTurns = turns;
                const Picture turned = renderer->render(s);
                ASSERT_EQ(turned.width, turns == 2 ? 150u : 110u);
                std::size_t differing = 0;
                for (int y = 0; y < h; ++y)
                    for (int x = 0; x < w; ++x) {
                        // Clockwise, as VK_SURFACE_TRANSFORM_ROTATE_90_BIT_KHR has it.
                        const int tx = turns == 1 ? h - 1 - y : turns == 2 ? w - 1 - x : y;
                        const int ty = turns == 1 ? x : turns == 2 ? h - 1 - y : w - 1 - x;
                        for (int c = 0; c < 4; ++c)
                            differing +=
                                upright.rgba[static_cast<std::size_t>((y * w + x) * 4 + c)] !=
                                turned
                                    .rgba[static_cast<std::size_t>((ty * static_cast<int>(turned.width) + tx) * 4 + c)];
                    }
                EXPECT_EQ(differing, 0u) << turns;
            }
        }
    }
}

TEST(View, TheAtomUnderAPixelIsThatOfTheLayers) {
    const Representation r = scene("sample:dna", Style::spacefill);
    for (const Visibility path : devicePaths()) {
        ValidatedRenderer renderer(path, r);
        for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
            const RenderSettings s = oblong(r, projection);
            const LayerPicture layers = renderer->layers(s);
            for (int y = 3; y < 110; y += 24)
                for (int x = 2; x < 150; x += 19)
                    EXPECT_EQ(renderer->atomAt(s, x + 0.5, y + 0.5, 0),
                              layers.id[static_cast<std::size_t>(y * 150 + x)])
                        << x << " " << y;
        }
    }
}

TEST(View, AFingerFindsTheNearestAtomWithinItsReach) {
    const Representation r = scene("sample:glucose", Style::ballAndStick);
    ValidatedRenderer renderer(Visibility::automatic, r);
    const RenderSettings s = oblong(r, Projection::orthographic);
    const LayerPicture layers = renderer->layers(s);
    int found = 0;
    for (int y = 5; y < 110; y += 8)
        for (int x = 5; x < 150; x += 8) {
            double nearest = 1e9;
            for (int j = 0; j < 110; ++j)
                for (int i = 0; i < 150; ++i)
                    if (layers.id[static_cast<std::size_t>(j * 150 + i)])
                        nearest = std::min(nearest, std::hypot(i - x, j - y));
            const std::uint32_t atom = renderer->atomAt(s, x + 0.5, y + 0.5, 9);
            if (nearest <= 8.9 || nearest > 9.2) {
                EXPECT_EQ(atom != 0, nearest <= 8.9) << x << " " << y;
            }
            bool thatNear = atom == 0;
            for (int j = 0; j < 110; ++j)
                for (int i = 0; i < 150; ++i)
                    thatNear = thatNear || (layers.id[static_cast<std::size_t>(j * 150 + i)] == atom &&
                                            std::hypot(i - x, j - y) <= nearest + 1e-9);
            EXPECT_TRUE(thatNear) << x << " " << y;
            found += atom != 0;
        }
    EXPECT_GT(found, 20);
}

TEST(PipelineCache, OneOfAnotherDeviceIsDroppedAndItsOwnIsTaken) {
    const Representation r = scene("sample:glucose", Style::ballAndStick);
    const auto draw = [&](const std::vector<std::byte>& cache) {
        Renderer renderer(DeviceOptions{.validate = true, .pipelineCache = cache});
        renderer.setScene(r);
        const Picture picture = renderer.render(oblong(r, Projection::orthographic));
        EXPECT_TRUE(renderer.validationMessages().empty());
        return std::pair(picture.rgba, renderer.pipelineCache());
    };
    const auto [picture, cache] = draw({});
    ASSERT_GE(cache.size(), 32u);
    EXPECT_EQ(draw(cache).first, picture);
    for (const std::size_t at : {4u, 8u, 12u, 16u, 31u}) {  // version, vendor, device, UUID
        std::vector<std::byte> foreign = cache;
        foreign[at] ^= std::byte{0x40};
        EXPECT_EQ(draw(foreign).first, picture);
    }
    EXPECT_EQ(draw({cache.begin(), cache.begin() + 20}).first, picture);
}

TEST(PipelineCache, TheHeaderMustNameTheDevice) {
    vk::PhysicalDeviceProperties properties;
    properties.vendorID = 0x13b5;
    properties.deviceID = 0x1234;
    for (std::size_t i = 0; i < VK_UUID_SIZE; ++i) properties.pipelineCacheUUID[i] = static_cast<std::uint8_t>(i);
    VkPipelineCacheHeaderVersionOne header{};
    header.headerSize = sizeof header;
    header.headerVersion = VK_PIPELINE_CACHE_HEADER_VERSION_ONE;
    header.vendorID = 0x13b5;
    header.deviceID = 0x1234;
    for (std::size_t i = 0; i < VK_UUID_SIZE; ++i) header.pipelineCacheUUID[i] = static_cast<std::uint8_t>(i);
    std::vector<std::byte> bytes(sizeof header + 10);
    std::memcpy(bytes.data(), &header, sizeof header);
    EXPECT_TRUE(gpu::isOwnPipelineCache(properties, bytes));
    EXPECT_FALSE(gpu::isOwnPipelineCache(properties, std::span(bytes).first(31)));
    EXPECT_FALSE(gpu::isOwnPipelineCache(properties, {}));
    for (std::size_t i = 0; i < sizeof header; ++i) {
        std::vector<std::byte> other = bytes;
        other[i] ^= std::byte{1};
        EXPECT_FALSE(gpu::isOwnPipelineCache(properties, other)) << i;
    }
}

}  // namespace
}  // namespace nacre::test
