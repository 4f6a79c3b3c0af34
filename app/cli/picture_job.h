#pragma once
// One picture of `nacre render`, in steps that can run in parallel with those of other pictures.

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

class OpenScene;

/// Makes the files that a picture's options ask for. Call the steps in this order, each on any thread.
class PictureJob {
public:
    /// Creates the files at once, so that an unwritable folder is refused before any work.
    /// @param options, progress  outlive this @throws Error
    PictureJob(const PictureDescription& options, Progress& progress);

    /// Reads the molecule and builds its scene. @param scene  the INPUT, if it is open, else null @throws Error
    void prepare(OpenScene* scene = nullptr);
    /// Draws everything: the only step on the device. Also writes a picture that is too large to be held. @throws Error
    void draw(Canvas& canvas);
    /// Moves the files to their final names. @throws Error
    void write();

    /// Warnings of the scene: differences from the request. Known after prepare().
    const std::vector<std::string>& warnings() const { return drawing_.warnings; }

private:
    void drawPicture(Renderer& renderer);
    void drawInParts(Renderer& renderer);
    bool isCaptured(const Renderer& renderer) const;

    const PictureDescription& options_;
    Progress& progress_;
    Clock::time_point start_ = Clock::now();
    OutputFile pictureFile_;
    std::optional<OutputFile> layersFile_, statsFile_, captureFile_, viewFile_;
    Drawing drawing_;
    Picture picture_;
    std::optional<CodedPicture> codes_;  ///< instead of picture_
    std::vector<std::string> ofWords_;   ///< warnings about words
    bool written_ = false;               ///< in parts, during drawing
    std::optional<LayerPicture> layers_;
    FrameStats frame_;
};

}  // namespace nacre::app
