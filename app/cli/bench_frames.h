#pragma once
// What `nacre bench` says about frames: by every path, and of the one in use what it submits and its floor.

#include <algorithm>
#include <iosfwd>

#include "app/cli/bench_occlusion.h"
#include "app/cli/options.h"
#include "app/cli/progress.h"

namespace nacre::app {

/// When to end the rounds of a part: as many as were asked for, or 20 and no more than some seconds hold.
class BenchRounds {
public:
    /// @param least  rounds, however long they take
    BenchRounds(const BenchOptions& options, int least) : options_(options), least_(least) {}
    /// @param round  counted from 0; what comes before warms up
    bool goesOn(int round) const {
        if (options_.frames) return round < *options_.frames;
        return round < kRounds && (round < least_ || spent_ < kMilliseconds);
    }
    void spend(double milliseconds) { spent_ += milliseconds; }
    double share(int round) const {
        const double done = std::max(round, 0) / static_cast<double>(options_.frames.value_or(kRounds));
        return options_.frames ? done : std::max(done, spent_ / kMilliseconds);
    }

private:
    static constexpr int kRounds = 20;
    static constexpr double kMilliseconds = 3'000;
    const BenchOptions& options_;
    int least_;
    double spent_ = 0;
};

/// The settings of a frame of a turn about the vertical axis. @param radius  of the scene @param frame  from 0
RenderSettings benchFrame(const BenchOptions& options, double radius, int frame);

/// Times frames by the paths that were asked for, and adds to a report `paths`, `lacks`, `times`, `floor` and counts.
/// @throws Error if the device lacks the one path that was asked for
void addFrames(const BenchOptions& options, const Representation& scene, Json& report, Progress& progress);

/// What addFrames found, as a table.
void printFrames(const Json& report, std::ostream& out);

}  // namespace nacre::app
