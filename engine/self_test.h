#pragma once
// What a device draws right, found out by drawing: drivers of phones are wrong in ways that no feature tells. At the
// first start on a device and driver a few spheres and sticks are drawn by each path that may be taken there, and held
// against what they must look like; the right ones are timed. The answer is kept.

#include <optional>
#include <string>
#include <vector>

#include "engine/device_options.h"
#include "engine/results.h"

namespace nacre {

struct PathResult {
    enum class Outcome {
        right,
        wrong,       ///< another picture
        failed,      ///< an error
        unfinished,  ///< the program ended while it drew
    };
    Visibility visibility{};
    Outcome outcome{};
    double milliseconds = 0;         ///< of a frame, where it is right
    int tries = 0;                   ///< that were not finished
    int subpasses = 0, carried = 0;  ///< of its render pass by plan, and by the driver; 0: it does not tell
    std::uint64_t transientBytes = 0, committedBytes = 0;  ///< of images that never leave the tile by plan
    /// A program may be ended by anyone; twice at the same place it was the driver.
    bool known() const { return outcome != Outcome::unfinished || tries >= 2; }
    friend bool operator==(const PathResult&, const PathResult&) = default;
};

/// Paths in the order in which they were tried.
using SelfTest = std::vector<PathResult>;

/// Draws by each path that a device may take, unless it is known already, and keeps what comes out.
/// @param options  their device; not their window. @param key  DeviceInfo::driverKey  @throws Error if there is no
/// device
SelfTest testPaths(const DeviceOptions& options, const std::string& key);
/// What was kept of a device in DeviceOptions::selfTests; nothing if not all of it is known.
std::optional<SelfTest> keptSelfTest(const std::string& folder, const std::string& key);

/// So that it is tested anew.
void forgetSelfTest(const std::string& folder, const std::string& key);

struct TestedPath {
    Visibility visibility{};
    std::string why;
};
/// The path that `automatic` takes: the one that the device's caps choose, unless it does not draw right, or another
/// one takes less than four fifths of its time.
TestedPath choosePath(const SelfTest& test, Visibility byCaps, const std::string& whyByCaps);

/// "encoded 1.20 ms (3 subpasses as 1, 0 of 41 kB committed), fragdepth wrong"
std::string describe(const SelfTest& test);

/// Tells in a device's `visibility`, `why` and `selfTest` what was kept of it.
void addSelfTest(DeviceInfo& device, const std::string& folder);

}  // namespace nacre
