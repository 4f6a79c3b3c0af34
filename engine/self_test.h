#pragma once
// Self-test of a device: drivers can draw wrongly in ways that no feature flag reports. At the first start on a device
// and driver, each path draws a few spheres and sticks, which are compared with the expected picture. Right paths are
// timed, and the result is kept.

#include <optional>
#include <string>
#include <vector>

#include "engine/device_options.h"
#include "engine/graph/frame_caps.h"
#include "engine/results.h"

namespace nacre {

struct PathResult {
    enum class Outcome {
        right,
        wrong,       ///< different picture
        failed,      ///< an error
        unfinished,  ///< the program ended while drawing
    };
    Visibility visibility{};
    Outcome outcome{};
    double milliseconds = 0;                               ///< per frame, if right
    int tries = 0;                                         ///< unfinished attempts
    int subpasses = 0, carried = 0;                        ///< planned, and after merging by the driver; 0: unknown
    std::uint64_t transientBytes = 0, committedBytes = 0;  ///< of images that should stay on the tile
    /// One unfinished attempt may have any cause; two are blamed on the driver.
    bool known() const { return outcome != Outcome::unfinished || tries >= 2; }
    friend bool operator==(const PathResult&, const PathResult&) = default;
};

/// Paths in the order of the test.
using SelfTest = std::vector<PathResult>;

/// Tests each path of a device without a known result, and keeps the results.
/// @param options  name the device; their window is ignored. @param key  DeviceInfo::driverKey  @throws Error if there
/// is no device
/// @param every  also those that `automatic` takes by capabilities alone: tiles
SelfTest testPaths(const DeviceOptions& options, const std::string& key, bool every = false);
/// The kept results of a device; nothing if any path is missing. @param folder  DeviceOptions::selfTests
std::optional<SelfTest> keptSelfTest(const std::string& folder, const std::string& key);

/// Removes the kept results, so that the next start tests again.
void forgetSelfTest(const std::string& folder, const std::string& key);

/// The path of `automatic`: chosen by capabilities, unless it draws wrongly or another path takes less than four fifths
/// of its time.
graph::TestedPath choosePath(const SelfTest& test, Visibility byCaps, const std::string& whyByCaps);

/// "encoded 1.20 ms (3 subpasses as 1, 0 of 41 kB committed), fragdepth wrong"
std::string describe(const SelfTest& test);

/// Sets a device's `visibility`, `why` and `selfTest` from the kept results.
void addSelfTest(DeviceInfo& device, const std::string& folder);

}  // namespace nacre
