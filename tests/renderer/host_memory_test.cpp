// What a frame like the one before takes of the host's memory: operator new of the whole program counts.

#include <atomic>
#include <cstdlib>
#include <new>

#include "tests/renderer/scenes.h"

namespace {
std::atomic<std::uint64_t> allocations{0}, allocatedBytes{0};
}

// NOLINTBEGIN: the others of the standard library come to this one
void* operator new(std::size_t size) {
    ++allocations;
    allocatedBytes += size;
    if (void* memory = std::malloc(size)) return memory;
    throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
// NOLINTEND

namespace nacre::test {
namespace {

struct Taken {
    double allocations = 0, bytes = 0;  // a frame
};

/// Of frames of a turn, whose lists have grown to what they need before.
Taken takenByFrames(Renderer& renderer, const Representation& r) {
    constexpr int kTurn = 12;
    RenderSettings s = settings(r, 96, Projection::orthographic);
    s.occlusion.directions = 0;
    s.tuning.hideFrom = 0;
    const auto draw = [&] {
        for (int i = 0; i < kTurn; ++i) {
            Camera camera;
            camera.rotationDegrees.y = 360.0 * i / kTurn;
            s.view = viewOf(camera, r.radius, 96, 96);
            renderer.drawFrame(s);
        }
    };
    renderer.setScene(r);
    draw();
    draw();
    const std::uint64_t before = allocations, bytes = allocatedBytes;
    draw();
    return {static_cast<double>(allocations - before) / kTurn, static_cast<double>(allocatedBytes - bytes) / kTurn};
}

TEST(HostMemory, OfASteadyFrameIsLittleAndDoesNotGrowWithTheScene) {
    for (const Visibility path : {Visibility::fragdepth, Visibility::encoded, Visibility::tiles}) {
        Renderer renderer(DeviceOptions{false, "", path});
        const Taken small = takenByFrames(renderer, scene("sample:glucose", Style::spacefill));
        const Taken large = takenByFrames(renderer, scene("sample:dna", Style::spacefill));  // 20 times as many
        // The frame's graph, declared anew, and what its passes hold.
        EXPECT_LT(small.allocations, 100) << visibilityName(path);
        EXPECT_LT(large.allocations, small.allocations + 8) << visibilityName(path);
        EXPECT_LT(large.bytes, small.bytes + 4096) << visibilityName(path);
    }
}

}  // namespace
}  // namespace nacre::test
