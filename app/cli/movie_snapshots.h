#pragma once
// The snapshots of a MolViewSpec scene as a movie. Each is shown for its own time, then the next one follows: the
// camera moves, and the pictures cross-fade.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/movie_options.h"
#include "app/cli/movie_scenes.h"
#include "app/cli/progress.h"
#include "app/download/load_scene.h"
#include "app/drawing/drawing.h"
#include "app/movie/camera_path.h"

namespace nacre::app {

/// Position in a movie of snapshots at a time.
struct SnapshotPlace {
    std::size_t from = 0;
    double share = 0;    ///< of the transition to the next, 0 to 1
    double seconds = 0;  ///< since the snapshot came to rest
};

/// The camera between two snapshots. @param trajectory  as named in a scene @param share  0..1 of the transition
/// @param height  of the picture, pixels
Lens lensBetween(const Lens& from, const Lens& to, const std::string& trajectory, double share, double height);

class SnapshotTimeline {
public:
    static constexpr double kLinger = 2;  ///< seconds per snapshot without a duration
    /// @param loop  the last one continues with the first
    SnapshotTimeline(std::vector<SnapshotTimes> times, bool loop);

    double seconds() const { return seconds_; }
    /// @param time  0..seconds()
    SnapshotPlace at(double time) const;
    std::size_t count() const { return times_.size(); }
    const SnapshotTimes& times(std::size_t snapshot) const { return times_[snapshot]; }
    /// Seconds of the animation of a snapshot; empty: it has none. @param seconds  since the snapshot came to rest
    std::optional<double> animationAt(std::size_t snapshot, double seconds) const;

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
    std::optional<int> shownModel(std::uint64_t frame) const override;

private:
    struct Shot {
        Molecule molecule;
        Drawing drawing;
        std::unique_ptr<Canvas> canvas;
        Lens lens;
        std::optional<double> seconds;  ///< of its animation
    };
    SnapshotPlace findPlace(std::uint64_t frame) const;
    /// @param seconds  since the snapshot came to rest
    Shot& ready(std::size_t number, double seconds);
    void load(std::size_t number, std::optional<double> seconds, Shot& shot);
    Picture drawFrom(std::size_t number, double seconds, const Lens* lens);
    double easedShare(const SnapshotPlace& place) const;

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
