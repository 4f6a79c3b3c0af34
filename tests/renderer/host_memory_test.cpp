// What a frame like the one before takes of the host's memory, and which thread takes what: operator new of the whole
// program counts.

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <new>
#include <thread>

#include "tests/renderer/scenes.h"
#include "tests/support/newer_lavapipe.h"

namespace {
std::atomic<std::uint64_t> allocations{0};
thread_local std::size_t largestHere = 0;  // piece that this thread has taken
}  // namespace

// NOLINTBEGIN: the others of the standard library come to this one
void* operator new(std::size_t size) {
    ++allocations;
    largestHere = std::max(largestHere, size);
    if (void* memory = std::malloc(size)) return memory;
    throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
// NOLINTEND

namespace nacre::test {
namespace {

/// Pieces that frames of a turn take, after two turns by which lists have grown to what they need.
std::uint64_t takenByATurn(Renderer& renderer, RenderSettings s, double radius) {
    const auto turn = [&] {
        constexpr int kTurn = 5;
        for (int i = 0; i < kTurn; ++i) {
            Camera camera;
            camera.rotationDegrees.y = 360.0 * i / kTurn;
            s.view = makeView(camera, radius, 64, 64);
            renderer.drawFrame(s);
        }
    };
    turn();
    turn();
    const std::uint64_t before = allocations;
    turn();
    return allocations - before;
}

void expectNoneTaken() {
    for (const Visibility path :
         {Visibility::fragdepth, Visibility::encoded, Visibility::deferred, Visibility::tiles}) {
        Renderer renderer(DeviceOptions{false, "", path});
        for (const Style style : {Style::spacefill, Style::ballAndStick}) {
            const Representation r = scene("sample:dna", style);
            renderer.setScene(r);
            RenderSettings s = settings(r, 64, Projection::orthographic);
            s.occlusion.directions = 0;
            s.occlusion.cache = "a folder whose name is too long to fit into a string itself";
            s.occlusion.onProgress = [s](double) {};
            for (const std::uint32_t samples : {1u, RenderSettings::kEdges}) {
                // The others draw such a picture twice, and look at the first to see where the second has samples.
                if (samples == RenderSettings::kEdges && path != Visibility::tiles) continue;
                s.supersample = samples;
                EXPECT_EQ(takenByATurn(renderer, s, r.radius), 0u) << visibilityName(path) << ", " << samples;
            }
            s.effects.shadow.strength = 0.5;
            EXPECT_EQ(takenByATurn(renderer, s, r.radius), 0u) << visibilityName(path) << " with shadows";
        }
    }
}

TEST(HostMemory, ASteadyFrameTakesNone) { expectNoneTaken(); }

TEST(HostMemory, ASteadyFrameTakesNoneByDynamicRendering) {
    if (!NewerLavapipe::there()) GTEST_SKIP() << NewerLavapipe::kAbsent;
    const NewerLavapipe newer;
    ASSERT_TRUE(deviceInfo(DeviceOptions{}).localRead);
    expectNoneTaken();
}

/// Whoever works them out has all of them in one piece in the end.
TEST(HostMemory, WhichTexelsOfABakeAreOpenTheFramesThreadDoesNotWorkOut) {
    for (const Style style : {Style::spacefill, Style::ballAndStick}) {
        const Representation r = scene("sample:dna", style);
        Renderer renderer(DeviceOptions{});
        renderer.setScene(r);
        RenderSettings s = settings(r, 64, Projection::orthographic);
        s.occlusion.directions = 16;
        ASSERT_EQ(renderer.stats().occlusion.texels, 0u);
        largestHere = 0;
        for (int i = 0; i < 60'000 && renderer.stats().occlusion.texels == 0; ++i) {
            EXPECT_EQ(renderer.advanceOcclusion(s, OcclusionPace()), 0);
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        EXPECT_GT(renderer.stats().occlusion.texels, 10'000u);
        EXPECT_LT(largestHere, renderer.stats().occlusion.texels * sizeof(std::uint32_t));
    }
}

}  // namespace
}  // namespace nacre::test
