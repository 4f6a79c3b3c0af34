#pragma once
// One picture as `nacre render` makes it, in steps that others may share, or run beside the steps of other pictures.

#include <optional>
#include <string>
#include <vector>

#include "app/annotation/layout.h"
#include "app/cli/options.h"
#include "app/cli/progress.h"
#include "app/cli/stats.h"
#include "app/files/output_file.h"
#include "app/images/image_file.h"
#include "engine/milliseconds.h"
#include "engine/renderer.h"

namespace nacre::app {

/// A molecule as the options want it drawn: all that a renderer needs.
struct PreparedPicture {
    Representation scene;
    RenderSettings settings;
    PlacedWords words;
    RunStats run;  ///< as far as it is known by then
    /// How far the plane or the eye that depths count from stands behind that of the trajectory's first frame, Å:
    /// layers of all frames have one origin.
    double depthShift = 0;
};

/// How the options ask for the file to be written.
PictureFormat formatOf(const RenderOptions& options);

/// Needs no device. @param frame  as of sceneOf() @throws Error if nothing of the molecule is drawn
PreparedPicture preparePicture(const Molecule& molecule, const RenderOptions& options,
                               const std::optional<Bounds>& frame = {});

/// Writes the words into a picture in its full size. @returns the labels that found no room
/// @param memory  of pictures that follow each other
std::size_t addWords(const PreparedPicture& prepared, const RenderOptions& options, const RenderSettings& settings,
                     Picture& picture, WordMemory* memory = nullptr);

/// Makes the files that a picture's options ask for. Its steps are called in this order, each on whatever thread.
class PictureJob {
public:
    /// Makes the files at once, so that a folder that cannot be written to is refused before any work.
    /// @param options, progress  outlive this @throws Error
    PictureJob(const RenderOptions& options, Progress& progress);

    /// Reads the molecule and builds its scene. @throws Error
    void prepare();
    /// Draws all that is asked for: the device's only step. A picture that is not held whole is written meanwhile.
    /// @throws Error
    void draw(Renderer& renderer);
    /// Puts the files in their places. @throws Error
    void write();

    /// Of the scene: what is not as it was asked for. Known once it is prepared.
    const std::vector<std::string>& warnings() const { return warnings_; }

private:
    Picture drawPicture(Renderer& renderer);
    void drawInParts(Renderer& renderer);
    bool isCaptured(const Renderer& renderer) const;
    void sayCrowded(std::size_t labels) const;

    const RenderOptions& options_;
    Progress& progress_;
    Clock::time_point start_ = Clock::now();
    OutputFile pictureFile_;
    std::optional<OutputFile> layersFile_, statsFile_, captureFile_;
    PreparedPicture prepared_;
    std::vector<std::string> warnings_;
    Picture picture_;
    bool written_ = false;  ///< in parts, while it was drawn
    std::optional<LayerPicture> layers_;
    FrameStats frame_;
};

}  // namespace nacre::app
