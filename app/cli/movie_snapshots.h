#pragma once
// The snapshots of a MolViewSpec scene as a movie: each lingers for its own time, then turns into the next: the
// camera moves, and the pictures cross-fade.

#include <memory>
#include <vector>

#include "app/cli/movie_options.h"
#include "app/cli/movie_scenes.h"
#include "app/cli/progress.h"
#include "app/download/load_scene.h"
#include "app/drawing/drawing.h"

namespace nacre::app {

/// Where a movie of snapshots is at a time.
struct SnapshotPlace {
    std::size_t from = 0;
    double share = 0;  ///< of the way to the next, 0 to 1
};

class SnapshotTimeline {
public:
    static constexpr double kLinger = 2;  ///< seconds, of each where none says how long
    /// @param loop  the last goes over into the first
    SnapshotTimeline(std::vector<SnapshotTimes> times, bool loop);

    double seconds() const { return seconds_; }
    /// @param time  0..seconds()
    SnapshotPlace at(double time) const;
    std::size_t count() const { return times_.size(); }

private:
    std::vector<SnapshotTimes> times_;
    double seconds_ = 0;
};

class MovieSnapshots : public MovieSource {
public:
    /// Reads the scene. @param options, progress  outlive this @throws Error
    MovieSnapshots(const MovieOptions& options, Progress& progress);

    std::uint64_t frames() const override { return frames_; }
    Picture draw(std::uint64_t frame) override;
    std::optional<int> modelOf(std::uint64_t frame) const override;

private:
    struct Shot {
        Molecule molecule;
        Drawing drawing;
        std::unique_ptr<Canvas> canvas;
        Lens lens;
    };
    SnapshotPlace placeOf(std::uint64_t frame) const;
    Shot& ready(std::size_t number);
    Picture drawFrom(std::size_t number, const Lens* lens);

    const MovieOptions& options_;
    Progress& progress_;
    OpenScene scene_;
    SnapshotTimeline timeline_;
    std::vector<std::unique_ptr<Shot>> shots_;  ///< null: not needed now
    std::uint64_t frames_ = 1;
    double secondsPerFrame_ = 0;  ///< of the snapshots' times
};

/// Whether a movie shows the snapshots of a scene: nothing else moves, and no snapshot is named.
bool showsSnapshots(const MovieOptions& options);

}  // namespace nacre::app
