#pragma once
// Self-test of a device: drivers can draw wrongly in ways that no feature flag reports. Each path draws spheres, sticks
// and triangles, whose pictures are compared with the expected ones. Correct paths are timed, and the result is kept
// for each device and driver. Pictures without a window wait for it. A window opens without it, and tests while idle.

#include <array>
#include <atomic>
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
    std::array<double, 3> milliseconds{};                  ///< per frame of scenes of three sizes, if right
    int tries = 0;                                         ///< unfinished attempts
    int subpasses = 0, carried = 0;                        ///< planned, and after merging by the driver; 0: unknown
    std::uint64_t transientBytes = 0, committedBytes = 0;  ///< of images that should stay on the tile
    /// One unfinished attempt may have any cause; two are blamed on the driver.
    bool known() const { return outcome != Outcome::unfinished || tries >= 2; }
    friend bool operator==(const PathResult&, const PathResult&) = default;
};

/// Paths in the order of the test.
using SelfTest = std::vector<PathResult>;

/// Tests each path of a device without a known result, and keeps the results. Before a path's device is made, a note is
/// written that it is being tested.
/// @param options  name the device; their window is ignored
/// @param stop  set by another thread: returns early, without the current path's result; may be null
SelfTest testPaths(const DeviceOptions& options, const DeviceInfo& device, const std::atomic<bool>* stop = nullptr);
/// Whether a device's paths are tested before one is chosen. Software devices need no test: the program's own tests
/// cover their paths.
bool wantsSelfTest(const DeviceOptions& options, const DeviceInfo& device);
/// Whether the device needs a test that has not run yet.
bool lacksSelfTest(const DeviceOptions& options, const DeviceInfo& device);
/// The kept results of a device; nothing if any path is missing. @param folder  DeviceOptions::selfTests
std::optional<SelfTest> keptSelfTest(const std::string& folder, const std::string& key);

/// Removes the kept results, so that the next start tests again.
void forgetSelfTest(const std::string& folder, const std::string& key);

/// The path of `automatic`: chosen by capabilities, unless it draws wrongly or another path takes less than four fifths
/// of its time for scenes of every size. @returns `automatic` if no path is right
graph::TestedPath choosePath(const SelfTest& test, Visibility byCaps, const std::string& whyByCaps);

/// "encoded 1.20 2.05 6.30 ms (3 subpasses as 1, 0 of 41 kB committed), fragdepth wrong"
std::string describe(const SelfTest& test);

/// Sets a device's `visibility`, `why` and `selfTest` from the kept results. Visibility "none": no path is right.
void addSelfTest(DeviceInfo& device, const std::string& folder);

}  // namespace nacre
