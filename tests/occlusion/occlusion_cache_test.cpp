// A kept bake draws the same picture as a fresh one, and whatever happens to the file is no error.

#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>
#include <string_view>

#include "engine/occlusion/cache.h"
#include "tests/renderer/scenes.h"
#include "tests/support/temporary_folder.h"

namespace nacre::test {
namespace {

namespace fs = std::filesystem;

class OcclusionCache : public testing::TestWithParam<Style> {
protected:
    struct Run {
        Picture picture;
        LayerPicture layers;
        OcclusionStats stats;
        std::vector<bool> seen;
    };

    Run run(const std::function<void(RenderSettings&)>& change = {}) {
        const Representation r = scene("sample:dna", GetParam());
        ValidatedRenderer renderer(Visibility::automatic, r);
        RenderSettings s = settings(r, 128, Projection::orthographic);
        s.occlusion.directions = 16;
        s.occlusion.cache = folder_ / "cache";
        s.occlusion.worthKeeping = 0;
        if (change) change(s);
        Run run{renderer->render(s), {}, renderer->stats().occlusion, renderer->seenSpheres()};
        run.layers = renderer->layers(s);
        return run;
    }
    static void expectSame(const Run& a, const Run& b) {
        EXPECT_EQ(a.picture.rgba, b.picture.rgba);
        EXPECT_EQ(a.layers.occlusion, b.layers.occlusion);
        EXPECT_EQ(a.seen, b.seen);
        EXPECT_EQ(a.stats.neverSeen, b.stats.neverSeen);
        EXPECT_EQ(a.stats.texels, b.stats.texels);
        EXPECT_EQ(a.stats.patchTexels, b.stats.patchTexels);
        EXPECT_EQ(a.stats.done, b.stats.done);
    }
    std::vector<fs::path> files() const {
        std::vector<fs::path> list;
        if (fs::exists(folder_ / "cache"))
            for (const auto& entry : fs::directory_iterator(folder_ / "cache"))
                if (entry.path().filename() != "CACHEDIR.TAG") list.push_back(entry.path());
        return list;
    }

    TemporaryFolder folder_;
};

TEST_P(OcclusionCache, AHitIsTheSamePictureWithoutABake) {
    const Run fresh = run();
    EXPECT_FALSE(fresh.stats.cached);
    ASSERT_EQ(files().size(), 1u);
    const Run hit = run();
    EXPECT_TRUE(hit.stats.cached);
    expectSame(fresh, hit);
    EXPECT_EQ(files().size(), 1u);
}

TEST_P(OcclusionCache, OtherSettingsAreOtherBakes) {
    const bool usual = std::string_view(run().stats.maps) == "fragdepth";
    const OcclusionMaps other = usual ? OcclusionMaps::encoded : OcclusionMaps::fragdepth;
    EXPECT_FALSE(run([](RenderSettings& s) { s.occlusion.directions = 15; }).stats.cached);
    EXPECT_FALSE(run([](RenderSettings& s) { s.occlusion.bytes /= 2; }).stats.cached);
    EXPECT_FALSE(run([&](RenderSettings& s) { s.occlusion.maps = other; }).stats.cached);
    EXPECT_EQ(files().size(), 4u);
    EXPECT_TRUE(run([](RenderSettings& s) { s.lighting = false; }).stats.cached);
}

TEST_P(OcclusionCache, ADamagedFileIsBakedAnewAndReplaced) {
    const Run fresh = run();
    const fs::path file = files().at(0);
    const std::string whole = readContents(file.string());
    const auto put = [&](const std::string& content) { std::ofstream(file, std::ios::binary) << content; };
    std::string flipped = whole;
    flipped[whole.size() / 2] = static_cast<char>(flipped[whole.size() / 2] ^ 4);
    for (const std::string& damaged : {whole.substr(0, whole.size() / 2), flipped, std::string()}) {
        put(damaged);
        const Run again = run();
        EXPECT_FALSE(again.stats.cached);
        expectSame(fresh, again);
        EXPECT_EQ(readContents(file.string()), whole);
    }
}

TEST_P(OcclusionCache, AFolderThatCannotBeWrittenToIsNoError) {
    std::ofstream(folder_ / "cache") << "a file in the way";
    EXPECT_FALSE(run().stats.cached);
    EXPECT_FALSE(run().stats.cached);
}

TEST_P(OcclusionCache, QuickBakesAndThoseWithoutAFolderAreNotKept) {
    run([](RenderSettings& s) { s.occlusion.worthKeeping = 1e9; });
    EXPECT_EQ(files().size(), 0u);
    run([](RenderSettings& s) { s.occlusion.cache.clear(); });
    EXPECT_EQ(files().size(), 0u);
}

TEST_P(OcclusionCache, KeepsBouncedLightForItsColours) {
    const auto bounce = [](RenderSettings& s) { s.occlusion.bounce = true; };
    const Run fresh = run(bounce);
    EXPECT_EQ(files().size(), 2u);  // a bake, and the atlas with bounced light
    expectSame(fresh, run(bounce));
    EXPECT_EQ(files().size(), 2u);
    run();
    EXPECT_EQ(files().size(), 3u);
    // The light is what the file says.
    std::size_t changed = 0;
    for (const fs::path& file : files()) {
        const DiskCache cache = occlusionCache(file.parent_path().string());
        auto kept = readOcclusion(cache, file.filename().string(), scene("sample:dna", GetParam()));
        ASSERT_TRUE(kept);
        if (!kept->bounced) continue;
        // Too tall for a device whose images end within the second half.
        EXPECT_FALSE(readOcclusion(cache, file.filename().string(), scene("sample:dna", GetParam()),
                                   2 * kept->layout.height - 1));
        for (std::uint8_t& texel : kept->atlas) texel = 0;
        ASSERT_TRUE(writeOcclusion(cache, file.filename().string(), *kept));
        ++changed;
    }
    EXPECT_EQ(changed, 1u);
    EXPECT_NE(run(bounce).picture.rgba, fresh.picture.rgba);
}

// What a newer engine bakes in another way is not taken from an older one's folder.
TEST(OcclusionCacheVersion, GoesWithPatchesMapsAndTexels) {
    std::ostringstream facts;
    ValidatedRenderer renderer(Visibility::automatic);
    for (const Style style : {Style::spacefill, Style::ballAndStick, Style::licorice, Style::cartoon, Style::surface}) {
        const Representation r = scene("sample:dna", style);
        RenderSettings s = settings(r, 64, Projection::orthographic);
        s.occlusion.directions = 4;
        renderer->setScene(r);
        renderer->render(s);
        const OcclusionStats& bake = renderer->stats().occlusion;
        facts << bake.patchTexels << ' ' << bake.mapPixels << ' ' << bake.texels << "; ";
    }
    const std::string expected = "32 128 179766; 24 480 334832; 17 384 90802; 32 128 14744; 32 128 61516; ";
    EXPECT_EQ(facts.str(), expected) << "raise kOcclusionVersion, and write both here";
    EXPECT_EQ(kOcclusionVersion, 12u) << "write the facts of this version here";
}

INSTANTIATE_TEST_SUITE_P(Styles, OcclusionCache, testing::Values(Style::spacefill, Style::ballAndStick));

}  // namespace
}  // namespace nacre::test
