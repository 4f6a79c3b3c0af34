// What a test does and counts while the app waits for the device.

#include <atomic>
#include <mutex>
#include <utility>

#include "tests/android_host/vulkan.h"
#include "tests/android_host/vulkan_state.h"

namespace nacre::test {
namespace {

std::mutex waitsMutex;
std::function<void()> whileAwaited;
std::atomic<int> fencesAwaited{0}, awaitedAtSubmission{0};

}  // namespace

void whileImagesAreAwaited(std::function<void()> happens) {
    const std::lock_guard lock(waitsMutex);
    whileAwaited = std::move(happens);
}

void imageIsAwaited() {
    std::function<void()> happens;
    {
        const std::lock_guard lock(waitsMutex);
        happens = whileAwaited;
    }
    if (happens) happens();
}

int fenceWaits() { return fencesAwaited; }
void fenceIsAwaited() { ++fencesAwaited; }
int fenceWaitsOfSubmission() { return awaitedAtSubmission; }
void commandsAreSubmitted() { awaitedAtSubmission = fencesAwaited.load(); }

}  // namespace nacre::test
