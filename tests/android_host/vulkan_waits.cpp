// What a test does and counts while the app waits for the device.

#include <atomic>
#include <mutex>
#include <utility>

#include "tests/android_host/vulkan.h"
#include "tests/android_host/vulkan_state.h"

namespace nacre::test {
namespace {

std::mutex waitsMutex;
std::function<void()> whileAwaited, whileMade;
std::atomic<int> fencesAwaited{0}, awaitedAtSubmission{0};

}  // namespace

void whileImagesAreAwaited(std::function<void()> happens) {
    const std::lock_guard lock(waitsMutex);
    whileAwaited = std::move(happens);
}

void whileDevicesAreMade(std::function<void()> happens) {
    const std::lock_guard lock(waitsMutex);
    whileMade = std::move(happens);
}

namespace {

void let(const std::function<void()>& what) {
    std::function<void()> happens;
    {
        const std::lock_guard lock(waitsMutex);
        happens = what;
    }
    if (happens) happens();
}

}  // namespace

void imageIsAwaited() { let(whileAwaited); }
void deviceIsMade() { let(whileMade); }

int fenceWaits() { return fencesAwaited; }
void fenceIsAwaited() { ++fencesAwaited; }
int fenceWaitsOfSubmission() { return awaitedAtSubmission; }
void commandsAreSubmitted() { awaitedAtSubmission = fencesAwaited.load(); }

}  // namespace nacre::test
