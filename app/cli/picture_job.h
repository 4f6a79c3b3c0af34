#pragma once
// One picture as `nacre render` makes it, in steps that others may share, or run beside the steps of other pictures.

#include <optional>
#include <string>
#include <vector>

#include "app/cli/progress.h"
#include "app/cli/stats.h"
#include "app/drawing/drawing.h"
#include "app/files/output_file.h"
#include "app/images/image_file.h"
#include "engine/milliseconds.h"

namespace nacre::app {

/// Makes the files that a picture's options ask for. Its steps are called in this order, each on whatever thread.
class PictureJob {
public:
    /// Makes the files at once, so that a folder that cannot be written to is refused before any work.
    /// @param options, progress  outlive this @throws Error
    PictureJob(const PictureDescription& options, Progress& progress);

    /// Reads the molecule and builds its scene. @throws Error
    void prepare();
    /// Draws all that is asked for: the device's only step. A picture that is not held whole is written meanwhile.
    /// @throws Error
    void draw(Canvas& canvas);
    /// Puts the files in their places. @throws Error
    void write();

    /// Of the scene: what is not as it was asked for. Known once it is prepared.
    const std::vector<std::string>& warnings() const { return drawing_.warnings; }

private:
    Picture drawPicture(Renderer& renderer);
    void drawInParts(Renderer& renderer);
    bool isCaptured(const Renderer& renderer) const;
    void sayCrowded(std::size_t labels) const;

    const PictureDescription& options_;
    Progress& progress_;
    Clock::time_point start_ = Clock::now();
    OutputFile pictureFile_;
    std::optional<OutputFile> layersFile_, statsFile_, captureFile_;
    Drawing drawing_;
    Picture picture_;
    bool written_ = false;  ///< in parts, while it was drawn
    std::optional<LayerPicture> layers_;
    FrameStats frame_;
};

}  // namespace nacre::app
